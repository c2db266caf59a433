#include "weavefront/contact/frame_contact.hpp"

namespace weavefront::contact {

FrameContact::FrameContact(const scene::Frame& frame, const scene::ContactLaw& law,
                           std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x)
    : friction_(CoulombLaw::of(law)), quadrature_(spacing, surface, x), memories_(surface.owned) {
    const auto& last = surface.plies.back();
    for (const auto& ply : surface.plies) {
        shapes_.emplace_back(frame, last.z + last.thickness / 2, ply.thickness / 2);
        laws_.emplace_back(law, ply.areal_density);
    }
}

void FrameContact::evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                            std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces) {
    for (std::int32_t index = 0; index < surface.owned; ++index) {
        const auto f = static_cast<std::size_t>(index);
        const auto& facet = surface.facets[f];
        const auto& shape = shapes_[static_cast<std::size_t>(facet.ply)];
        const auto box = Box::around(facet, x);
        if (surface.alive[f] == 0 || !shape.may_touch(box.low, box.high)) {
            forget_points(memories_, index);
            continue;
        }
        const auto ply = static_cast<std::size_t>(facet.ply);
        const RigidPair pair{.facet = facet,
                             .area = surface.areas[f],
                             .rule = quadrature_.rule(index),
                             .law = laws_[ply],
                             .thickness = surface.plies[ply].thickness,
                             .body = Master::frame,
                             .away = {0, 0, -1},
                             .motion = {},
                             .friction = friction_ ? &*friction_ : nullptr};
        const auto of_ply = [&] {
            return quadrature_.at_nodes() ? PlyNormals() : normals.of(facet, surface, x);
        };
        const auto depth = [&](const Vec3& at, const Point&) { return shape.depth(at); };
        press(pair, {x, v, dt}, sliding_share, memories_.take(index), depth, of_ply, forces);
    }
}

}  // namespace weavefront::contact
