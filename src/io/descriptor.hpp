#pragma once
/// @file
/// An open file and its checked calls of the system.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace weavefront::io {

/// An open file, closed by the destructor. Every function throws FileError with the path and the reason.
class Descriptor {
  public:
    /// @param flags of `open`
    /// @param shown in messages in place of the path, for a file that will be renamed; empty: the path
    Descriptor(const std::string& path, int flags, const std::string& shown = {});
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] std::int64_t size() const;
    void read(std::span<std::byte> bytes, std::int64_t at) const;
    void write(std::span<const std::byte> bytes, std::int64_t at) const;
    /// Takes the room of the first `bytes` from the disk, which may not have it later.
    void reserve(std::int64_t bytes) const;
    /// Cuts it, or lengthens it by bytes that take no room until they are written.
    void resize(std::int64_t bytes) const;
    void sync() const;

  private:
    [[noreturn]] void fail(const char* doing, int cause) const;

    std::string path_;
    int number_;
};

}  // namespace weavefront::io
