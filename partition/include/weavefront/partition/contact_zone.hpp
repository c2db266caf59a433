#pragma once
/// @file
/// A forecast of the zone in which plies are in contact.

#include <array>
#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// A disc around each shot that grows with the transverse wave. In it plies press on each other or are near
/// enough to be evaluated in every step. Its radius is that of the projectile plus 0.24 c^(2/3) V^(1/3) t,
/// where c is the fastest longitudinal wave speed of the yarns and V the speed of the projectile. Without
/// contact between plies it does not grow. Of several shots the widest and the fastest projectile make the
/// discs of all, and all start at once.
class ContactZone {
  public:
    explicit ContactZone(const scene::Scene& scene);

    /// @param time s @return m; below 0: no contact
    [[nodiscard]] double radius(double time) const { return start_ + speed_ * time; }

    /// Share of the run, up to scene.time.end, during which a point is within the zone.
    /// @param distance from the axis of the shot, m
    /// @param decay weight of time: falls linearly from 1 at the start of the run to 1 - decay at its end
    [[nodiscard]] double contact_time_share(double distance, double decay = 0) const;

    /// Weight of the projectile's pressure on a stack of plies, during nearly all of the run: 1 on its axis,
    /// falling to a half at the distance of its diameter, 0 beyond. It is 0 without contact between plies.
    /// @param distance from the axis of the shot, m
    [[nodiscard]] double press_weight(double distance) const {
        return plies_ && distance < 2 * start_ ? 1 - distance / (4 * start_) : 0;
    }

    /// Distances of the centres of all columns from the axis of the nearest shot, m.
    [[nodiscard]] std::vector<double> distances(const mesh::Panel& panel) const;

    /// Whether there is contact between plies, so elements away from the shot have a cost of contact, too.
    [[nodiscard]] bool plies() const { return plies_; }

  private:
    double start_ = -1, speed_ = 0, end_ = 0;
    std::vector<std::array<double, 2>> axes_{{0, 0}};
    bool plies_ = false;
};

/// Speed of the longitudinal wave in straight yarns of a fabric, sqrt(E1 S/(s m)) with the areal density m,
/// m/s.
double wave_speed(const scene::Fabric& fabric);

/// Largest wave speed of the fabrics of the target's plies, m/s.
double largest_wave_speed(const scene::Scene& scene);

}  // namespace weavefront::partition
