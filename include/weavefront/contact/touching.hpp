#pragma once
/// @file
/// How near plies come before they press.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Distances of mid-surfaces at which plies touch.
class Touching {
  public:
    explicit Touching(const std::vector<PlyProperties>& plies);

    /// Of two plies, the nearer to the shot first, m.
    [[nodiscard]] double between(std::int32_t ply, std::int32_t other) const {
        const auto &front = plies_[static_cast<std::size_t>(ply)], &back = plies_[static_cast<std::size_t>(other)];
        // Plies that lie closer than their thickness at the start touch there without pressing.
        return std::min((front.thickness + back.thickness) / 2, back.z - front.z);
    }
    /// Not less than that of any two plies, m.
    [[nodiscard]] double most() const { return most_; }
    /// What lies farther behind a mid-surface than this is not touched, m.
    [[nodiscard]] double depth() const { return depth_; }
    /// The same where no ply is thicker than this, m.
    [[nodiscard]] static double depth_of(double thickness);

  private:
    std::vector<PlyProperties> plies_;
    double most_ = 0, depth_ = 0;
};

}  // namespace weavefront::contact
