#include "closing_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "weavefront/solver/passages.hpp"

namespace weavefront::app {

namespace {

// The share of the internal energy from which hourglass energy is commonly questioned, where it is not
// nothing beside the transferred energy.
constexpr double most_hourglass = 0.1, negligible = 1e-3;

std::string place_text(const Vec3& place) {
    return fmt::format("x = {:.4g} mm, y = {:.4g} mm", place.x() * 1e3, place.y() * 1e3);
}

/// Plies that the projectile has passed although they are whole there, 1 = struck first.
std::vector<std::size_t> passed_whole(const solver::Passages& passages) {
    std::vector<std::size_t> plies;
    for (std::size_t p = 0; p < passages.plies().size(); ++p)
        if (passages.plies()[p] && passages.plies()[p]->way == solver::Way::whole_fabric)
            plies.push_back(p + 1);
    return plies;
}

/// What to call a projectile: its number where there are several.
std::string name_of(std::size_t number, std::size_t count) {
    return count > 1 ? fmt::format("projectile {}", number + 1) : "the projectile";
}

/// The worst of what contact let through, if anything. @note Collective
std::string missed_contact(const solver::Simulation& simulation) {
    const auto columns = simulation.panel().columns();
    const auto deepest = simulation.deepest();
    const auto crossed = simulation.crossed_elements();
    const auto& shots = simulation.shots();
    for (std::size_t p = 0; p < shots.size(); ++p)
        if (const auto plies = passed_whole(shots[p].passages); !plies.empty())
            return fmt::format(
                "{} has passed whole fabric: ply {}; contact is too soft, or its points or the "
                "elements are too far apart for it",
                name_of(p, shots.size()), fmt::join(plies, ", "));
    if (crossed.count > 0)
        return fmt::format(
            "{} elements have passed through the next ply, which is whole: the first is element {} of ply {}",
            crossed.count, crossed.first, crossed.first / columns + 1);
    if (deepest.in_thicknesses > 1)
        return fmt::format(
            "contact was up to {:.3g} mm deep, {:.2g} times the thickness of ply {}: at {}, t = {:.4g} us",
            deepest.overlap * 1e3, deepest.in_thicknesses, deepest.element / columns + 1,
            place_text(deepest.place), deepest.time * 1e6);
    return {};
}

}  // namespace

std::vector<std::string> closing_warnings(const solver::Simulation& simulation, const solver::Balance& last) {
    std::vector<std::string> warnings;
    const auto& counts = simulation.counts();
    const double hourglass = counts.largest_hourglass, internal = counts.largest_internal;
    if (hourglass > std::max(most_hourglass * internal, negligible * last.transferred_energy))
        warnings.push_back(
            fmt::format("the hourglass energy went up to {:.3g} J, that of the yarns to {:.3g} J: the fabric "
                        "deforms as finely as its "
                        "elements, where a "
                        "finer mesh might show more",
                        hourglass, internal));
    const auto& shots = simulation.shots();
    for (std::size_t p = 0; p < shots.size(); ++p)
        if (!shots[p].touched) warnings.push_back(name_of(p, shots.size()) + " never touched the target");
    if (const auto& overlap = simulation.projectile_overlap(); overlap.depth > 0)
        warnings.push_back(fmt::format(
            "projectiles {} and {} were inside each other, {:.3g} mm deep at t = {:.4g} us: contact between "
            "projectiles is not computed",
            overlap.first + 1, overlap.second + 1, overlap.depth * 1e3, overlap.time * 1e6));
    if (const auto missed = missed_contact(simulation); !missed.empty()) warnings.push_back(missed);
    if (counts.lowest_contact_energy < 0)
        warnings.push_back(
            fmt::format("contact gave energy: its work went down to {:.3g} J", counts.lowest_contact_energy));
    if (counts.inverted > 0)
        warnings.push_back(
            fmt::format("up to {} elements at a time were folded over themselves", counts.inverted));
    return warnings;
}

}  // namespace weavefront::app
