#pragma once
/// @file
/// Where plies are in contact, before anything is computed.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::partition {

/// The disc around the shot that grows with the transverse wave: within it plies are pressed together or near
/// enough to be watched point by point. Its radius is that of the projectile plus 0.24 c^(2/3) V^(1/3) t,
/// with c the speed of the fastest longitudinal wave in the yarns and V that of the projectile; without
/// contact between plies it stays under the projectile.
class ContactZone {
  public:
    explicit ContactZone(const scene::Scene& scene);

    /// @param time s @return m; below 0: no contact
    [[nodiscard]] double radius(double time) const { return start_ + speed_ * time; }

    /// Share of the run up to scene.time.end during which a place is within the zone. @param distance from
    /// the axis of the shot, m
    /// @param decay what contact costs at the beginning of the run counts 1, at its end 1 - decay, in between
    /// linearly
    [[nodiscard]] double contact_time_share(double distance, double decay = 0) const;

    /// How much the projectile presses plies together at a place, during nearly all of the run: 1 in its
    /// middle, falling to a half at the distance of its diameter, nothing beyond; nothing without contact
    /// between plies. @param distance from the axis of the shot, m
    [[nodiscard]] double press_weight(double distance) const {
        return plies_ && distance < 2 * start_ ? 1 - distance / (4 * start_) : 0;
    }

    /// Distances of the centres of all columns from the axis of the shot, m.
    [[nodiscard]] std::vector<double> distances(const mesh::Panel& panel) const;

    /// Whether elements away from the shot are watched, too.
    [[nodiscard]] bool plies() const { return plies_; }

  private:
    double start_ = -1, speed_ = 0, end_ = 0;
    std::array<double, 2> axis_{};
    bool plies_ = false;
};

/// Speed of the longitudinal wave in straight yarns of a fabric, sqrt(E1 S/(s m)) with the areal density m,
/// m/s.
double wave_speed(const scene::Fabric& fabric);

/// The largest of the fabrics of the target's plies.
double largest_wave_speed(const scene::Scene& scene);

}  // namespace weavefront::partition
