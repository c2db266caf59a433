#include "csv_table.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

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

void CsvTable::write(const std::filesystem::path& path) const {
    const std::filesystem::path unfinished = path.string() + ".new";
    std::ofstream file(unfinished);
    file << text_ << std::flush;
    if (!file) throw std::runtime_error(fmt::format("{} cannot be written: {}", path.string(), std::generic_category().message(errno)));
    file.close();
    std::error_code failure;
    std::filesystem::rename(unfinished, path, failure);
    if (failure) throw std::runtime_error(fmt::format("{} cannot be written: {}", path.string(), failure.message()));
}

}  // namespace weavefront::app
