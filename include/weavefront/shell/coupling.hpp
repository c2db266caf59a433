#pragma once
/// @file
/// The null Lagrangian (translation) term that tightens the bound on the frequency.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/critical_frequency.hpp"

namespace weavefront::shell {

/// Factors c, over that of the fabric at rest, of a term that cancels in the sum over a ply, so that it may
/// be taken from each of its elements before the worst one is looked for. The term is the area projected onto
/// one plane; its second variation, 2 c n.(dg_f x dg_w), sums to a term on free edges alone.
///
/// A panel is softer than its worst element where its elements cannot all be in their worst mode at once:
/// fill and warp that stretch together come apart. Of slack crimped yarns, whose tangent in the two stretches
/// is (a, b; b, a), a + b becomes a with c = b.
///
/// The best factor counts for the whole model. The bound is convex in c, so an eighth between two of them
/// costs little, and neighbours tell where the best one is.
inline constexpr std::array<double, 10> couplings{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125};

/// Bounds on `in_plane` by coupling, 1/s2.
using TightBounds = std::array<double, couplings.size()>;

/// What tighter bounds start from.
struct TighteningStart {
    TightBounds least;     ///< where the search starts; `limit`: this one is not tried, 1/s2
    double limit;          ///< bounds that reach it are of no use and are not followed further, 1/s2
    double out_of_plane;   ///< bound on the motion out of the elements' planes, 1/s2
    double hourglass;      ///< on hourglass modes in them, 1/s2
    Eigen::Vector3d axis;  ///< unit normal of the plane onto which areas are projected
};

}  // namespace weavefront::shell
