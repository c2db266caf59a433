#pragma once
/// @file
/// Facets that have passed through the next ply.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Owned facets whose centre lies behind an alive facet of the next ply by more than the contact distance, as
/// seen along their normal. Facets on free edges do not count on either side.
/// @param x present positions, m
std::vector<std::int32_t> facets_behind_next_ply(const Surface& surface, const Candidates& candidates,
                                                 const ContactDistances& distances, std::span<const Vec3> x);

}  // namespace weavefront::contact
