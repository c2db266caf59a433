#include "weavefront/io/replace_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

void replace_file(const std::filesystem::path& path, const std::string& text) {
    const std::filesystem::path unfinished = path.string() + ".new";
    std::ofstream file(unfinished);
    file << text << std::flush;
    if (!file) throw FileError(path.string() + " cannot be written: " + std::generic_category().message(errno));
    file.close();
    std::error_code failure;
    std::filesystem::rename(unfinished, path, failure);
    if (failure) throw FileError(path.string() + " cannot be written: " + failure.message());
}

}  // namespace weavefront::io
