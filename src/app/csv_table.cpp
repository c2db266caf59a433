#include "csv_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "weavefront/io/replace_file.hpp"

namespace weavefront::app {

CsvTable::CsvTable(std::string_view header) : text_(header) { text_ += '\n'; }

void CsvTable::add(std::span<const double> values) {
    const char* separator = "";
    for (const double value : values) {
        if (!std::isfinite(value)) throw std::runtime_error("a value of the table is not finite");
        fmt::format_to(std::back_inserter(text_), "{}{:.17g}", separator, value);
        separator = ",";
    }
    text_ += '\n';
}

void CsvTable::write(const std::filesystem::path& path) const { io::replace_file(path, text_); }

}  // namespace weavefront::app
