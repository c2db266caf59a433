#pragma once
/// @file
/// A tighter bound on the frequency of a group of elements than ElementGroup::frequencies.

#include <Eigen/Core>
#include <optional>
#include <span>

#include "weavefront/shell/coupling.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/simd/vectors.hpp"

namespace weavefront::shell {

/// Bounds omega^2 of motion in the elements' planes with free crossovers and a coupling of fill and warp.
/// It views the group's present state. Only the consistent formulation has the tangent that the bound needs.
class TightBound {
  public:
    /// @param group of the consistent formulation; it outlives the bound
    explicit TightBound(const ElementGroup& group);

    /// Raises each bound to at least the omega^2 of every alive element, or to its limit. There is one bound
    /// for each of `couplings`.
    /// @param x positions of the local nodes, m
    void raise(const TighteningStart& start, std::span<const Eigen::Vector3d> x, TightBounds& bounds) const;

    /// omega^2 of the alive elements as if their yarns were slack and at right angles, 1/s2; 0 where the
    /// fabric has no crimp. It depends on the stretches and the crossover alone.
    /// @param coupling_factor one of `couplings`
    [[nodiscard]] double slack_frequency(double coupling_factor) const;

  private:
    void raise(std::int32_t pack, std::int32_t at, const TighteningStart& start,
               const std::array<Vector<simd::Pack>, 4>& x, TightBounds& bounds) const;

    const ElementGroup& group_;
    double coupling_at_rest_;  ///< N/m
};

/// What makes elements stiffer than a tight bound allows for.
struct StiffeningTrigger {
    double slack_frequency = 0;         ///< omega^2 of slack yarns, 1/s2: above it they have straightened
    double coupling_factor = 0;         ///< one of `couplings`, for which slack_frequency holds
    bool awaits_first_packing = false;  ///< no rank has packed yarns; the first ones stiffen their element
};

/// Checks a trigger in every step of a group from now on. @param trigger none: checks nothing
void monitor_stiffening(ElementGroup& group, const std::optional<StiffeningTrigger>& trigger);

}  // namespace weavefront::shell
