#pragma once
/// @file
/// Hysteretic penalty pressure at one contact point.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weavefront/contact/lanes.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// What a contact point remembers.
struct Penetration {
    double present = 0;  ///< g, m; 0: not in contact
    double largest = 0;  ///< since it came into contact, m
};

/// What the points of a batch remember.
struct PenetrationLanes {
    Lanes present{}, largest{};
};

/// What a contact point does over a step.
struct Pressed {
    double pressure;  ///< Pa
    double gained;    ///< by the reserve of the facet, J/m2: see PenaltyLaw
};

/// Pressure over penetration: loading along k g; unloading from the largest penetration, and reloading, along the slope u k; never tensile.
/// Woven fabric under transverse compression returns little of the work done on it; u = 1 is the elastic contact of the paper's time.
/// The stiffness is per area and belongs to the fabric: mesh and time step do not enter.
///
/// The penetration follows the geometry but grows only by relative motion: where the geometry jumps (a facet changes, an overlap is found
/// late, an element disappears) nothing is pushed out at once. What is left late is healed: the penetration creeps up to the geometry, and
/// the energy that it can then give back is taken from the reserve of the facet: what contact has dissipated there before this step and not
/// yet spent. So contact never gives energy. In each step a point may spend the part of the reserve that its area is of the facet's; what
/// it gets does not depend on the order of the points. Elastic contact, u = 1, gives back all that it takes and has nothing to heal with.
class PenaltyLaw {
  public:
    /// @param law     stiffness k (Pa/m), unloading ratio u >= 1, fraction of critical damping
    /// @param density mass per area that the contact moves: m1 m2/(m1 + m2) of the two sides, kg/m2
    PenaltyLaw(const scene::ContactLaw& law, double density)
        : stiffness_(law.stiffness),
          unloading_(law.unloading),
          damping_(2 * law.damping * std::sqrt(law.stiffness * density)),
          healing_rate_(law.unloading > 1 ? std::sqrt(law.unloading * law.stiffness / density) / (2 * std::numbers::pi * healing_periods)
                                          : 0) {}

    /// Advances a point.
    /// @param geometric penetration seen now, m; negative when apart
    /// @param closing   rate at which the two sides approached over the last step, m/s
    /// @param dt        the last step, s
    /// @param share     of the facet's area that the point stands for
    /// @param reserve   of the facet before any of its points was advanced in this step, J/m2
    Pressed advance(Penetration& point, double geometric, double closing, double dt, double share, double reserve) const {
        const auto step = step_of(point, geometric, closing, dt, share, reserve);
        point = step.point;
        return step.pressed;
    }

    /// The same for the points of a batch; those that have not met anything stay as they are and have no pressure.
    /// @param gained by the reserve of the facet, J/m2: added to
    [[nodiscard]] Lanes advance(PenetrationLanes& points, const LaneMask& met, const Lanes& geometric, const Lanes& closing, double dt,
                                const Lanes& share, double reserve, double& gained) const {
        Lanes present, largest, pressure, gains;
        for (std::size_t i = 0; i < batch_width; ++i) {
            const auto step = step_of({points.present[i], points.largest[i]}, geometric[i], closing[i], dt, share[i], reserve);
            present[i] = step.point.present, largest[i] = step.point.largest;
            pressure[i] = step.pressed.pressure, gains[i] = step.pressed.gained;
        }
        for (std::size_t i = 0; i < batch_width; ++i) {
            if (met[i])
                points.present[i] = present[i], points.largest[i] = largest[i], gained += gains[i];
            else
                pressure[i] = 0;
        }
        return pressure;
    }

  private:
    // An overlap heals within this many periods of two plies on the unloading line of the contact: so slowly that they are moved apart by
    // pressures far below those that made it, and within some 20 us for stiffnesses of fabric, a fraction of an impact.
    static constexpr double healing_periods = 100;

    struct Step {
        Penetration point;
        Pressed pressed;
    };
    [[nodiscard]] Step step_of(const Penetration& before, double geometric, double closing, double dt, double share, double reserve) const {
        const auto moved = follow(before, geometric, closing, dt);
        // The work of a step is that of the mean of the pressures at its ends.
        const double work = (elastic_pressure(before) + elastic_pressure(moved)) / 2 * closing * dt;
        const double dissipated = work - (recoverable(moved) - recoverable(before));

        // A metre of creep costs at most the pressure that first loading has at the largest penetration and, as the pressure is higher
        // from now on, half of what it adds to it over what the sides open.
        const double behind = std::max(geometric - moved.present, 0.0), creep = std::min(healing_rate_ * dt, 1.0) * behind;
        const double opened = std::max(-closing * dt, 0.0);
        const double price = stiffness_ * std::max(moved.largest, moved.present + creep) + unloading_ * stiffness_ * opened / 2;
        const double affordable = std::max(reserve, 0.0);
        const auto end = crept(moved, creep * price > affordable ? affordable / price : creep);
        const double added = elastic_pressure(end) - elastic_pressure(moved);
        const double cost = recoverable(end) - recoverable(moved) + added * opened / 2;

        const double elastic = elastic_pressure(end), pressure = std::max(elastic + damping_ * closing, 0.0);
        const double damped = (pressure - elastic) * closing * dt;
        const bool presses = elastic > 0;
        return {{end.present, end.present > 0 ? end.largest : 0.0},
                {presses ? pressure : 0.0, share * (dissipated + (presses ? damped : 0.0) - cost)}};
    }

    /// The point after the motion of a step, without healing.
    [[nodiscard]] static Penetration follow(const Penetration& before, double geometric, double closing, double dt) {
        const double present = std::max(std::min(geometric, before.present + closing * dt), 0.0);
        return {present, std::max(before.largest, present)};
    }

    [[nodiscard]] static Penetration crept(const Penetration& point, double creep) {
        const double present = point.present + creep;
        return {present, std::max(point.largest, present)};
    }

    [[nodiscard]] double elastic_pressure(const Penetration& point) const {
        const double residual = point.largest * (1 - 1 / unloading_);
        return std::max(std::min(stiffness_ * point.present, unloading_ * stiffness_ * (point.present - residual)), 0.0);
    }

    /// What a point gives back when it opens, J/m2.
    [[nodiscard]] double recoverable(const Penetration& point) const {
        const double pressure = elastic_pressure(point);
        return pressure * pressure / (2 * unloading_ * stiffness_);
    }

    double stiffness_, unloading_, damping_;
    double healing_rate_;  ///< 1/s
};

}  // namespace weavefront::contact
