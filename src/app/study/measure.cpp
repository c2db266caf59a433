#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "field_distance.hpp"
#include "variant_results.hpp"
#include "weavefront/fabric/constants.hpp"
#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/study/closed_forms.hpp"

namespace weavefront::app {

namespace {

using scene::Measure;
using scene::Reference;

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> relative(std::optional<double> value, std::optional<double> reference) {
    if (!value || !reference) return std::nullopt;
    const double off = std::abs(*value - *reference);
    return finite(*reference != 0 ? off / std::abs(*reference) : off);
}

/// What the closed form says of a variant.
class ClosedForm {
  public:
    ClosedForm(const std::string& name, const scene::Case& variant)
        : smith_(name == "smith"), variant_(variant) {}

    [[nodiscard]] std::optional<double> outcome(const std::string& name) const {
        if (!smith_ || variant_.scene.projectiles.empty()) return std::nullopt;
        const double speed = partition::wave_speed(variant_.scene.fabrics.front());
        const study::SmithImpact impact =
            study::smith_impact(variant_.scene.projectiles.front().velocity[2], speed);
        if (name == "strip_strain") return impact.strain;
        if (name == "strip_transverse_speed") return impact.transverse_speed;
        return name == "strip_longitudinal_speed" ? std::optional(speed) : std::nullopt;
    }

    [[nodiscard]] std::optional<study::Curve> history(const std::string& column,
                                                      const study::Curve& computed) const {
        if (smith_ || column != "stress") return std::nullopt;
        const fabric::Constants c = fabric::constants_of(variant_.scene.fabrics.front());
        study::Curve curve{computed.time, {}};
        for (const double time : computed.time)
            curve.value.push_back(study::constant_rate_stress(c.fill.static_modulus, c.fill.hooke_modulus,
                                                              c.fill.relaxation_time, variant_.yarn.rate,
                                                              time));
        return curve;
    }

  private:
    bool smith_;
    const scene::Case& variant_;
};

class Measurement {
  public:
    Measurement(const scene::Study& study, std::span<const StudyEntry> entries,
                const std::filesystem::path& folder, const study::Columns& measured)
        : study_(study), entries_(entries), folder_(folder), measured_(measured) {
        for (const StudyEntry& entry : entries)
            results_.emplace_back(entry.input, folder / entry.variant.name);
    }

    [[nodiscard]] std::vector<StudyRow> rows() const {
        std::vector<StudyRow> rows;
        for (std::size_t i = 0; i < entries_.size(); ++i) rows.push_back(row(i));
        return rows;
    }

  private:
    [[nodiscard]] StudyRow row(std::size_t i) const {
        const nlohmann::json& summary = results_[i].summary();
        StudyRow row;
        row.outcome = summary.at("status");
        row.reason = summary.at("reason");
        row.element_steps = summary.at("element_steps");
        row.ranks = summary.at("ranks");
        row.wall_seconds = summary.at("nanoseconds_per_element_step").get<double>() * 1e-9 *
                           static_cast<double>(row.element_steps) / row.ranks;
        for (const Measure& measure : study_.quantities) {
            row.values.push_back(measure.kind == Measure::Kind::outcome ? results_[i].outcome(measure.of)
                                                                        : std::nullopt);
            row.errors.push_back(error(i, measure, row.values.back()));
            row.history.push_back(range(i, measure));
        }
        return row;
    }

    [[nodiscard]] std::optional<ValueRange> range(std::size_t i, const Measure& measure) const {
        if (measure.kind != Measure::Kind::history) return std::nullopt;
        const study::Curve curve = results_[i].history(measure.of);
        if (curve.value.empty()) return std::nullopt;
        const auto [least, most] = std::ranges::minmax(curve.value);
        return ValueRange{least, most};
    }

    [[nodiscard]] std::optional<double> error(std::size_t i, const Measure& measure,
                                              std::optional<double> value) const {
        if (measure.of == "evaluations") return std::nullopt;  // a cost
        switch (study_.reference.kind) {
            case Reference::Kind::variant:
                return from_variant(i, measure, value);
            case Reference::Kind::closed_form:
                return from_closed_form(i, measure, value);
            case Reference::Kind::file:
                return from_file(i, measure, value);
            case Reference::Kind::none:
                break;
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<double> from_variant(std::size_t i, const Measure& measure,
                                                     std::optional<double> value) const {
        const std::size_t r = entries_[i].reference;
        if (measure.kind == Measure::Kind::outcome) return relative(value, results_[r].outcome(measure.of));
        if (measure.kind == Measure::Kind::field)
            return finite(field_distance(results_file(i), results_file(r), measure.time));
        return finite(
            study::distance(results_[i].history(measure.of), results_[r].history(measure.of), measure.norm));
    }

    [[nodiscard]] std::optional<double> from_closed_form(std::size_t i, const Measure& measure,
                                                         std::optional<double> value) const {
        const ClosedForm form(study_.reference.closed_form, entries_[i].input);
        if (measure.kind == Measure::Kind::outcome) return relative(value, form.outcome(measure.of));
        if (measure.kind == Measure::Kind::field) return std::nullopt;
        const study::Curve computed = results_[i].history(measure.of);
        const auto exact = form.history(measure.of, computed);
        return exact ? finite(study::distance(computed, *exact, measure.norm)) : std::nullopt;
    }

    /// A measured table has `time` and columns as the history, and outcomes in the first row of columns of
    /// their names.
    [[nodiscard]] std::optional<double> from_file(std::size_t i, const Measure& measure,
                                                  std::optional<double> value) const {
        const auto column = measured_.find(measure.of);
        if (column == measured_.end() || column->second.empty() || measure.kind == Measure::Kind::field)
            return std::nullopt;
        if (measure.kind == Measure::Kind::outcome) return relative(value, finite(column->second.front()));
        const auto time = measured_.find("time");
        if (time == measured_.end()) return std::nullopt;
        study::Curve curve;
        for (std::size_t k = 0; k < time->second.size(); ++k) {
            if (!std::isfinite(column->second[k])) continue;
            curve.time.push_back(time->second[k]);
            curve.value.push_back(column->second[k]);
        }
        return finite(study::distance(results_[i].history(measure.of), curve, measure.norm));
    }

    [[nodiscard]] std::filesystem::path results_file(std::size_t i) const {
        return folder_ / entries_[i].variant.name / "results.vtkhdf";
    }

    const scene::Study& study_;
    std::span<const StudyEntry> entries_;
    std::filesystem::path folder_;
    std::deque<VariantResults> results_;
    const study::Columns& measured_;
};

}  // namespace

std::vector<StudyRow> measure_study(const scene::Study& study, std::span<const StudyEntry> entries,
                                    const std::filesystem::path& folder, const study::Columns& measured) {
    return Measurement(study, entries, folder, measured).rows();
}

}  // namespace weavefront::app
