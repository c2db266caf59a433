#include <fmt/format.h>

#include <algorithm>

#include "warnings/subjects.hpp"

namespace weavefront::app {

namespace {

// Elements that the wave in the yarns does not reach until the end are computed for nothing: up to a margin
// of this factor.
constexpr double most_beyond_wave = 10;

// A mesh reflects waves where neighbours differ in size; usual are 1.05 to 1.3, and from twice on the coarse
// one no longer sees what the fine one sends.
constexpr double most_growth = 2;

// Waves that elements at the impact can carry are lost on those at the edge; a mesh for both costs the step
// of the smallest.
constexpr double most_grading = 1000;

void warn_of_size(const Shot& shot, Phrases& found) {
    const auto& units = shot.scene.units;
    const double reached = shot.wave * shot.scene.time.end;
    const auto size = std::ranges::max(shot.scene.target->size);
    if (size / 2 > most_beyond_wave * reached)
        found.push_back(fmt::format("the target is {} wide, and the wave in its yarns goes {} until the end",
                                    text_of(size, units.length), text_of(reached, units.length)));
}

void warn_of_plies(const Shot& shot, Phrases& found) {
    if (shot.speed == 0) return;
    const auto& plies = shot.panel.plies;
    const auto& length = shot.scene.units.length;
    const double way = shot.speed * shot.scene.time.end;
    double largest = 0;
    std::size_t behind = 0;
    for (std::size_t i = 1; i < plies.size(); ++i) {
        const double gap =
            plies[i].spacing -
            (shot.fabric_of(plies[i]).contact_thickness + shot.fabric_of(plies[i - 1]).contact_thickness) / 2;
        if (gap > largest) largest = gap, behind = i;
    }
    if (largest > way)
        found.push_back(fmt::format(
            "between ply {} and ply {} there are {} of air, and the projectile goes {} until the end", behind,
            behind + 1, text_of(largest, length), text_of(way, length)));
}

void warn_of_frame(const Shot& shot, Phrases& found) {
    const auto& frame = *shot.scene.target->frame;
    const auto length = [&](double value) { return text_of(value, shot.scene.units.length); };
    const double across = shot.scene.largest_diameter();
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& half = frame.half_opening[d];
        if (!half) continue;
        const double bar = shot.scene.target->size[d] / 2 - *half;
        if (frame.edge_radius > bar)
            found.push_back(
                fmt::format("the bars of the frame are rounded with {} along {}, where the fabric lies on {} "
                            "of them: nowhere flat",
                            length(frame.edge_radius), d == 0 ? "x" : "y", length(bar)));
        if (2 * *half < across)
            found.push_back(
                fmt::format("the frame's opening is {} along {}, less than the {} of the projectile",
                            length(2 * *half), d == 0 ? "x" : "y", length(across)));
    }
    if (frame.radius && 2 * *frame.radius < across)
        found.push_back(
            fmt::format("the frame's opening is {} in diameter, less than the {} of the projectile",
                        length(2 * *frame.radius), length(across)));
}

}  // namespace

void warn_of_target(const Shot& shot, Phrases& found) {
    if (shot.has_plausible_end()) {
        warn_of_size(shot, found);
        warn_of_plies(shot, found);
    }
    const auto& [center, edge, growth] = shot.scene.target->mesh;
    if (edge > most_grading * center)
        found.push_back(fmt::format(
            "elements grow from {} to {}: the smallest set the step, the largest see no wave of theirs",
            text_of(center, shot.scene.units.length), text_of(edge, shot.scene.units.length)));
    if (growth > most_growth)
        found.push_back(fmt::format(
            "elements grow by {:.4g} from one to the next, usual are 1.05 to 1.3; above 3 they grow by 3",
            growth));
    if (shot.scene.target->frame) warn_of_frame(shot, found);
}

}  // namespace weavefront::app
