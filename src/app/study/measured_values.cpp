#include "measured_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>

#include "deformation_path.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

namespace {

using scene::Measure;

// Values that differ by more are hardly of one quantity: an inch is 25 mm, a foot a second 0.3 m/s.
constexpr double most_apart = 20;

/// The unit of a column of history.csv or of an outcome, by how its name begins.
std::string_view unit_of(std::string_view name) {
    using Unit = std::pair<std::string_view, std::string_view>;
    constexpr std::array units{Unit{"time", "s"},
                               Unit{"projectile_v", "m/s"},
                               Unit{"projectile_", "m"},
                               Unit{"contact_f", "N"},
                               Unit{"kinetic_", "J"},
                               Unit{"internal", "J"},
                               Unit{"hourglass", "J"},
                               Unit{"contact", "J"},
                               Unit{"friction", "J"},
                               Unit{"damping", "J"},
                               Unit{"external", "J"},
                               Unit{"eroded_elements", "1"},
                               Unit{"eroded", "J"},
                               Unit{"energy_error", "1"},
                               Unit{"broken_yarns", "1"},
                               Unit{"max_displacement", "m"},
                               Unit{"back_face_deflection", "m"},
                               Unit{"penetration_ply", "1"},
                               Unit{"penetration", "m"},
                               Unit{"debris_elements", "1"},
                               Unit{"debris_mass", "kg"},
                               Unit{"debris_displacement", "m"},
                               Unit{"residual_velocity", "m/s"},
                               Unit{"peak_displacement", "m"},
                               Unit{"absorbed_energy", "J"},
                               Unit{"strip_strain", "1"},
                               Unit{"strip_", "m/s"},
                               Unit{"strain", "1"},
                               Unit{"stress", "Pa"},
                               Unit{"h_fill", "m"},
                               Unit{"evaluations", "1"}};
    std::string plain(name);  // without the number of a projectile
    std::erase_if(plain, [](char c) { return c >= '0' && c <= '9'; });
    const auto known =
        std::ranges::find_if(units, [&](const Unit& unit) { return plain.starts_with(unit.first); });
    return known == units.end() ? "SI" : known->second;
}

std::string range_text(const ValueRange& range, std::string_view unit) {
    return range.least == range.most ? fmt::format("{:.6g} {}", range.least, unit)
                                     : fmt::format("{:.6g} to {:.6g} {}", range.least, range.most, unit);
}

ValueRange range_of(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    return {least, most};
}

/// When a variant begins and ends.
ValueRange time_of(const scene::Study& study, const scene::Case& variant) {
    if (study.compute == scene::Compute::yarn) return {0, variant.yarn.strain / variant.yarn.rate};
    if (study.compute == scene::Compute::impact) return {0, variant.scene.time.end};
    const auto path = read_deformation_path(variant.cell.path);
    return {path.front().time, path.back().time};
}

/// The values of a column that are there, over time.
study::Curve curve_of(const study::Columns& columns, const std::string& name) {
    study::Curve curve;
    const auto &time = columns.at("time"), &values = columns.at(name);
    for (std::size_t k = 0; k < time.size(); ++k) {
        if (std::isnan(time[k]) || std::isnan(values[k])) continue;
        curve.time.push_back(time[k]);
        curve.value.push_back(values[k]);
    }
    return curve;
}

std::ptrdiff_t values_between(const study::Curve& curve, double begin, double end) {
    return std::ranges::count_if(curve.time, [&](double t) { return t >= begin && t <= end; });
}

bool is_compared(const Measure& measure, const study::Columns& columns, Measure::Kind kind) {
    return measure.kind == kind && columns.contains(measure.of);
}

class Reader {
  public:
    Reader(const scene::Study& study, std::span<const StudyEntry> entries, const std::string& text)
        : study_(study),
          entries_(entries),
          name_(study.reference.file.string()),
          columns_(study::parse_columns(text, name_)) {
        for (const auto& cell : study::cells_of(std::string_view(text).substr(0, text.find('\n'))))
            header_.push_back(cell);
    }

    study::Columns read() {
        refuse_unknown();
        findings_.raise();
        for (const Measure& measure : study_.quantities) {
            if (is_compared(measure, columns_, Measure::Kind::history)) check_times();
            if (is_compared(measure, columns_, Measure::Kind::outcome) &&
                (columns_.at(measure.of).empty() || std::isnan(columns_.at(measure.of).front())))
                report(measure.of, "found nothing in the first row below the header, allowed is the outcome");
        }
        findings_.raise();
        for (const Measure& measure : study_.quantities)
            if (is_compared(measure, columns_, Measure::Kind::history)) check_overlap(measure.of);
        findings_.raise();
        return std::move(columns_);
    }

  private:
    void report(const std::string& column, const std::string& what) {
        const auto cell = std::ranges::find(header_, column, &study::Cell::text);
        findings_.add(
            fmt::format("{}:1:{}: {}: {}", name_, cell == header_.end() ? 1 : cell->column, column, what));
    }

    void refuse_unknown() {
        std::vector<std::string> allowed{"time"};
        for (const Measure& measure : study_.quantities)
            if (measure.kind != Measure::Kind::field) allowed.push_back(measure.of);
        for (const auto& [column, place] : header_) {
            if (std::ranges::find(allowed, column) != allowed.end()) continue;
            const std::string hint = scene::nearest(column, allowed);
            findings_.add(
                fmt::format("{}:1:{}: found column '{}', allowed is what the study compares, over time: {}{}",
                            name_, place, scene::printable(column), fmt::join(allowed, ", "),
                            hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint)));
        }
    }

    void check_times() {
        if (times_checked_) return;
        times_checked_ = true;
        const auto time = columns_.find("time");
        const bool ascends = time != columns_.end() &&
                             std::ranges::none_of(time->second, [](double t) { return std::isnan(t); }) &&
                             std::ranges::is_sorted(time->second, std::less_equal<>());
        if (!ascends)
            report("time", "a history is compared with it, which takes a column 'time' that ascends, s");
    }

    void check_overlap(const std::string& column) {
        const auto curve = curve_of(columns_, column);
        if (curve.time.size() < 2)
            return report(column, fmt::format("found {} value{}, allowed are two or more", curve.time.size(),
                                              curve.time.empty() ? "s" : ""));
        for (const StudyEntry& entry : entries_) {
            const auto [begin, end] = time_of(study_, entry.input);
            const auto shared = values_between(curve, begin, end);
            if (shared >= 2) continue;
            return report(
                column,
                fmt::format(
                    "found values at {}, of which {} at the times of {}, {}; allowed are two or more of them",
                    range_text({curve.time.front(), curve.time.back()}, "s"), shared, entry.variant.name,
                    range_text({begin, end}, "s")));
        }
    }

    const scene::Study& study_;
    std::span<const StudyEntry> entries_;
    std::string name_;
    study::Columns columns_;
    std::vector<study::Cell> header_;
    bool times_checked_ = false;
    scene::MessageList findings_;
};

}  // namespace

study::Columns read_measured(const scene::Study& study, std::span<const StudyEntry> entries,
                             const std::string& text) {
    return Reader(study, entries, text).read();
}

void report_measured(const scene::Study& study, std::span<const StudyEntry> entries,
                     const study::Columns& columns, io::Log& log) {
    if (columns.empty()) return;
    const auto [begin, end] = time_of(study, entries.front().input);
    for (const Measure& measure : study.quantities) {
        if (is_compared(measure, columns, Measure::Kind::outcome))
            log.info(fmt::format("  measured      {}: {:.6g} {}", measure.of, columns.at(measure.of).front(),
                                 unit_of(measure.of)));
        if (!is_compared(measure, columns, Measure::Kind::history)) continue;
        const auto curve = curve_of(columns, measure.of);
        log.info(fmt::format("  measured      {}: {} values of {} at {}; {} of them at the times of {}, {}",
                             measure.of, curve.time.size(),
                             range_text(range_of(curve.value), unit_of(measure.of)),
                             range_text(range_of(curve.time), "s"), values_between(curve, begin, end),
                             entries.front().variant.name, range_text({begin, end}, "s")));
        if ((curve.time.back() - curve.time.front()) > most_apart * (end - begin))
            log.warn(
                fmt::format("{} was measured over {:.3g} times the time of the run: another unit than s?",
                            measure.of, (curve.time.back() - curve.time.front()) / (end - begin)));
    }
}

void report_compared(const scene::Study& study, std::span<const StudyRow> rows, const study::Columns& columns,
                     io::Log& log) {
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
        const Measure& measure = study.quantities[q];
        if (!columns.contains(measure.of) || measure.kind == Measure::Kind::field) continue;
        std::vector<double> computed;
        for (const StudyRow& row : rows) {
            if (row.history[q])
                computed.insert(computed.end(), {row.history[q]->least, row.history[q]->most});
            if (row.values[q]) computed.push_back(*row.values[q]);
        }
        if (computed.empty()) continue;
        const bool outcome = measure.kind == Measure::Kind::outcome;
        const auto here = range_of(computed);
        const auto there = outcome
                               ? ValueRange{columns.at(measure.of).front(), columns.at(measure.of).front()}
                               : range_of(curve_of(columns, measure.of).value);
        log.info(fmt::format("  compared      {}: measured {}, computed {}", measure.of,
                             range_text(there, unit_of(measure.of)), range_text(here, unit_of(measure.of))));
        const auto size = [](const ValueRange& range) {
            return std::max(std::abs(range.least), std::abs(range.most));
        };
        if (size(here) > 0 && size(there) > 0 &&
            std::max(size(here) / size(there), size(there) / size(here)) > most_apart)
            log.warn(
                fmt::format("measured values of {} are {:.3g} times the computed ones: another unit than {}?",
                            measure.of, size(there) / size(here), unit_of(measure.of)));
    }
}

}  // namespace weavefront::app
