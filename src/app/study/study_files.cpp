#include "study_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "csv_cell.hpp"
#include "versions.hpp"
#include "weavefront/io/replace_file.hpp"
#include "weavefront/study/convergence.hpp"

namespace weavefront::app {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:.10g}", *value) : ""; }

std::string csv_of(const scene::Study& study, std::span<const StudyEntry> entries,
                   std::span<const StudyRow> rows) {
    std::string text = "variant";
    for (const scene::Axis& axis : study.axes) text += fmt::format(",{}", quoted_cell(axis.name));
    text += ",outcome";
    for (const scene::Measure& measure : study.quantities) {
        if (measure.kind == scene::Measure::Kind::outcome) text += fmt::format(",{}", measure.name);
        text += fmt::format(",{}_error", measure.name);
    }
    text += ",wall_seconds,element_steps,ranks\n";
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += quoted_cell(entries[i].variant.name);
        for (const std::string& label : entries[i].variant.labels)
            text += fmt::format(",{}", quoted_cell(label));
        text += fmt::format(",{}", rows[i].outcome);
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            if (study.quantities[q].kind == scene::Measure::Kind::outcome)
                text += fmt::format(",{}", cell(rows[i].values[q]));
            text += fmt::format(",{}", cell(rows[i].errors[q]));
        }
        text += fmt::format(",{:.4g},{},{}\n", rows[i].wall_seconds, rows[i].element_steps, rows[i].ranks);
    }
    return text;
}

/// Variants that differ along the axis of the order only.
struct Series {
    std::vector<std::string> labels;  ///< that they share
    std::vector<std::size_t> members;
};

std::vector<Series> series_of(const scene::Study& study, std::span<const StudyEntry> entries) {
    std::vector<Series> all;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].reference_only) continue;
        std::vector<std::string> shared =
            study.order ? entries[i].variant.labels : std::vector<std::string>{};
        if (study.order) shared.erase(shared.begin() + static_cast<std::ptrdiff_t>(*study.order));
        auto series = std::ranges::find(all, shared, &Series::labels);
        if (series == all.end()) series = all.insert(all.end(), {shared, {}});
        series->members.push_back(i);
    }
    return all;
}

Json orders_of(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows,
               std::size_t quantity) {
    Json all = Json::array();
    for (const auto& [labels, members] : series_of(study, entries)) {
        Json found = {{"labels", labels},
                      {"variants", Json::array()},
                      {"order", nullptr},
                      {"local_orders", Json::array()}};
        std::vector<study::Point> points;
        for (const std::size_t i : members) {
            found["variants"].push_back(entries[i].variant.name);
            if (!study.order || rows[i].outcome != "finished" || !rows[i].errors[quantity]) continue;
            points.push_back({*entries[i].variant.values[*study.order],
                              static_cast<double>(rows[i].element_steps), *rows[i].errors[quantity]});
        }
        if (points.size() > 1) {
            found["order"] = json_of(study::observed_order(points));
            for (const auto& order : study::local_orders(points))
                found["local_orders"].push_back(json_of(order));
        }
        all.push_back(found);
    }
    return all;
}

/// One truth a row: whether it is on the front of this quantity's error among the variants with the same
/// reference. A stopped one never is.
std::vector<bool> front_of(std::span<const StudyEntry> entries, std::span<const StudyRow> rows,
                           std::size_t quantity, const std::vector<double>& costs, bool one_reference) {
    std::vector<bool> front(rows.size(), false);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::vector<double> errors;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool counts = rows[i].outcome == "finished" && !entries[i].reference_only &&
                                rows[i].errors[quantity] && (one_reference || entries[i].reference == r);
            errors.push_back(counts ? *rows[i].errors[quantity] : std::numeric_limits<double>::infinity());
        }
        const std::vector<bool> part = study::pareto_front(costs, errors);
        for (std::size_t i = 0; i < rows.size(); ++i) front[i] = front[i] || part[i];
        if (one_reference) break;
    }
    return front;
}

Json fronts_of(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows,
               std::size_t quantity) {
    std::vector<double> seconds, steps, evaluations;
    const auto counted =
        std::ranges::find(study.quantities, "evaluations", &scene::Measure::name) - study.quantities.begin();
    for (const StudyRow& row : rows) {
        seconds.push_back(row.wall_seconds * row.ranks);
        steps.push_back(static_cast<double>(row.element_steps));
        if (counted < std::ssize(row.values))
            evaluations.push_back(row.values[static_cast<std::size_t>(counted)].value_or(0));
    }
    const bool one_reference = study.reference.kind != scene::Reference::Kind::variant;
    const auto front = [&](const std::vector<double>& costs) {
        return front_of(entries, rows, quantity, costs, one_reference);
    };
    Json fronts = {{"core_seconds", front(seconds)}, {"element_steps", front(steps)}};
    if (!evaluations.empty()) fronts["evaluations"] = front(evaluations);
    return fronts;
}

Json axes_of(const scene::Study& study) {
    Json axes = Json::array();
    for (const scene::Axis& axis : study.axes) {
        Json choices = Json::array();
        for (const scene::Choice& choice : axis.choices)
            choices.push_back({{"label", choice.label}, {"value", json_of(choice.value)}});
        axes.push_back({{"name", axis.name}, {"choices", choices}});
    }
    return axes;
}

Json rows_of(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows) {
    const bool compared = study.reference.kind == scene::Reference::Kind::variant;
    Json all = Json::array();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Json values = Json::object(), errors = Json::object();
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            if (study.quantities[q].kind == scene::Measure::Kind::outcome)
                values[study.quantities[q].name] = json_of(rows[i].values[q]);
            errors[study.quantities[q].name] = json_of(rows[i].errors[q]);
        }
        all.push_back(
            {{"variant", entries[i].variant.name},
             {"labels", entries[i].variant.labels},
             {"reference_only", entries[i].reference_only},
             {"compared_with", compared ? Json(entries[entries[i].reference].variant.name) : Json()},
             {"hash", entries[i].input.hash},
             {"outcome", rows[i].outcome},
             {"reason", rows[i].reason},
             {"values", values},
             {"errors", errors},
             {"wall_seconds", rows[i].wall_seconds},
             {"element_steps", rows[i].element_steps},
             {"ranks", rows[i].ranks}});
    }
    return all;
}

Json json_of(const scene::Study& study, std::span<const StudyEntry> entries, std::span<const StudyRow> rows) {
    Json quantities = Json::array();
    for (std::size_t q = 0; q < study.quantities.size(); ++q)
        quantities.push_back({{"name", study.quantities[q].name},
                              {"tolerance", json_of(study.quantities[q].tolerance)},
                              {"series", orders_of(study, entries, rows, q)},
                              {"pareto", fronts_of(study, entries, rows, q)}});
    return {{"title", study.title},
            {"study", study.text},
            {"versions", library_versions()},
            {"axes", axes_of(study)},
            {"order_along", study.order ? Json(study.axes[*study.order].name) : Json()},
            {"quantities", quantities},
            {"variants", rows_of(study, entries, rows)}};
}

}  // namespace

void write_study_files(const scene::Study& study, std::span<const StudyEntry> entries,
                       std::span<const StudyRow> rows, const std::filesystem::path& folder) {
    io::replace_file(folder / "study.csv", csv_of(study, entries, rows));
    io::replace_file(
        folder / "study.json",
        json_of(study, entries, rows).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace weavefront::app
