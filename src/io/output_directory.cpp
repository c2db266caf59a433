#include "weavefront/io/output_directory.hpp"

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

void prepare_output_directory(const std::filesystem::path& directory, const parallel::Communicator& comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] { create_writable(directory); });
    agreement.settle<FileError>();
}

}  // namespace weavefront::io
