#pragma once
/// @file
/// Hysteretic penalty pressure at one contact point.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "weavefront/contact/sliding_energy.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/simd/lanes.hpp"

namespace weavefront::contact {

using namespace simd;

/// State of a contact point that lasts from step to step.
struct Penetration {
    double overlap = 0;  ///< geometric overlap at the last step, m; 0: apart
    double ignored = 0;  ///< part of the overlap that motion did not cause, m; it does not press
    double opened = 0;   ///< opening of the two sides since their closest approach, m

    /// The penetration g that presses, m.
    [[nodiscard]] double present() const { return overlap - ignored; }

    template <class Archive>
    void state(Archive& archive) {
        archive("overlap", overlap);
        archive("ignored", ignored);
        archive("opened", opened);
    }
};

/// State of the points of a batch.
struct PenetrationLanes {
    Lanes overlap{}, ignored{}, opened{};
};

/// Relative motion of the two sides of a contact point over the last step.
struct RelativeMotion {
    double closing;  ///< rate of approach along the force, m/s
    double normal;   ///< rate of the overlap due to `closing`, m/s; smaller where the overlap is measured
                     ///< along another direction
    double most;     ///< upper bound of the rate of the overlap due to any relative motion, m/s
};

/// Relative motion of the points of a batch, whose overlap is measured along the force.
struct RelativeMotionLanes {
    Lanes closing, most;
};

/// Input of a point's law that is common to all points of its facet.
struct Surroundings {
    double dissipated_budget = 0;  ///< of the facet at the start of the step, J/m2: see PenaltyLaw
    double sliding_share = 1;      ///< part of the overlap caused by sliding that may press
};

/// Response of a contact point, or sum over the points of a facet, in a step.
struct ContactResponse {
    double pressure = 0;  ///< Pa
    double dissipated =
        0;  ///< dissipated energy less the cost of recovery, J/m2; the facet adds it to its dissipated budget
    SlidingEnergy sliding;
};

/// Hysteretic penalty law: first loading along p = k g, unloading and reloading along the slope u k, no
/// tension. Woven fabric under transverse compression returns little of the work done on it; u = 1 is elastic
/// contact. The stiffness is per area and a property of the fabric. Neither mesh nor time step enters it.
///
/// The penetration grows at most as fast as the two sides move. A faster overlap is a jump of the geometry: a
/// point changes its facet, an element is eroded, or an overlap is found late. The jump is ignored until the
/// sides part; it would push them apart at once. Motion counts in any direction. Where a curved side slides
/// along the other one, the overlap rises ahead and falls behind without approach along the force.
///
/// Only motion along the force loads and unloads. With d the opening since the closest approach, the pressure
/// is p = k g - (u - 1) k d. Without sliding, g + d is the largest penetration, and this is the unloading
/// line through it. A sliding point keeps its d while it presses. A point that has ceased to press and is
/// closed by sliding presses again at once.
///
/// Sliding does no work along the force. So the energy that it stores in points ahead must come from points
/// behind. The law reports both energies. SlidingAccount sums them and sets the share of the overlap caused
/// by sliding that may press, so contact never returns more energy than it has received.
///
/// An ignored overlap recovers: it shrinks slowly. The energy that the point gains by it comes from the
/// dissipated budget of its facet: energy that contact has dissipated there before this step and not yet
/// spent. In each step a point may spend its area's share of that budget, so the order of the points does not
/// matter. Elastic contact, u = 1, dissipates nothing and cannot recover.
class PenaltyLaw {
  public:
    /// @param law     stiffness k (Pa/m), unloading ratio u >= 1, fraction of critical damping
    /// @param density reduced mass per area m1 m2/(m1 + m2) of the two sides, kg/m2
    PenaltyLaw(const scene::ContactLaw& law, double density)
        : stiffness_(law.stiffness),
          unloading_(law.unloading),
          damping_(2 * law.damping * std::sqrt(law.stiffness * density)),
          recovery_rate_(law.unloading > 1 ? std::sqrt(law.unloading * law.stiffness / density) /
                                                 (2 * std::numbers::pi * recovery_periods)
                                           : 0) {}

    /// Advances a point by a step.
    /// @param geometric present overlap, m; negative: apart
    /// @param motion    over the last step
    /// @param dt        the last step, s
    /// @param share     share of the facet's area of the point
    ContactResponse advance(Penetration& point, double geometric, const RelativeMotion& motion, double dt,
                            double share, const Surroundings& around) const {
        const auto step = step_of(point, geometric, motion, dt, share, around);
        point = step.point;
        return step.response;
    }

    /// Advances the points of a batch by a step. Points without a master keep their state and have no
    /// pressure.
    /// @param met points with a master
    /// @param sum the responses of the points are added to it, except for their pressures
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
    // An ignored overlap recovers within this many periods of two plies that oscillate on the unloading line.
    // Recovery pressures then are far below those of the impact. For fabric this takes some 20 us, a fraction
    // of an impact.
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
        const double stored = elastic_energy(approached.point), after = elastic_energy(moved);
        // The mean of the pressures at both ends of the step does its work.
        const double work = (elastic_pressure(before) + elastic_pressure(moved)) / 2 * motion.closing * dt;
        const double dissipated = work - (stored - elastic_energy(before));

        // Cost of recovery per metre: at most the pressure of first loading at the largest penetration, plus
        // half of the pressure that it adds over the opening of this step.
        const double recovery = std::min(recovery_rate_ * dt, 1.0) * moved.ignored,
                     opening = std::max(-motion.closing * dt, 0.0);
        const double price = stiffness_ * (moved.present() + std::max(moved.opened, recovery)) +
                             unloading_ * stiffness_ * opening / 2;
        const double affordable = std::max(around.dissipated_budget, 0.0);
        const auto end =
            with_less_ignored(moved, recovery * price > affordable ? affordable / price : recovery);
        const double added = elastic_pressure(end) - elastic_pressure(moved);
        const double cost = elastic_energy(end) - after + added * opening / 2;

        const double elastic = elastic_pressure(end),
                     pressure = std::max(elastic + damping_ * motion.closing, 0.0);
        const bool presses = elastic > 0;
        const double damped = presses ? (pressure - elastic) * motion.closing * dt : 0.0;
        const SlidingEnergy sliding{share * std::max(stored - after, 0.0),
                                    share * std::max(after - stored, 0.0),
                                    share * std::max(elastic_energy(approached.whole()) - stored, 0.0)};
        return {{end.overlap, end.ignored, end.present() > 0 ? end.opened : 0.0},
                {presses ? pressure : 0.0, share * (dissipated + damped - cost), sliding}};
    }

    /// A point after the motion along the force, before sliding.
    struct Approached {
        Penetration point;
        double present;  ///< penetration with sliding, m

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
        // At its first contact a point has approached by no more than its penetration.
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

    [[nodiscard, gnu::always_inline]] static Penetration with_less_ignored(const Penetration& point,
                                                                           double recovery) {
        return {point.overlap, point.ignored - recovery, std::max(point.opened - recovery, 0.0)};
    }

    [[nodiscard, gnu::always_inline]] double elastic_pressure(const Penetration& point) const {
        return std::max(stiffness_ * (point.present() - (unloading_ - 1) * point.opened), 0.0);
    }

    /// Energy that a point returns when it opens, J/m2.
    [[nodiscard, gnu::always_inline]] double elastic_energy(const Penetration& point) const {
        const double pressure = elastic_pressure(point);
        return pressure * pressure / (2 * unloading_ * stiffness_);
    }

    double stiffness_, unloading_, damping_;
    double recovery_rate_;  ///< 1/s
};

}  // namespace weavefront::contact
