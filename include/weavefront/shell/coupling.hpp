#pragma once
/// @file
/// The coupling of fill and warp, a null Lagrangian term, that tightens the bound on the frequency.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/critical_frequency.hpp"

namespace weavefront::shell {

/// Coupling of fill and warp: the second variation c 2 n.(dg_f x dg_w) of c times the projected area of a
/// ply.
///
/// The worst mode of an element stretches fill and warp together. Neighbours cannot all do the same, so a
/// panel is softer than its worst element. Slack crimped yarns show this best: their tangent in the two
/// stretches is (a, b; b, a). Its eigenvalue a + b becomes a with c = b.
///
/// Each element gives up its part of the coupling before the largest omega^2 is sought. The projected area of
/// a ply depends on its edge alone. So the parts cancel in the sum over the ply, except on free edges.
///
/// `couplings` holds the c that are tried, in units of the coupling of the fabric at rest. One c serves the
/// whole model. The bound is convex in c, so neighbours in the list tell where the best c is.
inline constexpr std::array<double, 10> couplings{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1, 1.125};

/// Bounds on omega^2 of motion in the plane, one for each of `couplings`, 1/s2.
using TightBounds = std::array<double, couplings.size()>;

/// What the search for tight bounds starts from.
struct TighteningStart {
    TightBounds least;     ///< where the search for each coupling starts, 1/s2
    TightBounds limits;    ///< where it ends without success; a coupling that starts there is not tried, 1/s2
    double out_of_plane;   ///< bound on the motion out of the elements' planes, 1/s2
    double hourglass;      ///< bound on hourglass modes in the planes, 1/s2
    Eigen::Vector3d axis;  ///< unit normal of the plane onto which areas are projected
};

}  // namespace weavefront::shell
