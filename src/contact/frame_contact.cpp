#include "weavefront/contact/frame_contact.hpp"

#include "weavefront/contact/rigid_pressure.hpp"

namespace weavefront::contact {

FrameContact::FrameContact(const scene::Frame& frame, const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
                           std::span<const Vec3> x)
    : quadrature_(spacing), points_(static_cast<std::size_t>(surface.owned)), reserves_(points_.size()) {
    const auto& last = surface.plies.back();
    for (const auto& ply : surface.plies) {
        shapes_.emplace_back(frame, last.z + last.thickness / 2, ply.thickness / 2);
        laws_.emplace_back(law, ply.areal_density);
    }
    for (std::size_t f = 0; f < points_.size(); ++f) rules_.push_back(quadrature_.rule_for(corners_of(surface.facets[f].nodes, x)));
}

void FrameContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                            std::vector<PairForce>& forces) {
    for (std::size_t f = 0; f < points_.size(); ++f) {
        const auto& facet = surface.facets[f];
        const auto& shape = shapes_[static_cast<std::size_t>(facet.ply)];
        const auto box = Box::around(facet, x);
        if (surface.alive[f] == 0 || !shape.may_touch(box.low, box.high)) {
            points_[f] = {};
            continue;
        }
        RigidPair pair{facet, surface.areas[f], quadrature_.rule(rules_[f]), laws_[static_cast<std::size_t>(facet.ply)], Master::frame};
        if (!quadrature_.at_nodes()) pair.normals = normals.of(facet, surface, x);
        const auto force = press(pair, x, v, dt, points_[f], reserves_[f], [&](const Vec3& at, const Point&) { return shape.depth(at); });
        if (force.total != Vec3::Zero()) forces.push_back(force);
    }
}

void FrameContact::save(std::int32_t facet, std::vector<double>& record) const {
    const auto f = static_cast<std::size_t>(facet);
    save_points(reserves_[f], points_[f], record);
}

std::span<const double> FrameContact::restore(std::int32_t facet, std::span<const double> record) {
    const auto f = static_cast<std::size_t>(facet);
    return restore_points(reserves_[f], points_[f], record);
}

}  // namespace weavefront::contact
