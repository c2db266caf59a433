#include "weavefront/io/new_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw FileError(fmt::format("{} cannot be written: {}", path.string(), reason));
}

std::string reason_of(int cause) { return std::generic_category().message(cause); }

const char* kind_of(mode_t mode) {
    if (S_ISLNK(mode)) return "link";
    if (S_ISDIR(mode)) return "folder";
    if (S_ISFIFO(mode)) return "FIFO";
    return S_ISSOCK(mode) ? "socket" : "device";
}

int create(const std::filesystem::path& path) {
    require_regular_or_missing(path);
    const auto name = temporary_name(path);
    const int descriptor =
        ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST)
        refuse(path,
               name.string() +
                   " is in the way, which a program that was killed has left, or somebody else: remove it");
    if (descriptor < 0) refuse(path, reason_of(errno));
    return descriptor;
}

}  // namespace

std::filesystem::path temporary_name(const std::filesystem::path& path) { return path.string() + ".new"; }

void require_regular_or_missing(const std::filesystem::path& path) {
    struct stat found {};
    if (::lstat(path.c_str(), &found) != 0) {
        if (errno != ENOENT) refuse(path, reason_of(errno));
    } else if (!S_ISREG(found.st_mode)) {
        refuse(path, fmt::format("it is a {}, allowed is a regular file or none", kind_of(found.st_mode)));
    }
}

void publish_file(const std::filesystem::path& path) {
    require_regular_or_missing(path);
    if (::rename(temporary_name(path).c_str(), path.c_str()) != 0) refuse(path, reason_of(errno));
}

bool is_in_place(int descriptor, const std::filesystem::path& path) {
    struct stat opened {
    }, found{};
    const bool is_there = ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &found) == 0;
    return is_there && opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

void require_in_place(int descriptor, const std::filesystem::path& path) {
    if (!is_in_place(descriptor, path))
        throw FileError(
            fmt::format("{} is no longer there: the file or its folder was moved, removed or replaced while "
                        "the run wrote to it",
                        path.string()));
}

NewFile::NewFile(const std::filesystem::path& path) : path_(path), descriptor_(create(path)) {}

std::unique_ptr<NewFile> NewFile::appended_to(const std::filesystem::path& path) {
    require_regular_or_missing(path);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_APPEND | O_CLOEXEC);
    if (descriptor < 0) refuse(path, reason_of(errno));
    return std::unique_ptr<NewFile>(new NewFile(path, descriptor));
}

NewFile::~NewFile() {
    ::close(descriptor_);
    if (!is_published_) ::unlink(temporary_name(path_).c_str());
}

void NewFile::append(std::string_view text) const {
    for (std::size_t done = 0; done < text.size();) {
        const auto wrote = ::write(descriptor_, text.data() + done, text.size() - done);
        if (wrote < 0 && errno != EINTR) {
            take_back(done);
            fail();
        }
        if (wrote > 0) done += static_cast<std::size_t>(wrote);
    }
}

void NewFile::take_back(std::size_t part) const {
    const int cause = errno;
    const auto end = ::lseek(descriptor_, 0, SEEK_END);
    if (part > 0 && end >= 0 && ::ftruncate(descriptor_, end - static_cast<off_t>(part)) != 0) fail();
    errno = cause;
}

void NewFile::cut(std::int64_t bytes) const {
    if (::ftruncate(descriptor_, bytes) != 0) fail();
}

void NewFile::sync() const {
    if (::fsync(descriptor_) != 0) fail();
}

void NewFile::publish() {
    if (is_published_) return;
    publish_file(path_);
    is_published_ = true;
}

void NewFile::require_in_place() const { io::require_in_place(descriptor_, path_); }

void NewFile::fail() const { refuse(path_, reason_of(errno)); }

}  // namespace weavefront::io
