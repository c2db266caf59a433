#pragma once
/// @file
/// A directory for one test, the same on all ranks.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Made by rank 0 at construction and removed by it at the end.
class ScratchDirectory {
  public:
    /// @note Collective
    explicit ScratchDirectory(const parallel::Communicator& comm) : comm_(comm) {
        std::string path = (std::filesystem::temp_directory_path() / "weavefront.XXXXXX").string();
        if (comm.rank() == 0 && ::mkdtemp(path.data()) == nullptr) path.clear();
        path_ = comm.broadcast(path);
    }
    ~ScratchDirectory() {
        std::error_code ignored;
        if (comm_.rank() == 0) std::filesystem::remove_all(path_, ignored);
    }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    const parallel::Communicator& comm_;
    std::filesystem::path path_;
};

/// The text of a file.
inline std::string content(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// What an action throws as `Error`; empty when it throws none.
template <class Error, class Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace weavefront::io
