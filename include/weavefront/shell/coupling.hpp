#pragma once
/// @file
/// The null Lagrangian (translation) term that tightens the bound on the frequency.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/critical_frequency.hpp"

namespace weavefront::shell {

/// Multiples c of the area of a ply projected onto one plane; 1 is the coupling of the fabric at rest. Each
/// element gives up its part of c times that area before the largest omega^2 is sought. The parts cancel in
/// the sum over the ply: the second variation, 2 c n.(dg_f x dg_w), acts on free edges alone.
///
/// The worst mode of an element stretches fill and warp together. Its neighbours cannot all do the same, so
/// a panel is softer than its worst element. Slack crimped yarns have the tangent (a, b; b, a) in the two
/// stretches: its eigenvalue a + b becomes a with c = b.
///
/// One c serves the whole model. The bound is convex in c: steps of an eighth cost little, and neighbours
/// tell where the best c is.
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
