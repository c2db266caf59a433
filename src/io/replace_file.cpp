#include "weavefront/io/replace_file.hpp"

#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

void require_replaceable(const std::filesystem::path& path) { const NewFile removed_again(path); }

void replace_file(const std::filesystem::path& path, std::string_view text) {
    NewFile file(path);
    file.append(text);
    file.publish();
}

}  // namespace weavefront::io
