#include "study_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "shared_text.hpp"
#include "stop.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

/// Errors of this size are rounding: a repeat may give any other such.
constexpr double rounding = 1e-9;

struct Compared {
    std::string column;
    std::optional<double> tolerance;  ///< relative; none: the text must be the same
};

std::vector<Compared> compared_columns(const scene::Study& study) {
    std::vector<Compared> columns{{"outcome", std::nullopt}};
    for (const scene::Measure& measure : study.quantities) {
        if (!measure.tolerance) continue;
        if (measure.kind == scene::Measure::Kind::outcome)
            columns.push_back({measure.name, measure.tolerance});
        columns.push_back({measure.name + "_error", measure.tolerance});
    }
    return columns;
}

std::optional<std::size_t> column_of(const study::TextTable& table, const std::string& name) {
    const auto found = std::ranges::find(table.header, name);
    return found == table.header.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - table.header.begin()));
}

const std::vector<std::string>* row_of(const study::TextTable& table, const std::string& variant) {
    const auto found = std::ranges::find(table.rows, variant, [](const auto& row) { return row[0]; });
    return found == table.rows.end() ? nullptr : &*found;
}

/// Whether two cells agree within the tolerance of their column.
bool agree(const std::string& a, const std::string& b, const Compared& compared) {
    if (a == b) return true;
    const auto x = scene::finite_number(a), y = scene::finite_number(b);
    if (!compared.tolerance || !x || !y) return false;
    if (compared.column.ends_with("_error") && std::abs(*x) < rounding && std::abs(*y) < rounding)
        return true;
    return std::abs(*x - *y) <= *compared.tolerance * std::max(std::abs(*x), std::abs(*y));
}

void require_numbers(const study::TextTable& table, std::size_t column, const std::string& file,
                     std::vector<std::string>& findings) {
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const std::string& cell = table.rows[i][column];
        if (!cell.empty() && !scene::finite_number(cell))
            findings.push_back(fmt::format("{}:{}: {}: found '{}', allowed a number", file, i + 2,
                                           table.header[column], cell));
    }
}

}  // namespace

study::TextTable table_of_before(const scene::Study& study, std::span<const StudyEntry> entries,
                                 const std::filesystem::path& path, const parallel::Communicator& comm) {
    const std::string file = path.string();
    study::TextTable table = study::parse_table(shared_text(path, comm, scene::most_of_table), file);
    if (table.header.front() != "variant")
        throw scene::InputError({fmt::format(
            "{}: found the first column '{}', allowed the study.csv of a study, which begins with variant",
            file, table.header.front())});
    std::vector<std::string> findings;
    for (const Compared& compared : compared_columns(study)) {
        const auto column = column_of(table, compared.column);
        if (!column)
            findings.push_back(
                fmt::format("{}: no column {}, which the study compares", file, compared.column));
        else if (compared.tolerance)
            require_numbers(table, *column, file, findings);
    }
    for (const StudyEntry& entry : entries)
        if (row_of(table, entry.variant.name) == nullptr)
            findings.push_back(fmt::format("{}: no row of {}", file, entry.variant.name));
    if (!findings.empty()) throw scene::InputError(findings);
    return table;
}

void check_against_table(const scene::Study& study, const std::filesystem::path& table,
                         const study::TextTable& before, const std::filesystem::path& name, io::Log& log) {
    const study::TextTable now = study::read_table(table);
    std::vector<std::string> differences;
    for (const Compared& compared : compared_columns(study)) {
        const std::size_t here = column_of(now, compared.column).value(),
                          there = column_of(before, compared.column).value();
        for (const auto& row : now.rows) {
            const std::string& old = (*row_of(before, row[0]))[there];
            if (!agree(row[here], old, compared))
                differences.push_back(
                    fmt::format("{}: {} is {}, was {}", row[0], compared.column, row[here], old));
        }
    }
    if (!differences.empty())
        throw GuardStop(fmt::format("not as in {}: {}", name.string(), fmt::join(differences, "; ")));
    log.info(fmt::format("  as in         {}, within the study's tolerances", name.string()));
}

}  // namespace weavefront::app
