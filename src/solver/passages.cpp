#include "weavefront/solver/passages.hpp"

#include <algorithm>
#include <limits>

#include "weavefront/contact/ray.hpp"

namespace weavefront::solver {

namespace {

constexpr auto none = std::numeric_limits<std::int64_t>::max();

/// Height at which the line through a point along z meets a facet, m; nothing: it does not.
std::optional<double> height_at(const std::array<Vec3, 4>& corners, const Vec3& point) {
    const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    const double direction = normal.z() < 0 ? -1 : 1;
    const auto hits = contact::intersect(contact::one_ray(point, {0, 0, direction}), corners);
    if (!hits.hit[0]) return std::nullopt;
    return point.z() + direction * hits.distance[0];
}

/// What of a ply is around the projectile's middle.
struct Around {
    bool ahead = false;  ///< fabric within the radius that is not behind it, or any that presses on it
    std::int64_t across = none;  ///< lowest element across its axis behind it
};

/// Whether an owned facet belongs to the target and is neither torn nor next to what is.
bool is_sound(const Model& model, const JoinedFabric& fabric, std::size_t facet) {
    const auto& surface = model.surface;
    if (!fabric.has_element(model, facet) || (!surface.on_free_edge.empty() && surface.on_free_edge[facet]))
        return false;
    const auto slot = model.slots[facet];
    const auto intact = model.groups[static_cast<std::size_t>(slot.group)]->intact_yarns(slot.index);
    return intact.fill && intact.warp;
}

std::vector<Around> look_around(const Model& model, const JoinedFabric& fabric,
                                std::span<const contact::PairForce> pairs, std::size_t number,
                                const Vec3& middle, double radius) {
    const auto& surface = model.surface;
    std::vector<Around> plies(surface.plies.size());
    const auto nodes_of_ply = model.nodes.count / static_cast<std::int32_t>(plies.size());
    for (const auto& pair : pairs)
        if (pair.kind == contact::Master::projectile && pair.projectile == number)
            plies[static_cast<std::size_t>(pair.slave[0] / nodes_of_ply)].ahead = true;
    for (const auto f : model.projectiles[number].contact->candidates()) {
        const auto i = static_cast<std::size_t>(f);
        const auto& facet = surface.facets[i];
        if (!is_sound(model, fabric, i)) continue;
        auto& ply = plies[static_cast<std::size_t>(facet.ply)];
        const auto corners = contact::corners_of(facet.nodes, model.nodes.x);
        const auto box = contact::Box::around(corners);
        const double x = std::max({box.low.x() - middle.x(), middle.x() - box.high.x(), 0.0});
        const double y = std::max({box.low.y() - middle.y(), middle.y() - box.high.y(), 0.0});
        if (x * x + y * y > radius * radius) continue;
        if (box.high.z() >= middle.z())
            ply.ahead = true;
        else if (x == 0 && y == 0 && height_at(corners, middle))
            ply.across = std::min(ply.across, static_cast<std::int64_t>(facet.id));
    }
    return plies;
}

/// Initial corners of an element on a diagonal, m.
std::array<Vec3, 2> initial_diagonal(const mesh::Panel& panel, std::int64_t element) {
    const auto corners = panel.footprint(element % panel.columns());
    const auto ply = static_cast<std::int32_t>(element / panel.columns());
    return {panel.position(ply, corners[0]), panel.position(ply, corners[2])};
}

/// Whether an element was near another one of its ply at the start: within the projectile's radius and the
/// size of the other.
bool is_near(const mesh::Panel& panel, std::int64_t element, std::int64_t other, double radius) {
    const auto [a, b] = initial_diagonal(panel, element);
    const auto [c, d] = initial_diagonal(panel, other);
    return ((a + b) / 2 - (c + d) / 2).norm() < radius + (d - c).norm();
}

/// Whether no other projectile is nearer to where an element was at the start, as seen along z.
bool is_nearest(const Model& model, const mesh::Panel& panel, std::int64_t element, std::size_t number) {
    const auto [a, b] = initial_diagonal(panel, element);
    const auto distance = [&](const Projectile& projectile) {
        const Vec3 apart = projectile.contact->middle(projectile.body) - (a + b) / 2;
        return apart.x() * apart.x() + apart.y() * apart.y();
    };
    const double own = distance(model.projectiles[number]);
    return std::ranges::all_of(model.projectiles, [&](const auto& other) { return distance(other) >= own; });
}

/// Eroded elements of each ply: those that no other projectile is nearer to, and those near an element that
/// lies across the projectile's way.
struct Eroded {
    std::vector<std::int64_t> own, near;
};

/// @param across elements, one a ply, or none @note Collective
Eroded count_eroded(const Model& model, const mesh::Panel& panel, std::span<const std::int64_t> across,
                    std::size_t number, double radius, const parallel::Communicator& comm) {
    Eroded eroded{std::vector<std::int64_t>(across.size(), 0), std::vector<std::int64_t>(across.size(), 0)};
    for (std::size_t f = 0; f < static_cast<std::size_t>(model.surface.owned); ++f) {
        if (model.surface.alive[f]) continue;
        const auto& facet = model.surface.facets[f];
        const auto ply = static_cast<std::size_t>(facet.ply);
        if (is_nearest(model, panel, facet.id, number)) ++eroded.own[ply];
        if (across[ply] != none && is_near(panel, facet.id, across[ply], radius)) ++eroded.near[ply];
    }
    comm.sum(eroded.own);
    comm.sum(eroded.near);
    return eroded;
}

}  // namespace

bool Passages::all() const {
    return std::ranges::all_of(plies_, [](const auto& passage) { return passage.has_value(); });
}

void Passages::look(const Model& model, const JoinedFabric& fabric, const mesh::Panel& panel,
                    std::span<const contact::PairForce> pairs, std::size_t number, double time,
                    const parallel::Communicator& comm) {
    const auto& projectile = model.projectiles[number];
    const Vec3 middle = projectile.contact->middle(projectile.body),
               half = projectile.contact->half_extents(projectile.body);
    const double radius = std::max(half.x(), half.y());
    const auto around = look_around(model, fabric, pairs, number, middle, radius);
    std::vector<std::int64_t> ahead(plies_.size(), 0);
    for (std::size_t p = 0; p < plies_.size(); ++p) ahead[p] = around[p].ahead && !plies_[p] ? 1 : 0;
    comm.sum(ahead);
    const auto passed_now = [&](std::size_t p) { return ahead[p] == 0 && !plies_[p]; };
    std::vector<std::int64_t> across(plies_.size(), none);
    bool any = false;
    for (std::size_t p = 0; p < plies_.size(); ++p) {
        if (!passed_now(p)) continue;
        across[p] = around[p].across;
        any = true;
    }
    if (!any) return;
    comm.min(across);
    const auto eroded = count_eroded(model, panel, across, number, radius, comm);
    for (std::size_t p = 0; p < plies_.size(); ++p) {
        if (!passed_now(p)) continue;
        const bool is_across = across[p] != none, torn = is_across ? eroded.near[p] > 0 : eroded.own[p] > 0;
        plies_[p] = Passage{time,
                            torn        ? Way::hole
                            : is_across ? Way::whole_fabric
                                        : Way::beside,
                            is_across ? across[p] : -1};
    }
}

}  // namespace weavefront::solver
