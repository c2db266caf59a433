#include <fmt/format.h>

#include <string_view>

#include "warnings/subjects.hpp"

namespace weavefront::app {

namespace {

// The run stops when more than a share of the transferred energy is missing: at a share of 1, that is never.
constexpr double most_energy_error = 1;

// The bound on the step is one on stability; below a tenth of it accuracy gains nothing and cost is tenfold.
constexpr double least_safety = 0.1, most_safety = 1;

// Left to itself a node has lost 1 - 1/e of its velocity by the end: more than air does.
constexpr double most_damping = 1;

void warn_of_time(const Shot& shot, Phrases& found) {
    const auto& units = shot.scene.units;
    const double end = shot.scene.time.end;
    const auto time = [&](double value) { return text_of(value, units.time); };
    if (shot.time_step > 0 && end < shot.time_step)
        found.push_back(
            fmt::format("the run ends at {}, within its first step of {}", time(end), time(shot.time_step)));
    else if (shot.has_plausible_end())
        return;
    else if (shot.wave * end < shot.scene.largest_diameter())
        found.push_back(fmt::format(
            "the run ends at {}, when the wave in the yarns has gone {}, less than the projectile is wide",
            time(end), text_of(shot.wave * end, units.length)));
    else
        found.push_back(fmt::format("the run ends at {}; {} crosses the target in {}", time(end),
                                    shot.speed > 0 && shot.scene.least_speed() < shot.wave
                                        ? "the projectile's speed"
                                        : "the wave in the yarns",
                                    time(shot.crossing())));
}

void warn_of_output(const Shot& shot, Phrases& found) {
    const auto& units = shot.scene.units;
    const auto warn_if_below_step = [&](std::string_view key, double interval, std::string_view what) {
        if (interval > 0 && interval < shot.time_step && shot.time_step <= shot.scene.time.end)
            found.push_back(
                fmt::format("{} is {}, less than the step of {}: there is one {} a step at the most", key,
                            text_of(interval, units.time), text_of(shot.time_step, units.time), what));
    };
    warn_if_below_step("output.history", shot.scene.output.history, "row");
    warn_if_below_step("output.interval", shot.scene.output.interval, "frame");
}

}  // namespace

void warn_of_controls(const Shot& shot, Phrases& found) {
    const auto& scene = shot.scene;
    warn_of_time(shot, found);
    warn_of_output(shot, found);
    if (scene.time.safety > most_safety)
        found.push_back(fmt::format(
            "time.safety is {:.4g}: the step is longer than its bound, and the run may become unstable",
            scene.time.safety));
    if (scene.time.safety < least_safety)
        found.push_back(
            fmt::format("time.safety is {:.4g}: the run takes {:.3g} times the steps of the default and is "
                        "no better for it",
                        scene.time.safety, scene::Scene::Time{}.safety / scene.time.safety));
    if (shot.has_plausible_end() && scene.damping * scene.time.end > most_damping)
        found.push_back(fmt::format("damping of {} slows everything {:.3g} times over e-fold until the end",
                                    text_of(scene.damping, scene.units.rate),
                                    scene.damping * scene.time.end));
    if (scene.limits.energy_error >= most_energy_error)
        found.push_back(fmt::format(
            "limits.energy_error is {:.4g} %: the guard lets all energy be lost and never stops the run",
            scene.limits.energy_error * 100));
}

}  // namespace weavefront::app
