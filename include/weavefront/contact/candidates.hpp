#pragma once
/// @file
/// Which facets may meet which.

#include <cstdint>

#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// Facets of later plies over or under each owned facet, as seen along z: ascending ply, then ascending
/// global id. In a mesh that is numbered row by row these are few runs.
using Candidates = FacetLists;

/// Finds, for every alive owned facet, the alive facets of the next ply whose footprint is expected to come
/// within `reach`; once facets were eroded, where some of these are on a rim, or none is there, also those of
/// the ply behind, and so on. The result for a facet does not depend on which rank owns it.
Candidates find_candidates(const Surface& surface, const SweptBounds& swept, double reach);

}  // namespace weavefront::contact
