#pragma once
/// @file
/// What the elements of a ply lend each other before the worst of them bounds the frequency.

#include <Eigen/Core>
#include <array>

#include "weavefront/shell/critical_frequency.hpp"

namespace weavefront::shell {

/// Terms that cancel in the sum over a ply, so that they may be taken from each of its elements before the worst one is looked for. A panel
/// is softer than its worst element where not all of its elements can be in their worst mode at once; these tell.
///
/// - coupling: the same multiple c of the area projected onto one plane. Its second variation, 2 c n.(dg_f x dg_w), sums to a term on free
///   edges alone. In it fill and warp that stretch together come apart: of slack crimped yarns, whose tangent in the two stretches
///   is (a, b; b, a), a + b becomes a with c = b.
/// - lent mass: a part m of a quarter of the smallest element's mass, from corners 2 and 4 to corners 1 and 3. Around a node each kind
///   meets twice. In packed yarns one diagonal of an element is stiffer than the other.
struct Lending {
    double coupling;  ///< c over that of the fabric at rest, 1
    double mass;      ///< m, 1
};

/// Largest part of mass that is lent.
inline constexpr double most_lent = 0.5;

/// The ones that may be tried; the best counts for the whole model. The bound is convex in c, so an eighth between two of them costs
/// little, and neighbours tell where the best one is.
inline constexpr std::array<Lending, 12> lendings{{{0, 0},
                                                   {0.125, 0},
                                                   {0.25, 0},
                                                   {0.375, 0},
                                                   {0.5, 0},
                                                   {0.625, 0},
                                                   {0.75, 0},
                                                   {0.875, 0},
                                                   {1, 0},
                                                   {1.125, 0},
                                                   {0, most_lent},
                                                   {0, -most_lent}}};

/// Bounds on `along` by lending, 1/s2.
using SharperBounds = std::array<double, lendings.size()>;

/// What sharper bounds start from.
struct SharpeningStart {
    SharperBounds least;   ///< where the search starts; `limit`: this one is not tried, 1/s2
    double limit;          ///< bounds that reach it are of no use and are not followed further, 1/s2
    double across;         ///< bound on the motion out of the elements' planes, 1/s2
    double hourglass;      ///< on hourglass modes in them, 1/s2
    Eigen::Vector3d axis;  ///< unit normal of the plane onto which areas are projected
    double smallest_area;  ///< of all elements, initial, m2
};

}  // namespace weavefront::shell
