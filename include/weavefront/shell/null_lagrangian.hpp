#pragma once
/// @file
/// Null Lagrangian (translation) terms that tighten the bound on the frequency.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/critical_frequency.hpp"

namespace weavefront::shell {

/// Terms that cancel in the sum over a ply, so that they may be taken from each of its elements before the
/// worst one is looked for. A panel is softer than its worst element where not all of its elements can be in
/// their worst mode at once; these tell.
///
/// - coupling: the same multiple c of the area projected onto one plane. Its second variation, 2 c n.(dg_f x
/// dg_w), sums to a term on free
///   edges alone. In it fill and warp that stretch together come apart: of slack crimped yarns, whose tangent
///   in the two stretches is (a, b; b, a), a + b becomes a with c = b.
/// - mass redistribution: a part m of a quarter of the smallest element's mass, from corners 2 and 4 to
/// corners 1 and 3. Around a node each kind
///   meets twice. In packed yarns one diagonal of an element is stiffer than the other.
struct NullLagrangian {
    double coupling;  ///< c over that of the fabric at rest, 1
    double mass;      ///< m, 1
};

/// Largest part of mass that is redistributed.
inline constexpr double most_redistributed = 0.5;

/// The ones that may be tried; the best counts for the whole model. The bound is convex in c, so an eighth
/// between two of them costs little, and neighbours tell where the best one is.
inline constexpr std::array<NullLagrangian, 12> null_lagrangians{{{0, 0},
                                                                  {0.125, 0},
                                                                  {0.25, 0},
                                                                  {0.375, 0},
                                                                  {0.5, 0},
                                                                  {0.625, 0},
                                                                  {0.75, 0},
                                                                  {0.875, 0},
                                                                  {1, 0},
                                                                  {1.125, 0},
                                                                  {0, most_redistributed},
                                                                  {0, -most_redistributed}}};

/// Bounds on `in_plane` by term, 1/s2.
using TightBounds = std::array<double, null_lagrangians.size()>;

/// What tighter bounds start from.
struct TighteningStart {
    TightBounds least;     ///< where the search starts; `limit`: this one is not tried, 1/s2
    double limit;          ///< bounds that reach it are of no use and are not followed further, 1/s2
    double out_of_plane;   ///< bound on the motion out of the elements' planes, 1/s2
    double hourglass;      ///< on hourglass modes in them, 1/s2
    Eigen::Vector3d axis;  ///< unit normal of the plane onto which areas are projected
    double smallest_area;  ///< of all elements, initial, m2
};

}  // namespace weavefront::shell
