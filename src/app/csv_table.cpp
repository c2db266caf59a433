#include "csv_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "weavefront/io/replace_file.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

CsvTable::CsvTable(std::string_view header) : header_(header), text_(header_ + '\n') {}

void CsvTable::add(std::span<const double> values, std::string_view cause) {
    ++rows_;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            throw scene::InputError({fmt::format(
                "{}: found values that make {} {}, allowed those of finite results",
                cause.empty() ? fmt::format("row {}", rows_) : std::string(cause),
                study::cells_of(header_)[i].text, std::isnan(values[i]) ? "undefined" : "infinite")});
        fmt::format_to(std::back_inserter(text_), "{}{:.17g}", i == 0 ? "" : ",", values[i]);
    }
    text_ += '\n';
}

void CsvTable::write(const std::filesystem::path& path) const { io::replace_file(path, text_); }

}  // namespace weavefront::app
