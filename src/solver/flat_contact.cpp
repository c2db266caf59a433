#include "weavefront/solver/flat_contact.hpp"

#include <algorithm>
#include <bit>

namespace weavefront::solver {

namespace {

// Steeper fabric has nothing to win: normals and contact may be at right angles.
constexpr double square_of_steepest = 0.5;  // cosine, of 45 deg

/// Square of the cosine between a force and a direction; of no force 1.
double facing(const Vec3& force, const Vec3& axis) {
    const double square = force.squaredNorm(), component = force.dot(axis);
    return square > 0 ? component * component / square : 1;
}

/// Least n |n| over the alive elements, n the cosine of the angle between normal and axis; at most `known`.
/// The search ends at an element that is too steep.
/// @param first pack to start from; becomes the pack at which the search ended
double least_facing(const shell::ElementGroup& group, std::span<const Vec3> x, const Vec3& axis, double known,
                    std::int32_t& first) {
    using simd::Pack;
    const auto packs = group.packs();
    if (first >= packs) first = 0;  // the group is another one now
    const auto start = first;
    for (std::int32_t i = 0; i < packs && known > square_of_steepest; ++i) {
        const auto pack = i + start < packs ? i + start : i + start - packs;
        const auto corners = group.corners(pack, x);
        const auto normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
        const Pack along = normal.x * axis.x() + normal.y * axis.y() + normal.z * axis.z();
        const Pack facing =
            along * simd::abs(along) / dot(normal, normal);  // not a number where the element has no area
        if (!simd::any(facing < known)) continue;
        for (int lane = 0; lane < shell::pack_width; ++lane) {
            const auto index = pack * shell::pack_width + lane;
            if (facing.get(lane) < known && index < group.size() && group.alive(index))
                known = facing.get(lane);
        }
        if (!(known > square_of_steepest)) first = pack;
    }
    return known;
}

}  // namespace

FlatContact::FlatContact(const mesh::Panel& panel)
    : corners_{panel.columns_x(), panel.nodes_per_ply() - 1, panel.nodes_per_ply() - 1 - panel.columns_x()},
      symmetry_(panel.symmetry) {}

Vec3 FlatContact::axis(const Model& model, const parallel::Communicator& comm) const {
    // A sum of bits of which one rank has all: exact, whichever rank that is.
    std::array<std::int64_t, 9> bits{};
    for (std::size_t k = 0; k < corners_.size(); ++k) {
        const auto at = std::ranges::lower_bound(model.nodes.ids, corners_[k]);
        const auto n = static_cast<std::size_t>(at - model.nodes.ids.begin());
        if (at == model.nodes.ids.end() || *at != corners_[k] || !model.nodes.owned[n]) continue;
        for (std::size_t d = 0; d < 3; ++d)
            bits[3 * k + d] = std::bit_cast<std::int64_t>(model.nodes.x[n][static_cast<Eigen::Index>(d)]);
    }
    comm.sum(bits);
    const auto corner = [&](std::size_t k) {
        return Vec3(std::bit_cast<double>(bits[3 * k]), std::bit_cast<double>(bits[3 * k + 1]),
                    std::bit_cast<double>(bits[3 * k + 2]));
    };
    Vec3 axis = (corner(1) - corner(0)).cross(corner(2) - corner(1));
    for (int d = 0; d < 2; ++d)
        if (symmetry_[static_cast<std::size_t>(d)]) axis[d] = 0;  // as of the mean normal
    return axis.normalized();
}

// All normals and directions of contact lie within an angle of the axis. So any two of them lie within twice
// this angle. Forces between plies need no look: they follow smoothed normals, which lie among those of
// elements.
double FlatContact::sine_squared(const Model& model, const Vec3& axis,
                                 std::span<const contact::PairForce> pairs,
                                 const parallel::Communicator& comm) {
    steepest_.resize(model.groups.size());
    double least = 1;
    for (std::size_t i = 0; i < model.groups.size(); ++i)
        least = least_facing(*model.groups[i], model.nodes.x, axis, least, steepest_[i]);
    for (const auto& pair : pairs)
        if (pair.kind != contact::Master::facet)
            for (const auto& force : pair.on_slave) least = std::min(least, facing(force, axis));
    const double cosine_squared = comm.min(least);
    return cosine_squared > square_of_steepest ? 4 * cosine_squared * (1 - cosine_squared) : 1;
}

}  // namespace weavefront::solver
