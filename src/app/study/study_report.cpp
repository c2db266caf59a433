#include "study_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

namespace {

/// Errors of this size are rounding: a repeat may give any other such.
constexpr double rounding = 1e-9;

std::optional<std::size_t> column_of(const study::TextTable& table, const std::string& name) {
    const auto found = std::ranges::find(table.header, name);
    return found == table.header.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - table.header.begin()));
}

/// Whether two cells agree within a relative tolerance; text must be the same.
bool agree(const std::string& a, const std::string& b, double tolerance, bool is_error) {
    if (a == b) return true;
    if (a.empty() || b.empty()) return false;
    const double x = std::stod(a), y = std::stod(b);
    if (is_error && std::abs(x) < rounding && std::abs(y) < rounding) return true;
    return std::abs(x - y) <= tolerance * std::max(std::abs(x), std::abs(y));
}

/// Two tables of one study.
class Comparison {
  public:
    Comparison(const study::TextTable& now, const study::TextTable& before) : now_(now), before_(before) {}

    void compare(const std::string& column, double tolerance) {
        const auto here = column_of(now_, column), there = column_of(before_, column);
        if (!here) return;
        for (const auto& row : now_.rows) {
            const auto same = std::ranges::find(before_.rows, row[0], [](const auto& other) { return other[0]; });
            if (same == before_.rows.end() || !there) {
                note(fmt::format("{}: no {} in the table of before", row[0], column));
            } else if (!agree(row[*here], (*same)[*there], tolerance, column.ends_with("_error"))) {
                note(fmt::format("{}: {} is {}, was {}", row[0], column, row[*here], (*same)[*there]));
            }
        }
    }

    [[nodiscard]] const std::vector<std::string>& differences() const { return differences_; }

  private:
    void note(const std::string& difference) {
        if (std::ranges::find(differences_, difference) == differences_.end()) differences_.push_back(difference);
    }

    const study::TextTable& now_;
    const study::TextTable& before_;
    std::vector<std::string> differences_;
};

}  // namespace

void report_study(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows, io::Log& log) {
    std::size_t width = 8;
    for (const StudyEntry& entry : entries) width = std::max(width, entry.variant.name.size());
    std::string header = fmt::format("{:<{}}  {:<8}", "variant", width, "outcome");
    for (const scene::Measure& measure : study.quantities)
        header += fmt::format("  {:>{}}", measure.name, std::max<std::size_t>(measure.name.size(), 11));
    log.info(header + "   (errors; values where there is no reference)");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string line = fmt::format("{:<{}}  {:<8}", entries[i].variant.name, width, rows[i].outcome);
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            const auto shown = rows[i].errors[q] ? rows[i].errors[q] : rows[i].values[q];
            line += fmt::format("  {:>{}}", shown ? fmt::format("{:.4g}", *shown) : "-",
                                std::max<std::size_t>(study.quantities[q].name.size(), 11));
        }
        log.info(line);
    }
}

void check_against_table(const scene::Study& study, const std::filesystem::path& table, const std::filesystem::path& before, io::Log& log) {
    const study::TextTable now = study::read_table(table), old = study::read_table(before);
    Comparison comparison(now, old);
    comparison.compare("outcome", 0);
    for (const scene::Measure& measure : study.quantities) {
        if (!measure.tolerance) continue;
        if (measure.kind == scene::Measure::Kind::outcome) comparison.compare(measure.name, *measure.tolerance);
        comparison.compare(measure.name + "_error", *measure.tolerance);
    }
    if (!comparison.differences().empty())
        throw GuardStop(fmt::format("not as in {}: {}", before.string(), fmt::join(comparison.differences(), "; ")));
    log.info(fmt::format("  as in         {}, within the study's tolerances", before.string()));
}

}  // namespace weavefront::app
