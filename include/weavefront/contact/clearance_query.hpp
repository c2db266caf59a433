#pragma once
/// @file
/// What a facet has around it.

#include <cstddef>
#include <cstdint>
#include <span>

#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/contact_points.hpp"
#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A float that is not above a number, nor much below if that is positive.
[[nodiscard]] inline float not_above(double value) {
    return static_cast<float>(value) * (value > 0 ? 1 - 0x1p-22F : 1 + 0x1p-22F);
}

/// What a facet looks at.
struct ClearanceQuery {
    std::int32_t ply;             ///< that of the facet
    const ContactPoints& points;  ///< of the facet
    const FacetRanges& candidates;
    const Surface& surface;
    const ContactDistances& distances;
    std::span<const Vec3> x;  ///< m
};

/// Which candidates of a facet are near.
struct [[gnu::packed]] Shortlist {
    float until = 0;  ///< m: as long as the approach, see RelativeMotionBound, is less, the others leave the
                      ///< difference as room
    std::uint32_t slots = 0;  ///< in the list of candidates, a bit each

    static constexpr std::size_t longest = 32;
    [[nodiscard]] bool holds(std::size_t slot) const { return slot < longest && (slots >> slot & 1U) != 0; }
};

/// By how much something may approach, see RelativeMotionBound, until a facet may touch one of its
/// candidates, m.
/// @param nearest   the candidate to look at first, or -1
/// @param shortlist of the candidates; only these are looked at while it holds, then it is renewed
/// @param accumulated    the approach now, m
/// @param worthwhile    less than this is not worth knowing: 0 is returned instead, m
double clearance(const ClearanceQuery& query, std::int32_t nearest, Shortlist& shortlist, double accumulated,
                 double worthwhile);

/// The candidate whose centre is nearest to that of a facet.
struct Nearest {
    std::int32_t facet = -1;  ///< -1: not known, as candidates lie in more than one ply
    double lead =
        0;  ///< m: it stays the nearest until something has approached by this, see RelativeMotionBound
};

/// @param centre of the facet, m
Nearest find_nearest(const ClearanceQuery& query, const Vec3& centre);

}  // namespace weavefront::contact
