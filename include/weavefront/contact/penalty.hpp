#pragma once
/// @file
/// Hysteretic penalty pressure at one contact point.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weavefront/contact/lanes.hpp"
#include "weavefront/contact/sliding_energy.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// What a contact point remembers.
struct Penetration {
    double overlap = 0;  ///< geometric, as last seen, m; 0: apart
    double ignored = 0;  ///< part of it that motion did not bring about, m: it presses nothing
    double opened = 0;   ///< by how much the sides have opened from their closest approach, m

    /// The penetration g that presses, m.
    [[nodiscard]] double present() const { return overlap - ignored; }

    template <class Archive>
    void state(Archive& archive) {
        archive("overlap", overlap);
        archive("ignored", ignored);
        archive("opened", opened);
    }
};

/// What the points of a batch remember.
struct PenetrationLanes {
    Lanes overlap{}, ignored{}, opened{};
};

/// How the two sides of a contact point have moved over the last step.
struct RelativeMotion {
    double closing;  ///< rate of approach along the force, m/s
    double normal;   ///< rate at which that approach changes the overlap, m/s: less where the overlap is
                     ///< measured along another direction
    double most;     ///< bound on the rate at which any relative motion changes the overlap, m/s
};

/// The same for the points of a batch whose overlap is measured along the force.
struct RelativeMotionLanes {
    Lanes closing, most;
};

/// What a point knows of those around it.
struct Surroundings {
    double dissipated_budget =
        0;  ///< of the facet before any of its points was advanced in this step, J/m2: see PenaltyLaw
    double sliding_share = 1;  ///< part of the overlap brought about by sliding that may press
};

/// What a contact point, or the points of a facet, do over a step.
struct ContactResponse {
    double pressure = 0;  ///< Pa
    double dissipated =
        0;  ///< less what recovery has cost: goes to the facet's dissipated budget, J/m2, see PenaltyLaw
    SlidingEnergy sliding;
};

/// Pressure over penetration g: loading along k g; unloading and reloading along the slope u k; never
/// tensile. Woven fabric under transverse compression returns little of the work done on it; u = 1 is the
/// elastic contact of the paper's time. The stiffness is per area and belongs to the fabric: mesh and time
/// step do not enter.
///
/// The penetration follows the geometry as far as the two sides can have moved. An overlap that appears
/// faster is a jump of the geometry (a facet changes, an element disappears, an overlap is found late): it is
/// ignored until the sides part, so that nothing is pushed out at once. Motion counts in any direction: where
/// a curved side slides along the other one, the overlap changes without any approach along the force, rises
/// ahead and falls behind.
///
/// Only approach along the force loads and unloads: with d the way by which the sides have opened since their
/// closest approach, p = k g - (u - 1) k d. Without sliding, g + d is the largest penetration and this is the
/// unloading line through it. Points that slide keep their d as long as they press; where sliding closes a
/// point that has ceased to press, it presses again at once.
///
/// Sliding does no work along the force, so what it stores in the points ahead must come from those behind.
/// The points report both; whoever adds them up says which share of the overlap by sliding may press, so that
/// contact never gives more than it has taken.
///
/// An ignored overlap recovers: it shrinks slowly, and the energy that the point can then give back is taken
/// from the dissipated budget of the facet: what contact has dissipated there before this step and not yet
/// spent. In each step a point may spend the part of that budget that its area is of the facet's; what it
/// gets does not depend on the order of the points. Elastic contact, u = 1, gives back all that it takes and
/// has nothing to recover with.
class PenaltyLaw {
  public:
    /// @param law     stiffness k (Pa/m), unloading ratio u >= 1, fraction of critical damping
    /// @param density mass per area that the contact moves: m1 m2/(m1 + m2) of the two sides, kg/m2
    PenaltyLaw(const scene::ContactLaw& law, double density)
        : stiffness_(law.stiffness),
          unloading_(law.unloading),
          damping_(2 * law.damping * std::sqrt(law.stiffness * density)),
          recovery_rate_(law.unloading > 1 ? std::sqrt(law.unloading * law.stiffness / density) /
                                                 (2 * std::numbers::pi * recovery_periods)
                                           : 0) {}

    /// Advances a point.
    /// @param geometric overlap seen now, m; negative when apart
    /// @param motion    over the last step
    /// @param dt        the last step, s
    /// @param share     of the facet's area that the point stands for
    ContactResponse advance(Penetration& point, double geometric, const RelativeMotion& motion, double dt,
                            double share, const Surroundings& around) const {
        const auto step = step_of(point, geometric, motion, dt, share, around);
        point = step.point;
        return step.response;
    }

    /// The same for the points of a batch; those that have not met anything stay as they are and have no
    /// pressure.
    /// @param sum of what all points do, but for their pressures: added to
    [[nodiscard]] Lanes advance(PenetrationLanes& points, const LaneMask& met, const Lanes& geometric,
                                const RelativeMotionLanes& motion, double dt, const Lanes& share,
                                const Surroundings& around, ContactResponse& sum) const {
        PenetrationLanes next;
        Lanes pressure, dissipated, released, taken, wanted;
        for (std::size_t i = 0; i < batch_width; ++i) {
            const RelativeMotion of_point{motion.closing[i], motion.closing[i], motion.most[i]};
            const auto [point, response] = step_of({points.overlap[i], points.ignored[i], points.opened[i]},
                                                   geometric[i], of_point, dt, share[i], around);
            next.overlap[i] = point.overlap, next.ignored[i] = point.ignored, next.opened[i] = point.opened;
            pressure[i] = response.pressure, dissipated[i] = response.dissipated;
            released[i] = response.sliding.released, taken[i] = response.sliding.taken,
            wanted[i] = response.sliding.wanted;
        }
        for (std::size_t i = 0; i < batch_width; ++i) {
            if (met[i]) {
                points.overlap[i] = next.overlap[i], points.ignored[i] = next.ignored[i],
                points.opened[i] = next.opened[i];
                sum.dissipated += dissipated[i];
                sum.sliding.add({released[i], taken[i], wanted[i]});
            } else {
                pressure[i] = 0;
            }
        }
        return pressure;
    }

  private:
    // An overlap recovers within this many periods of two plies on the unloading line of the contact: so
    // slowly that they are moved apart by pressures far below those that made it, and within some 20 us for
    // stiffnesses of fabric, a fraction of an impact.
    static constexpr double recovery_periods = 100;

    struct Step {
        Penetration point;
        ContactResponse response;
    };
    [[nodiscard, gnu::always_inline]] Step step_of(const Penetration& before, double geometric,
                                                   const RelativeMotion& motion, double dt, double share,
                                                   const Surroundings& around) const {
        const auto approached = approach(before, geometric, motion, dt);
        const auto moved = slide(approached, around.sliding_share);
        const double stored = recoverable(approached.point), after = recoverable(moved);
        // The work of a step is that of the mean of the pressures at its ends.
        const double work = (elastic_pressure(before) + elastic_pressure(moved)) / 2 * motion.closing * dt;
        const double dissipated = work - (stored - recoverable(before));

        // A metre of recovery costs at most the pressure that first loading has at the largest penetration
        // and, as the pressure is higher from now on, half of what it adds to it over what the sides open.
        const double recovery = std::min(recovery_rate_ * dt, 1.0) * moved.ignored,
                     opening = std::max(-motion.closing * dt, 0.0);
        const double price = stiffness_ * (moved.present() + std::max(moved.opened, recovery)) +
                             unloading_ * stiffness_ * opening / 2;
        const double affordable = std::max(around.dissipated_budget, 0.0);
        const auto end = recovered(moved, recovery * price > affordable ? affordable / price : recovery);
        const double added = elastic_pressure(end) - elastic_pressure(moved);
        const double cost = recoverable(end) - after + added * opening / 2;

        const double elastic = elastic_pressure(end),
                     pressure = std::max(elastic + damping_ * motion.closing, 0.0);
        const bool presses = elastic > 0;
        const double damped = presses ? (pressure - elastic) * motion.closing * dt : 0.0;
        const SlidingEnergy sliding{share * std::max(stored - after, 0.0),
                                    share * std::max(after - stored, 0.0),
                                    share * std::max(recoverable(approached.whole()) - stored, 0.0)};
        return {{end.overlap, end.ignored, end.present() > 0 ? end.opened : 0.0},
                {presses ? pressure : 0.0, share * (dissipated + damped - cost), sliding}};
    }

    /// A point after the approach of a step, without sliding.
    struct Approached {
        Penetration point;
        double present;  ///< penetration that sliding makes of it, m

        [[nodiscard]] Penetration whole() const {
            return {point.overlap, point.overlap - present, point.opened};
        }
    };
    [[nodiscard, gnu::always_inline]] static Approached approach(const Penetration& before, double geometric,
                                                                 const RelativeMotion& motion, double dt) {
        const double overlap = std::max(geometric, 0.0),
                     jump = std::max(overlap - before.overlap - motion.most * dt, 0.0);
        const double present = overlap - std::min(before.ignored + jump, overlap),
                     change = motion.normal * dt;
        const bool was_pressed = before.present() > 0;
        const double opened = std::max((was_pressed ? before.opened : 0.0) - change, 0.0);
        // A point that comes in approaches by no more than it is in.
        const double approached = std::max(before.present() + change, 0.0),
                     without_sliding = was_pressed ? approached : std::min(approached, present);
        return {{overlap, overlap - without_sliding, opened}, present};
    }

    [[nodiscard, gnu::always_inline]] Penetration slide(Approached approached, double share) const {
        auto& [point, present] = approached;
        if (present > point.present() && unloading_ > 1)
            point.opened = std::min(point.opened, point.present() / (unloading_ - 1));
        const double refused = (1 - share) * std::max(present - point.present(), 0.0);
        return {point.overlap, point.overlap - present + refused, point.opened};
    }

    [[nodiscard, gnu::always_inline]] static Penetration recovered(const Penetration& point,
                                                                   double recovery) {
        return {point.overlap, point.ignored - recovery, std::max(point.opened - recovery, 0.0)};
    }

    [[nodiscard, gnu::always_inline]] double elastic_pressure(const Penetration& point) const {
        return std::max(stiffness_ * (point.present() - (unloading_ - 1) * point.opened), 0.0);
    }

    /// What a point gives back when it opens, J/m2.
    [[nodiscard, gnu::always_inline]] double recoverable(const Penetration& point) const {
        const double pressure = elastic_pressure(point);
        return pressure * pressure / (2 * unloading_ * stiffness_);
    }

    double stiffness_, unloading_, damping_;
    double recovery_rate_;  ///< 1/s
};

}  // namespace weavefront::contact
