#pragma once
/// @file
/// What a facet has around it.

#include <array>
#include <cstdint>
#include <span>

#include "weavefront/contact/facet_runs.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/touching.hpp"
#include "weavefront/contact/viewpoints.hpp"

namespace weavefront::contact {

/// The candidate whose centre is nearest to that of a facet.
struct Nearest {
    std::int32_t facet = -1;  ///< -1: not known, as candidates lie in more than one ply
    double lead = 0;          ///< m: it stays the nearest until something has approached by this, see Approach
};

/// @param ply    that of the facet
/// @param centre of the facet, m
Nearest find_nearest(std::int32_t ply, const Vec3& centre, const FacetRuns& candidates, const Surface& surface, std::span<const Vec3> x);

/// By how much something may approach, see Approach, until a facet may touch one of its candidates, m.
/// @param ply    that of the facet
/// @param points of the facet
/// @param nearest the candidate to look at first, or -1
/// @param enough less than this is not worth knowing: 0 is returned instead, m
double room_around(std::int32_t ply, const Viewpoints& points, std::int32_t nearest, const FacetRuns& candidates, const Surface& surface,
                   const Touching& touching, std::span<const Vec3> x, double enough);

}  // namespace weavefront::contact
