#pragma once
/// @file
/// A file for readers that take a path.

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>

namespace weavefront::fuzz {

/// Exists until it is destroyed, in memory where the system has such a folder. Each process has one.
class ScratchFile {
  public:
    explicit ScratchFile(std::span<const std::byte> bytes) {
        std::ofstream file(path_, std::ios::binary | std::ios::trunc);
        file.write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
        if (!file.flush()) throw std::runtime_error(path_.string() + " cannot be written");
    }
    ~ScratchFile() { ::unlink(path_.c_str()); }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    static std::filesystem::path folder() {
        const std::filesystem::path in_memory = "/dev/shm";
        return std::filesystem::is_directory(in_memory) ? in_memory : std::filesystem::temp_directory_path();
    }
    std::filesystem::path path_ = folder() / ("weavefront_fuzz." + std::to_string(::getpid()));
};

}  // namespace weavefront::fuzz
