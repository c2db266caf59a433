#pragma once
/// @file
/// One-dimensional graded subdivision, from which panels are made.

#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::mesh {

/// Grid lines from `low` to `high` with elements of size `mesh.center` at `fine`, growing by `mesh.growth` an
/// element away from it up to `mesh.edge`. Each side is scaled down as a whole to end at its boundary, so no
/// element is larger than asked for, and the two sides of a line that is symmetric about `fine` mirror each
/// other to the last bit. No element is thinner than a quarter of its neighbour: elements grow by at most 3
/// from one to the next, and where `fine` is so near to an end that a sliver would lie between them, the
/// elements are smallest at that end instead.
/// @param low,high ends, m
/// @param fine     where the elements are smallest, in [low, high], m
/// @return         ascending coordinates, m; `low` and `high` are among them, and `fine` unless it gave way
/// to an end
std::vector<double> graded_line(double low, double high, double fine, const scene::PanelMesh& mesh);

}  // namespace weavefront::mesh
