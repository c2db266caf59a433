#include "shot_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "csv_cell.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

namespace {

constexpr std::string_view header =
    "shot,variant,speed_m_s,speed_ft_s,result,residual_m_s,residual_ft_s,back_face_deflection_mm,"
    "plies_perforated,absorbed_energy_J,energy_error,outcome,folder";
constexpr std::string_view of_range = "range";

std::string cell(const std::optional<double>& value, double unit = 1) {
    return value ? fmt::format("{:.8g}", *value / unit) : "";
}

std::string_view name_of(ballistics::Result result) {
    if (result == ballistics::Result::none) return "none";
    return result == ballistics::Result::complete ? "complete" : "partial";
}

void write_row(std::string& text, const V50Plan& plan, const ShotRow& row) {
    // What a stopped projectile has left is no residual velocity of a range.
    const auto residual = row.result == ballistics::Result::complete ? row.residual : std::nullopt;
    fmt::format_to(
        std::back_inserter(text), "{},{},{:.2f},{:.2f},{},{},{},{},{},{},{},{},{}", row.number,
        quoted_cell(plan.variants[row.variant].label), row.speed, row.speed / foot_per_second,
        row.is_done ? name_of(row.result) : "", cell(residual), cell(residual, foot_per_second),
        cell(row.deflection, 1e-3), row.plies_perforated ? std::to_string(*row.plies_perforated) : "",
        cell(row.absorbed_energy), cell(row.energy_error), quoted_cell(row.outcome), quoted_cell(row.folder));
    for (const auto& law : plan.scatter) {
        const auto setting = ballistics::drawn_setting(law, plan.seed, row.number);
        fmt::format_to(std::back_inserter(text), ",{}", quoted_cell(setting.substr(law.path.size() + 1)));
    }
    text += '\n';
}

void require_table(const study::TextTable& table, const std::string& name) {
    const auto first = fmt::format("{}", fmt::join(table.header, ","));
    if (!first.starts_with(header))
        throw scene::InputError(
            {fmt::format("{}:1:1: found the columns {}, allowed those of a v50.csv: --overwrite "
                         "replaces it",
                         name, scene::printable(first))});
}

}  // namespace

std::string shot_table(const V50Plan& plan, std::span<const ShotRow> rows) {
    std::string text(header);
    for (const auto& law : plan.scatter) text += fmt::format(",{}", quoted_cell(law.path));
    text += '\n';
    for (const auto& row : rows) write_row(text, plan, row);
    for (const auto& [shot, where] : plan.range_shots) {
        text +=
            fmt::format(",{},{:.8g},{:.8g},{},,,,,,,,{}", of_range, shot.speed, shot.speed / foot_per_second,
                        shot.is_complete ? "complete" : "partial", quoted_cell(where));
        text.append(plan.scatter.size(), ',');
        text += '\n';
    }
    return text;
}

std::vector<ShotRow> planned_shots(const V50Plan& plan, const std::string& text, const std::string& name) {
    const auto table = study::parse_table(text, name);
    require_table(table, name);
    std::vector<ShotRow> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto& cells = table.rows[i];
        if (cells[1] == of_range) continue;
        const auto variant = std::ranges::find(plan.variants, cells[1], &V50Variant::label);
        const auto speed = scene::finite_number(cells[2]);
        if (variant == plan.variants.end())
            throw scene::InputError(
                {fmt::format("--restart: {}:{}: found a shot of '{}', which these options do not ask for",
                             name, i + 2, scene::printable(cells[1]))});
        if (!speed || cells[0] != std::to_string(i + 1))
            throw scene::InputError({fmt::format(
                "--restart: {}:{}: found '{},{},{}', allowed the row of shot {}", name, i + 2,
                scene::printable(cells[0]), scene::printable(cells[1]), scene::printable(cells[2]), i + 1)});
        const int number = static_cast<int>(i + 1);
        ShotRow row;
        row.number = number;
        row.variant = static_cast<std::size_t>(variant - plan.variants.begin());
        row.speed = ballistics::rounded_speed(*speed);
        row.folder = folder_of_shot(number, row.speed);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace weavefront::app
