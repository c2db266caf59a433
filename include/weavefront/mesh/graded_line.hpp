#pragma once
/// @file
/// Graded subdivision of a line, of which panels are made.

#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::mesh {

/// Grid lines from `low` to `high`. Elements have the size `mesh.center` at `fine` and grow away from it by
/// `mesh.growth` per element up to `mesh.edge`. Each side is scaled down as a whole to end at its boundary,
/// so no element is larger than requested. The two sides of a line that is symmetric about `fine` mirror each
/// other to the last bit.
///
/// No element is thinner than a quarter of its neighbour. Growth is limited to 3 per element. Where `fine` is
/// so near to an end that a sliver would remain, elements are smallest at that end instead.
/// @param low,high ends, m
/// @param fine     where the elements are smallest, in [low, high], m
/// @return         ascending coordinates, m; they contain `low`, `high` and, unless moved to an end, `fine`
std::vector<double> graded_line(double low, double high, double fine, const scene::PanelMesh& mesh);

}  // namespace weavefront::mesh
