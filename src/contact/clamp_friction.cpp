#include "weavefront/contact/clamp_friction.hpp"

#include <utility>

namespace weavefront::contact {

ClampFriction::ClampFriction(const std::array<std::optional<scene::Clamp>, 2>& clamps, double stiffness,
                             std::vector<Column> columns, std::size_t nodes_of_ply, std::size_t plies)
    : columns_(std::move(columns)),
      nodes_of_ply_(nodes_of_ply),
      plies_(plies),
      column_of_(nodes_of_ply, -1),
      tractions_(columns_.size() * (plies + 1)) {
    for (std::size_t axis = 0; axis < 2; ++axis)
        if (clamps[axis])
            laws_[axis] = {CoulombLaw(clamps[axis]->friction, stiffness), clamps[axis]->pressure};
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        column_of_[columns_[c].node] = static_cast<std::int32_t>(c);
        for (std::size_t p = 0; p < plies_; ++p)
            forces_.push_back({columns_[c].node + p * nodes_of_ply_, Vec3::Zero()});
    }
}

void ClampFriction::evaluate(std::span<const Vec3> v, double dt) {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const auto& column = columns_[c];
        const auto& law = *laws_[column.clamp];
        const auto face = [&](std::size_t p) -> TangentialTraction& {
            return traction(static_cast<std::int32_t>(c), p);
        };
        const auto velocity = [&](std::size_t p) { return v[column.node + p * nodes_of_ply_]; };
        for (std::size_t p = 0; p <= plies_; ++p) {
            const Vec3 in_front = p == 0 ? Vec3(Vec3::Zero()) : velocity(p - 1),
                       behind = p == plies_ ? Vec3(Vec3::Zero()) : velocity(p);
            law.friction.advance(face(p), Vec3::UnitZ(), law.pressure,
                                 {.slip = dt * (in_front - behind), .turn = Vec3::Zero()});
        }
        for (std::size_t p = 0; p < plies_; ++p)
            forces_[c * plies_ + p].force = column.area[p] * (face(p).traction - face(p + 1).traction);
    }
}

}  // namespace weavefront::contact
