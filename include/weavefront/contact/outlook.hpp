#pragma once
/// @file
/// What a facet has around it.

#include <array>
#include <cstdint>
#include <span>

#include "weavefront/contact/facet_runs.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/touching.hpp"

namespace weavefront::contact {

/// What a facet knows of its candidates; they may approach by so much, see Approach, until it has to look again.
struct Outlook {
    double room = 0;          ///< m: the facet touches nothing before something has approached by this; 0 where it may touch at once
    std::int32_t first = -1;  ///< otherwise, the candidate that its points try first; -1: not known
    double lead = 0;          ///< m: and it stays so until something has approached by this
};

/// Looks from one facet at its candidates.
/// @param f          the facet, with its corners (m) and those of the part that its points span (m)
/// @param enough     less room than this is not worth knowing, m
Outlook look_around(std::int32_t f, const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& spanned, const FacetRuns& candidates,
                    const Surface& surface, const Touching& touching, std::span<const Vec3> x, double enough);

}  // namespace weavefront::contact
