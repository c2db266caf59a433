#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include "commands.hpp"
#include "inactive_features.hpp"
#include "launcher.hpp"
#include "memory.hpp"
#include "stop.hpp"
#include "warnings.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/partition/forecast.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/step_limits.hpp"

namespace weavefront::app {

namespace {

/// The distance at which plies of a fabric touch, and what decides where its yarns break without viscosity:
/// sigma = E1 eps then, so that eps_a = E1/Ka eps reaches hooke_strain at Ka/E1 hooke_strain, IT04 (19), and
/// (20) is met at static_strain.
std::string fabric_text(const scene::Fabric& fabric, const scene::MessageUnits& units) {
    auto text = fmt::format("{}: plies touch at {} ({})", fabric.name,
                            text_of(fabric.contact_thickness, units.length), fabric.contact_thickness_source);
    const auto breaking = [](const scene::YarnSystem& yarns) {
        const double by_hooke =
            yarns.strength->hooke_strain * yarns.elastic.hooke_modulus / yarns.elastic.static_modulus;
        const bool hooke = by_hooke < yarns.strength->static_strain;
        return fmt::format("{:.4g} %, by {}", std::min(by_hooke, yarns.strength->static_strain) * 100,
                           hooke ? "hooke_strain" : "static_strain");
    };
    const auto [fill, warp] = fabric.systems();
    if (fabric.warp)
        text += fmt::format("; crimp of {:.3g} % in fill and {:.3g} % in warp", fill.crimp() * 100,
                            warp.crimp() * 100);
    if (!fabric.failure || fill.elastic.viscosity > 0 || warp.elastic.viscosity > 0) return text;
    text += "; without viscosity yarns break at ";
    return text + (fabric.warp ? fmt::format("{} (fill), and {} (warp)", breaking(fill), breaking(warp))
                               : breaking(fill));
}

/// Clear distances of the plies; empty: there is one ply.
std::string air_text(const scene::Scene& scene) {
    double least = std::numeric_limits<double>::max(), most = 0;
    const auto& plies = scene.target->plies;
    const auto thickness = [&](std::size_t i) {
        return scene.fabrics[static_cast<std::size_t>(plies[i].fabric)].contact_thickness;
    };
    for (std::size_t i = 1; i < plies.size(); ++i) {
        const double gap = std::max(0.0, plies[i].spacing - (thickness(i) + thickness(i - 1)) / 2);
        least = std::min(least, gap);
        most = std::max(most, gap);
    }
    if (plies.size() == 1) return {};
    const auto length = [&](double value) { return text_of(value, scene.units.length); };
    return length(least) == length(most) ? length(most)
                                         : fmt::format("{} to {}", length(least), length(most));
}

std::string limit_text(const solver::StepLimits& limits, const mesh::Panel& panel,
                       const scene::MessageUnits& units) {
    switch (limits.limit) {
        case solver::StepLimit::elements:
            return fmt::format("limited by the elements, whose shortest edge is {}",
                               text_of(panel.smallest_edge(), units.length));
        case solver::StepLimit::plies:
            return fmt::format("limited by the contact of plies; elements alone allow {:.4g} ns",
                               limits.of_elements * 1e9);
        case solver::StepLimit::projectile:
            return fmt::format("limited by the contact of the projectile; elements alone allow {:.4g} ns",
                               limits.of_elements * 1e9);
        case solver::StepLimit::frame:
            break;
    }
    return fmt::format("limited by the contact of the frame; elements alone allow {:.4g} ns",
                       limits.of_elements * 1e9);
}

void print_time(const scene::Scene& scene, const mesh::Panel& panel, const solver::StepLimits& limits) {
    const double steps = scene.time.end / limits.time_step;
    fmt::print("  time step  {:.4g} ns, {}\n", limits.time_step * 1e9,
               limit_text(limits, panel, scene.units));
    fmt::print("  steps      about {:.0f} to {}\n", steps, text_of(scene.time.end, scene.units.time, 6));
    const partition::Decomposition whole{
        1, std::vector<std::int32_t>(static_cast<std::size_t>(panel.columns()), 0)};
    const auto& machine = partition::committed_machine();
    const double seconds = steps * partition::forecast(scene, panel, whole, 0, machine).seconds;
    fmt::print(
        "  run time   about {} on one rank without set-up and output, estimated for one core of: {} (more "
        "ranks: weavefront partition)\n",
        seconds < 10 ? fmt::format("{:.2g} s", seconds) : io::duration_text(seconds), machine.name);
}

/// @returns none: the target does not fit into this machine
std::optional<solver::StepLimits> limits_of(const scene::Scene& scene, const mesh::Panel& panel) {
    if (memory_needed(panel) > memory_here()) return std::nullopt;
    const auto limits = solver::step_limits(scene, panel);
    if (!(limits.time_step > 0))
        throw GuardStop("the time step vanishes: a stiffness is beyond the range of numbers");
    return limits;
}

}  // namespace

void check(const CheckOptions& options) {
    if (!is_first_process()) return;
    const auto scene = scene::read_scene(options.scene, options.overrides);
    const auto panel = mesh::make_panel(scene);
    const auto limits = limits_of(scene, panel);
    const auto phrases = warnings(scene, panel, limits ? limits->time_step : 0);
    fmt::print("{}: {}\n", options.scene.string(),
               phrases.empty()
                   ? "nothing to object to"
                   : fmt::format("valid, with {} warning{}", phrases.size(), phrases.size() == 1 ? "" : "s"));
    fmt::print("  title      {}\n", scene.title);
    fmt::print("  size       {} elements, {} nodes ({} plies of {} x {} columns, 1/{} of the target)\n",
               panel.elements(), panel.nodes(), panel.plies.size(), panel.columns_x(), panel.columns_y(),
               panel.multiplicity());
    for (const auto& fabric : scene.fabrics)
        fmt::print("  fabric     {}\n", fabric_text(fabric, scene.units));
    if (const auto air = air_text(scene); !air.empty())
        fmt::print("  air        {} between the plies\n", air);
    fmt::print("  memory     up to {} on all ranks together\n", bytes_text(memory_needed(panel)));
    if (limits)
        print_time(scene, panel, *limits);
    else
        fmt::print("  time step  not computed: the target does not fit into the {} of this machine\n",
                   bytes_text(memory_here()));
    for (const auto& phrase : inactive_features(scene, 1)) fmt::print("  left out   {}\n", phrase);
    for (const auto& phrase : phrases) fmt::print("warning: {}\n", phrase);
}

}  // namespace weavefront::app
