#include "weavefront/study/text_table.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "weavefront/scene/read.hpp"

namespace weavefront::study {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
        if (doubled) ++i;
        if (line[i] == '"' && !doubled)
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            cells.emplace_back();
        else if (line[i] != '\r')
            cells.back() += line[i];
    }
    return cells;
}

TextTable read_table(const std::filesystem::path& path) { return parse_table(scene::read_text(path), path.string()); }

TextTable parse_table(const std::string& text, const std::string& name) {
    std::istringstream lines(text);
    TextTable table;
    std::string line;
    if (!std::getline(lines, line)) throw std::runtime_error(fmt::format("{}: empty, allowed a header and rows", name));
    table.header = cells_of(line);
    while (std::getline(lines, line)) {
        table.rows.push_back(cells_of(line));
        if (table.rows.back().size() != table.header.size())
            throw std::runtime_error(fmt::format("{}:{}: found {} cells, allowed {}", name, table.rows.size() + 1, table.rows.back().size(),
                                                 table.header.size()));
    }
    return table;
}

}  // namespace weavefront::study
