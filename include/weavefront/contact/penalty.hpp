#pragma once
/// @file
/// Hysteretic penalty pressure at one contact point.

#include <algorithm>
#include <cmath>

#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// What a contact point remembers.
struct Penetration {
    double present = 0;  ///< g, m; 0: not in contact
    double largest = 0;  ///< since it came into contact, m
};

/// Pressure over penetration: loading along k g; unloading from the largest penetration, and reloading, along the slope u k; never tensile.
/// Woven fabric under transverse compression returns little of the work done on it; u = 1 is the elastic contact of the paper's time.
/// The stiffness is per area and belongs to the fabric: mesh and time step do not enter.
class PenaltyLaw {
  public:
    /// @param law     stiffness k (Pa/m), unloading ratio u >= 1, fraction of critical damping
    /// @param density mass per area that the contact moves: m1 m2/(m1 + m2) of the two sides, kg/m2
    PenaltyLaw(const scene::ContactLaw& law, double density)
        : stiffness_(law.stiffness), unloading_(law.unloading), damping_(2 * law.damping * std::sqrt(law.stiffness * density)) {}

    /// Advances a point and returns its pressure, Pa.
    ///
    /// The penetration follows the geometry but grows only by relative motion: where the geometry jumps (a facet changes, an
    /// overlap is found late, an element disappears) nothing is pushed out at once, and no energy comes from nowhere.
    /// @param geometric penetration seen now, m; negative when apart
    /// @param closing   rate at which the two sides approached over the last step, m/s
    /// @param dt        the last step, s
    [[nodiscard]] double advance(Penetration& point, double geometric, double closing, double dt) const {
        point.present = std::min(geometric, point.present + closing * dt);
        if (!(point.present > 0)) {
            point = {};
            return 0;
        }
        point.largest = std::max(point.largest, point.present);
        const double residual = point.largest * (1 - 1 / unloading_);
        const double elastic = std::min(stiffness_ * point.present, unloading_ * stiffness_ * (point.present - residual));
        return elastic > 0 ? std::max(elastic + damping_ * closing, 0.0) : 0.0;
    }

  private:
    double stiffness_, unloading_, damping_;
};

}  // namespace weavefront::contact
