#include "weavefront/study/text_table.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

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

TextTable read_table(const std::filesystem::path& path) {
    std::ifstream file(path);
    TextTable table;
    std::string line;
    if (!file || !std::getline(file, line)) throw std::runtime_error(fmt::format("{}: cannot be read, or is empty", path.string()));
    table.header = cells_of(line);
    while (std::getline(file, line)) {
        table.rows.push_back(cells_of(line));
        if (table.rows.back().size() != table.header.size())
            throw std::runtime_error(fmt::format("{}:{}: found {} cells, allowed {}", path.string(), table.rows.size() + 1,
                                                 table.rows.back().size(), table.header.size()));
    }
    return table;
}

}  // namespace weavefront::study
