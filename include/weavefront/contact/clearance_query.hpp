#pragma once
/// @file
/// The clearance of a facet, and its nearest candidate.

#include <cstddef>
#include <cstdint>
#include <span>

#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/contact_points.hpp"
#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// A float at most equal to a number. For a positive number it is less by 2^-22 of it at most.
[[nodiscard]] inline float not_above(double value) {
    return static_cast<float>(value) * (value > 0 ? 1 - 0x1p-22F : 1 + 0x1p-22F);
}

/// A facet and its candidates.
struct ClearanceQuery {
    std::int32_t ply;             ///< of the facet
    const ContactPoints& points;  ///< of the facet
    const FacetRanges& candidates;
    const Surface& surface;
    const ContactDistances& distances;
    std::span<const Vec3> x;  ///< m
};

/// The near candidates of a facet.
struct [[gnu::packed]] Shortlist {
    float until = 0;  ///< relative motion up to which the list holds, m; all other candidates are at least as
                      ///< far away as is left of it
    std::uint32_t slots = 0;  ///< one bit for each of the first candidates

    static constexpr std::size_t longest = 32;
    [[nodiscard]] bool holds(std::size_t slot) const { return slot < longest && (slots >> slot & 1U) != 0; }
};

/// Clearance of a facet: a lower bound of its distance to any candidate, less the contact distance, m.
/// Relative motion, see RelativeMotionBound, has to use it up before the facet can touch.
/// @param nearest   candidate measured first, as it mostly has the least clearance; -1: not known
/// @param shortlist near candidates; only they are measured while the list holds, then the list is renewed
/// @param accumulated    relative motion so far, m
/// @param worthwhile    a smaller clearance is returned as 0, m
double clearance(const ClearanceQuery& query, std::int32_t nearest, Shortlist& shortlist, double accumulated,
                 double worthwhile);

/// The candidate whose centre is nearest to the centre of a facet.
struct Nearest {
    std::int32_t facet = -1;  ///< -1: not known, since candidates lie in several plies
    double lead = 0;          ///< relative motion up to which it stays the nearest, m
};

/// Finds the nearest candidate. @param centre of the facet, m
Nearest find_nearest(const ClearanceQuery& query, const Vec3& centre);

}  // namespace weavefront::contact
