#pragma once
/// @file
/// How near plies come before they press.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Distances of mid-surfaces at which plies touch.
class ContactDistances {
  public:
    /// Of the distance at which two plies lie at the start: by so much they come nearer before they press,
    /// where they lie on one another. They do not press at rest, and crowns of yarns meet one by one. Without
    /// it rounding decides at every point of a stack whether it presses, which takes three times the time.
    /// Ours: a shot at six plies that touch dishes them 0.4 % less with it, 0.2 % less with 5 %.
    static constexpr double slack = 0.075;

    explicit ContactDistances(const std::vector<PlyProperties>& plies);

    /// Of two plies, the nearer to the shot first, m.
    [[nodiscard]] double between(std::int32_t ply, std::int32_t other) const {
        const auto &front = plies_[static_cast<std::size_t>(ply)],
                   &back = plies_[static_cast<std::size_t>(other)];
        return std::min((front.thickness + back.thickness) / 2, (1 - slack) * (back.z - front.z));
    }
    /// Not less than that of any two plies, m.
    [[nodiscard]] double most() const { return most_; }
    /// What lies farther behind a mid-surface than this is not touched, m.
    [[nodiscard]] double max_penetration() const { return max_penetration_; }
    /// The same where no ply is thicker than this, m.
    [[nodiscard]] static double max_penetration_of(double thickness);

  private:
    std::vector<PlyProperties> plies_;
    double most_ = 0, max_penetration_ = 0;
};

}  // namespace weavefront::contact
