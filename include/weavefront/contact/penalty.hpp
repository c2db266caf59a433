#pragma once
/// @file
/// Hysteretic penalty pressure at one contact point.

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Pressure over penetration: loading along k g; unloading from the largest penetration, and reloading, along the slope u k; never tensile.
/// Woven fabric under transverse compression returns little of the work done on it; u = 1 is the elastic contact of the paper's time.
/// The stiffness is per area and belongs to the fabric: mesh and time step do not enter.
///
/// The penetration follows the geometry but grows only by relative motion: where the geometry jumps (a facet changes, an overlap is found
/// late, an element disappears) nothing is pushed out at once. What is left late is healed: the penetration creeps up to the geometry, and
/// the energy that it can then give back is taken from what contact has dissipated in the same facet. So contact never gives energy.
/// Elastic contact, u = 1, gives back all that it takes and has nothing to heal with.
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

    /// Advances a point and returns its pressure, Pa.
    /// @param geometric penetration seen now, m; negative when apart
    /// @param closing   rate at which the two sides approached over the last step, m/s
    /// @param dt        the last step, s
    /// @param share     of the facet's area that the point stands for
    /// @param reserve   what contact has dissipated in the facet and not yet spent on healing, J/m2
    [[nodiscard]] double advance(Penetration& point, double geometric, double closing, double dt, double share, double& reserve) const {
        const auto step = step_of(point, geometric, closing, dt, share);
        reserve += step.dissipated;
        const bool heals = !(step.cost > reserve);
        if (heals) reserve -= step.cost;
        const auto& end = heals ? step.healed : step.loaded;
        reserve += end.damped;
        point = end.point;
        return end.pressure;
    }

    /// The same for the points of a batch in their order; those that have not met anything stay as they are and have no pressure.
    [[nodiscard]] Lanes advance(PenetrationLanes& points, const LaneMask& met, const Lanes& geometric, const Lanes& closing, double dt,
                                const Lanes& share, double& reserve) const {
        struct EndLanes {
            Lanes present, largest, pressure, damped;
            void set(std::size_t i, const End& end) {
                present[i] = end.point.present, largest[i] = end.point.largest, pressure[i] = end.pressure, damped[i] = end.damped;
            }
        };
        EndLanes loaded, healed;
        Lanes dissipated, cost;
        for (std::size_t i = 0; i < batch_width; ++i) {
            const auto step = step_of({points.present[i], points.largest[i]}, geometric[i], closing[i], dt, share[i]);
            loaded.set(i, step.loaded);
            healed.set(i, step.healed);
            dissipated[i] = step.dissipated, cost[i] = step.cost;
        }
        Lanes pressure;
        for (std::size_t i = 0; i < batch_width; ++i) {
            pressure[i] = 0;
            if (!met[i]) continue;
            reserve += dissipated[i];
            const bool heals = !(cost[i] > reserve);
            if (heals) reserve -= cost[i];
            const auto& end = heals ? healed : loaded;
            reserve += end.damped[i];
            points.present[i] = end.present[i], points.largest[i] = end.largest[i], pressure[i] = end.pressure[i];
        }
        return pressure;
    }

  private:
    // An overlap heals within this many periods of two plies on the unloading line of the contact: so slowly that they are moved apart by
    // pressures far below those that made it, and within some 20 us for stiffnesses of fabric, a fraction of an impact.
    static constexpr double healing_periods = 100;

    /// A point at the end of a step.
    struct End {
        Penetration point;
        double pressure;  ///< Pa
        double damped;    ///< by the facet's point, J/m2
    };
    /// A step of a point, with healing and without.
    struct Step {
        double dissipated;  ///< by hysteresis, J/m2
        double cost;        ///< of healing, J/m2; infinite where the penetration does not stay behind the geometry
        End loaded, healed;
    };

    [[nodiscard]] Step step_of(const Penetration& before, double geometric, double closing, double dt, double share) const {
        Penetration point;
        point.present = std::max(std::min(geometric, before.present + closing * dt), 0.0);
        point.largest = std::max(before.largest, point.present);
        // The work of a step is that of the mean of the pressures at its ends.
        const double work = (elastic_pressure(before) + elastic_pressure(point)) / 2 * closing * dt;
        Penetration healed = point;
        healed.present += std::min(healing_rate_ * dt, 1.0) * (geometric - point.present);
        healed.largest = std::max(healed.largest, healed.present);
        const double opened = std::max(-closing * dt, 0.0), added = elastic_pressure(healed) - elastic_pressure(point);
        const double cost = share * (recoverable(healed) - recoverable(point) + added * opened / 2);
        return {.dissipated = share * (work - (recoverable(point) - recoverable(before))),
                .cost = geometric > point.present ? cost : std::numeric_limits<double>::infinity(),
                .loaded = end_of(point, closing, dt, share),
                .healed = end_of(healed, closing, dt, share)};
    }

    [[nodiscard]] End end_of(const Penetration& point, double closing, double dt, double share) const {
        const double present = point.present, largest = point.largest;
        const double elastic = present > 0 ? elastic_pressure(point) : 0.0, pressure = std::max(elastic + damping_ * closing, 0.0);
        const double damped = share * (pressure - elastic) * closing * dt;
        return {.point = {present > 0 ? present : 0.0, present > 0 ? largest : 0.0},
                .pressure = elastic > 0 ? pressure : 0.0,
                .damped = elastic > 0 ? damped : 0.0};
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
