#pragma once
/// @file
/// What a facet has around it.

#include <cstddef>
#include <cstdint>
#include <span>

#include "weavefront/contact/facet_runs.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/touching.hpp"
#include "weavefront/contact/viewpoints.hpp"

namespace weavefront::contact {

/// A float that is not above a number, nor much below if that is positive.
[[nodiscard]] inline float not_above(double value) { return static_cast<float>(value) * (value > 0 ? 1 - 0x1p-22F : 1 + 0x1p-22F); }

/// What a facet looks at.
struct Outlook {
    std::int32_t ply;          ///< that of the facet
    const Viewpoints& points;  ///< of the facet
    const FacetRuns& candidates;
    const Surface& surface;
    const Touching& touching;
    std::span<const Vec3> x;  ///< m
};

/// Which candidates of a facet are near.
struct [[gnu::packed]] Shortlist {
    float until = 0;           ///< m: as long as the approach, see Approach, is less, the others leave the difference as room
    std::uint32_t places = 0;  ///< in the list of candidates, a bit each

    static constexpr std::size_t longest = 32;
    [[nodiscard]] bool holds(std::size_t place) const { return place < longest && (places >> place & 1U) != 0; }
};

/// By how much something may approach, see Approach, until a facet may touch one of its candidates, m.
/// @param nearest   the candidate to look at first, or -1
/// @param shortlist of the candidates; only these are looked at while it holds, then it is renewed
/// @param so_far    the approach now, m
/// @param enough    less than this is not worth knowing: 0 is returned instead, m
double room_around(const Outlook& outlook, std::int32_t nearest, Shortlist& shortlist, double so_far, double enough);

/// The candidate whose centre is nearest to that of a facet.
struct Nearest {
    std::int32_t facet = -1;  ///< -1: not known, as candidates lie in more than one ply
    double lead = 0;          ///< m: it stays the nearest until something has approached by this, see Approach
};

/// @param centre of the facet, m
Nearest find_nearest(const Outlook& outlook, const Vec3& centre);

}  // namespace weavefront::contact
