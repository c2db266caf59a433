#include "range_shots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string_view>
#include <variant>

#include "speed_unit.hpp"
#include "weavefront/scene/quantity.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

namespace {

constexpr std::array<std::string_view, 3> speed_columns{"speed_m_s", "speed_ft_s", "speed"};

/// Which column holds what.
struct Layout {
    std::size_t speed = 0, result = 0;
    std::optional<std::size_t> variant;  ///< of a v50.csv
    std::optional<double> unit;          ///< of the speeds, m/s; none: in each cell
};

Layout layout_of(const std::vector<study::Cell>& header, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& cell : header) names.push_back(cell.text);
    const auto place = [&](std::string_view column) {
        return std::ranges::find(names, column) - names.begin();
    };
    Layout layout;
    const auto found =
        std::ranges::find_if(speed_columns, [&](auto column) { return place(column) < std::ssize(names); });
    if (found == speed_columns.end())
        throw scene::InputError(
            {fmt::format("{}:1:1: found no column of speeds, allowed speed_m_s, speed_ft_s, or "
                         "speed with the unit in each cell",
                         name)});
    if (place("result") == std::ssize(names))
        throw scene::InputError(
            {fmt::format("{}:1:1: found no column result, allowed one of complete and partial", name)});
    layout.speed = static_cast<std::size_t>(place(*found));
    layout.result = static_cast<std::size_t>(place("result"));
    if (place("variant") < std::ssize(names)) layout.variant = static_cast<std::size_t>(place("variant"));
    if (*found == "speed_m_s") layout.unit = 1;
    if (*found == "speed_ft_s") layout.unit = foot_per_second;
    return layout;
}

/// @return the speed in m/s, or what is wrong with the cell
std::variant<double, std::string> speed_in(const std::string& text, const Layout& layout) {
    if (layout.unit) {
        const auto number = scene::finite_number(text);
        if (number && *number > 0) return *number * *layout.unit;
        return fmt::format("found '{}', allowed a number above 0", scene::printable(text));
    }
    const auto speed = scene::speed_of(text);
    if (const auto* problem = std::get_if<std::string>(&speed)) return *problem + ", such as '358 m/s'";
    if (std::get<scene::WrittenSpeed>(speed).si > 0) return std::get<scene::WrittenSpeed>(speed).si;
    return fmt::format("found '{}', allowed a velocity above 0", scene::printable(text));
}

}  // namespace

std::vector<RangeShot> parse_range_shots(const std::string& text, const std::string& name) {
    std::istringstream lines(text);
    std::string line;
    if (!std::getline(lines, line))
        throw scene::InputError({fmt::format("{}:1:1: found nothing, allowed a header and shots", name)});
    const auto header = study::cells_of(line);
    const Layout layout = layout_of(header, name);
    std::vector<RangeShot> shots;
    scene::MessageList findings;
    for (int number = 2; std::getline(lines, line); ++number) {
        if (scene::trimmed(line).empty()) continue;
        const auto cells = study::cells_of(line);
        if (cells.size() != header.size()) {
            findings.add(fmt::format("{}:{}:1: found {} cells, allowed {}", name, number, cells.size(),
                                     header.size()));
            continue;
        }
        const auto& result = cells[layout.result];
        if (result.text.empty() || result.text == "none") continue;
        if (layout.variant && cells[*layout.variant].text != "scene" &&
            cells[*layout.variant].text != "range")
            continue;
        if (result.text != "complete" && result.text != "partial")
            findings.add(fmt::format("{}:{}:{}: result: found '{}', allowed complete or partial", name,
                                     number, result.column, scene::printable(result.text)));
        const auto speed = speed_in(cells[layout.speed].text, layout);
        if (const auto* problem = std::get_if<std::string>(&speed))
            findings.add(fmt::format("{}:{}:{}: {}: {}", name, number, cells[layout.speed].column,
                                     header[layout.speed].text, *problem));
        else
            shots.push_back(
                {{std::get<double>(speed), result.text == "complete"}, fmt::format("{}:{}", name, number)});
    }
    findings.raise();
    if (shots.empty())
        throw scene::InputError(
            {fmt::format("{}:1:1: found no shot with a result, allowed at least one", name)});
    return shots;
}

}  // namespace weavefront::app
