#include "descriptor.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

Descriptor::Descriptor(const std::string& path, int flags, const std::string& shown)
    : path_(shown.empty() ? path : shown), number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) fail("opened", errno);
}

Descriptor::~Descriptor() { ::close(number_); }

std::int64_t Descriptor::size() const {
    struct stat found {};
    if (::fstat(number_, &found) != 0) fail("read", errno);
    return found.st_size;
}

void Descriptor::read(std::span<std::byte> bytes, std::int64_t at) const {
    while (!bytes.empty()) {
        const auto got = ::pread(number_, bytes.data(), bytes.size(), at);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail("read", errno);
        if (got == 0) throw FileError(fmt::format("{} is cut at {} bytes", path_, at));
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        at += got;
    }
}

void Descriptor::write(std::span<const std::byte> bytes, std::int64_t at) const {
    while (!bytes.empty()) {
        const auto written = ::pwrite(number_, bytes.data(), bytes.size(), at);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("written", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        at += written;
    }
}

void Descriptor::reserve(std::int64_t bytes) const {
    int cause = EINTR;
    while (cause == EINTR) cause = ::posix_fallocate(number_, 0, bytes);
    if (cause != 0) fail("written", cause);
}

void Descriptor::resize(std::int64_t bytes) const {
    if (::ftruncate(number_, bytes) != 0) fail("written", errno);
}

void Descriptor::sync() const {
    if (::fsync(number_) != 0) fail("written", errno);
}

void Descriptor::fail(const char* doing, int cause) const {
    throw FileError(fmt::format("{} cannot be {}: {}", path_, doing, std::generic_category().message(cause)));
}

}  // namespace weavefront::io
