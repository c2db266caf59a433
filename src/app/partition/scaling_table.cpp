#include "scaling_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/run_decomposition.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

namespace {

partition::Forecast forecast_on(const scene::Scene& scene, int ranks, const partition::Machine& machine) {
    const auto panel = mesh::make_panel(scene);
    const double reach = solver::ghost_reach(scene, panel);
    return partition::forecast(scene, panel, partition::decompose_for_run(scene, panel, ranks, reach), reach,
                               machine);
}

}  // namespace

scene::Scene scaled_scene(const scene::Scene& scene, bool weak, int ranks, int first) {
    auto scaled = scene;
    const double finer = weak ? std::sqrt(static_cast<double>(ranks) / first) : 1;
    scaled.target->mesh.center /= finer;
    scaled.target->mesh.edge /= finer;
    return scaled;
}

std::vector<ScalingRow> forecast_all(const scene::Scene& scene, bool weak, const std::vector<int>& ranks,
                                     const partition::Machine& machine) {
    const auto alone = forecast_on(scene, 1, machine);
    std::vector<ScalingRow> rows;
    for (const int count : ranks) {
        ScalingRow row{
            .forecast = forecast_on(scaled_scene(scene, weak, count, ranks.front()), count, machine),
            .measured = {}};
        row.efficiency = partition::efficiency(row.forecast, alone);
        rows.push_back(row);
    }
    return rows;
}

std::string terminal_table(const std::vector<ScalingRow>& rows) {
    const bool measured = std::ranges::any_of(rows, [](const auto& row) { return row.measured.has_value(); });
    std::string text =
        fmt::format("{:>7} {:>11} {:>9} {:>9} {:>9} {:>10} {:>10} {:>12} {:>10}", "ranks", "elements",
                    "elements", "cost", "cut", "neighbours", "halo", "step", "efficiency");
    text += measured ? fmt::format(" {:>12} {:>9} {:>9}\n", "measured", "slowdown", "model") : "\n";
    text += fmt::format("{:>7} {:>11} {:>9} {:>9} {:>9} {:>10} {:>10} {:>12} {:>10}", "", "", "most/mean",
                        "most/mean", "faces", "most", "most, kB", "model, us", "%");
    text += measured ? fmt::format(" {:>12} {:>9} {:>9}\n", "step, us", "calibr.", "off by, %") : "\n";
    for (const auto& [f, efficiency, seconds, slowdown] : rows) {
        text +=
            fmt::format("{:>7} {:>11} {:>9.3f} {:>9.3f} {:>9} {:>10} {:>10.1f} {:>12.1f} {:>10.1f}", f.ranks,
                        f.elements, f.element_imbalance, f.cost_imbalance, f.cut_edges, f.most_neighbours,
                        static_cast<double>(f.most_halo_bytes) / 1e3, f.seconds * 1e6, efficiency * 100);
        if (seconds)
            text += fmt::format(" {:>12.1f} {:>9.3f} {:>+9.1f}", *seconds * 1e6, slowdown,
                                (f.seconds * slowdown / *seconds - 1) * 100);
        text += '\n';
    }
    return text;
}

std::string csv_table(const std::vector<ScalingRow>& rows) {
    std::string text =
        "ranks,elements,columns,element_imbalance,cost_imbalance,cut_edges,most_neighbours,most_halo_bytes,"
        "halo_bytes,step_seconds,"
        "efficiency,"
        "measured_seconds,measured_slowdown\n";
    for (const auto& [f, efficiency, measured, slowdown] : rows)
        text += fmt::format("{},{},{},{:.10g},{:.10g},{},{},{},{},{:.10g},{:.10g},{},{}\n", f.ranks,
                            f.elements, f.columns, f.element_imbalance, f.cost_imbalance, f.cut_edges,
                            f.most_neighbours, f.most_halo_bytes, f.halo_bytes, f.seconds, efficiency,
                            measured ? fmt::format("{:.10g}", *measured) : "",
                            measured ? fmt::format("{:.4g}", slowdown) : "");
    return text;
}

}  // namespace weavefront::app
