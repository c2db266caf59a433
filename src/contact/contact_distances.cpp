#include "weavefront/contact/contact_distances.hpp"

#include <algorithm>

namespace weavefront::contact {

namespace {

// Pressures of a few GPa press two plies into each other by about their thickness. A deeper point came
// through a hole.
constexpr double deepest_in_thicknesses = 4;

}  // namespace

double ContactDistances::max_penetration_of(double thickness) { return deepest_in_thicknesses * thickness; }

ContactDistances::ContactDistances(const std::vector<PlyProperties>& plies) : plies_(plies) {
    for (const auto& ply : plies) {
        most_ = std::max(most_, ply.thickness);
        max_penetration_ = std::max(max_penetration_, max_penetration_of(ply.thickness));
    }
}

}  // namespace weavefront::contact
