#pragma once
/// @file
/// Files that appear under their names when they are whole.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace weavefront::io {

/// Name beside its place under which a file is written until it is whole.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Makes sure that `path` is a regular file or nothing. Links, devices and FIFOs are never followed, opened
/// or replaced.
/// @throws FileError naming what it is
void require_regular_or_missing(const std::filesystem::path& path);

/// Gives a file that was written under its temporary name its own, in place of a regular file or nothing.
/// @throws FileError
void publish_file(const std::filesystem::path& path);

/// An open text file under its temporary name; one process.
class NewFile {
  public:
    /// Creates it. @throws FileError, also where a file of the temporary name is there
    explicit NewFile(const std::filesystem::path& path);
    /// Goes on with a file that is there under its own name. @throws FileError
    static std::unique_ptr<NewFile> appended_to(const std::filesystem::path& path);
    /// Removes it unless it was published.
    ~NewFile();
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Adds text in one call to the system, which no stream promises. @throws FileError; then nothing of the
    /// text is left in the file
    void append(std::string_view text) const;
    /// Gives the file its own name; it stays open. @throws FileError
    void publish();
    /// Takes away all that is beyond its first bytes. @throws FileError
    void cut(std::int64_t bytes) const;
    /// Waits until it is on the disk. @throws FileError
    void sync() const;
    /// @throws FileError when its name no longer leads to the published file: its folder was moved or removed
    void require_in_place() const;

  private:
    NewFile(const std::filesystem::path& path, int descriptor)
        : path_(path), descriptor_(descriptor), is_published_(true) {}
    void take_back(std::size_t part) const;
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    int descriptor_;
    bool is_published_ = false;
};

/// Whether `path` leads to the file behind an open descriptor.
bool is_in_place(int descriptor, const std::filesystem::path& path);

/// Makes sure of it. @throws FileError
void require_in_place(int descriptor, const std::filesystem::path& path);

}  // namespace weavefront::io
