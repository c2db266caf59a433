#include "weavefront/study/text_table.hpp"

#include <fmt/format.h>

#include <sstream>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::study {

std::vector<Cell> cells_of(std::string_view line) {
    std::vector<Cell> cells(1, {"", 1});
    bool quoted = false;
    std::size_t column = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if ((static_cast<unsigned char>(line[i]) & 0xC0U) != 0x80) ++column;
        const bool doubled = quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
        if (doubled) ++i, ++column;
        if (line[i] == '"' && !doubled) {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            cells.push_back({"", column + 1});
        } else {
            // Blanks before the first character belong to nobody.
            if (cells.back().text.empty() && scene::blank_at_start(line.substr(i)) > 0) {
                i += scene::blank_at_start(line.substr(i)) - 1;
                cells.back().column = column + 1;
                continue;
            }
            cells.back().text += line[i];
        }
    }
    for (Cell& cell : cells) cell.text = scene::trimmed(cell.text);
    return cells;
}

TextTable read_table(const std::filesystem::path& path) {
    return parse_table(scene::read_text(path, scene::most_of_table), path.string());
}

TextTable parse_table(const std::string& text, const std::string& name) {
    const auto texts_of = [](const std::string& line) {
        std::vector<std::string> texts;
        for (Cell& cell : cells_of(line)) texts.push_back(std::move(cell.text));
        return texts;
    };
    std::istringstream lines(text);
    TextTable table;
    std::string line;
    if (!std::getline(lines, line))
        throw scene::InputError({fmt::format("{}:1:1: found nothing, allowed a header and rows", name)});
    table.header = texts_of(line);
    while (std::getline(lines, line)) {
        table.rows.push_back(texts_of(line));
        if (table.rows.back().size() != table.header.size())
            throw scene::InputError(
                {fmt::format("{}:{}:1: found {} cells, allowed {}", name, table.rows.size() + 1,
                             table.rows.back().size(), table.header.size())});
    }
    return table;
}

}  // namespace weavefront::study
