#include "weavefront/io/replace_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

std::filesystem::path unfinished(const std::filesystem::path& path) { return path.string() + ".new"; }

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    std::error_code none_there;
    std::filesystem::remove(unfinished(path), none_there);
    throw FileError(path.string() + " cannot be written: " + reason);
}

std::string reason_of(int cause) { return std::generic_category().message(cause); }

}  // namespace

void require_replaceable(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path)) refuse(path, reason_of(EISDIR));
    if (!std::ofstream(unfinished(path))) refuse(path, reason_of(errno));
    std::filesystem::remove(unfinished(path));
}

void replace_file(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(unfinished(path));
    file << text << std::flush;
    if (!file) refuse(path, reason_of(errno));
    file.close();
    std::error_code failure;
    std::filesystem::rename(unfinished(path), path, failure);
    if (failure) refuse(path, failure.message());
}

}  // namespace weavefront::io
