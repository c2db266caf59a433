#include "weavefront/io/output_directory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "agreement.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

void create_writable(const std::filesystem::path& directory) {
    std::error_code failure;
    std::filesystem::create_directories(directory, failure);
    if (failure) throw FileError("output directory " + directory.string() + " cannot be created: " + failure.message());
    if (!std::filesystem::is_directory(directory)) throw FileError("output directory " + directory.string() + " is not a directory");
    if (::access(directory.c_str(), W_OK | X_OK) != 0)
        throw FileError("output directory " + directory.string() + " cannot be written to: " + std::generic_category().message(errno));
}

}  // namespace

OutputDirectory::OutputDirectory(const std::filesystem::path& path, const parallel::Communicator& comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        create_writable(path);
        lock_ = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(lock_);
            throw FileError("output directory " + path.string() + " is in use by another run");
        }
        replaces_ = std::filesystem::remove(path / "summary.json");
    });
    agreement.settle<FileError>();
}

OutputDirectory::~OutputDirectory() {
    if (lock_ >= 0) ::close(lock_);
}

}  // namespace weavefront::io
