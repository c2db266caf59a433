#include "output_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "weavefront/io/replace_file.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

void require_other_file(const char* option, const std::filesystem::path& file,
                        std::initializer_list<std::filesystem::path> read) {
    for (const auto& input : read) {
        std::error_code none_there;
        if (std::filesystem::equivalent(file, input, none_there))
            throw scene::InputError({fmt::format(
                "{}: found {}, which the command reads; allowed another file", option, file.string())});
    }
}

void require_output_file(const char* option, const std::filesystem::path& file,
                         std::initializer_list<std::filesystem::path> read) {
    require_other_file(option, file, read);
    io::require_replaceable(file);
}

}  // namespace weavefront::app
