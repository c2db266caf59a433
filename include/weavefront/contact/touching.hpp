#pragma once
/// @file
/// How near plies come before they press.

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
        return distances_[static_cast<std::size_t>(ply) * plies_ + static_cast<std::size_t>(other)];
    }
    /// Not less than that of any two plies, m.
    [[nodiscard]] double most() const { return most_; }
    /// What lies farther behind a mid-surface than this is not touched, m.
    [[nodiscard]] double depth() const { return depth_; }
    /// The same where no ply is thicker than this, m.
    [[nodiscard]] static double depth_of(double thickness);

  private:
    std::size_t plies_;
    std::vector<double> distances_;
    double most_ = 0, depth_ = 0;
};

}  // namespace weavefront::contact
