#pragma once
/// @file
/// Pairs of facets that may come into contact.

#include <cstdint>

#include "weavefront/contact/facet_ranges.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/contact/swept_bounds.hpp"

namespace weavefront::contact {

/// By owned facet: facets of later plies that lie over it, as seen along z. The order is ascending ply, then
/// ascending global id. In a mesh numbered row by row a list takes few ranges.
using Candidates = FacetLists;

/// Finds for every alive owned facet the alive facets of the next ply whose swept footprints come within
/// `reach` of its own. Where the next ply has a free edge or a hole there, the search goes on in the ply
/// behind it. The candidates of a facet do not depend on the rank that owns it.
/// @param swept bounds of all nodes until the next search
/// @param reach m
Candidates find_candidates(const Surface& surface, const SweptBounds& swept, double reach);

}  // namespace weavefront::contact
