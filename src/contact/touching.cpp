#include "weavefront/contact/touching.hpp"

#include <algorithm>

namespace weavefront::contact {

namespace {

// Pressures of a few GPa press two plies into each other by about their thickness; a point deeper than this has gone through a hole.
constexpr double deepest_in_thicknesses = 4;

}  // namespace

double Touching::depth_of(double thickness) { return deepest_in_thicknesses * thickness; }

Touching::Touching(const std::vector<PlyProperties>& plies) : plies_(plies.size()) {
    for (const auto& ply : plies) {
        most_ = std::max(most_, ply.thickness);
        depth_ = std::max(depth_, depth_of(ply.thickness));
        // Plies that lie closer than their thickness at the start touch there without pressing.
        for (const auto& other : plies) distances_.push_back(std::min((ply.thickness + other.thickness) / 2, other.z - ply.z));
    }
}

}  // namespace weavefront::contact
