#pragma once
/// @file
/// One-dimensional graded subdivision, from which panels are made.

#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::mesh {

/// Grid lines from `low` to `high` with elements of size `mesh.center` at `fine`, growing by `mesh.growth` an element away from it up to
/// `mesh.edge`. Each side is scaled down as a whole to end at its boundary, so no element is larger than asked for, and the two sides of a
/// line that is symmetric about `fine` mirror each other to the last bit.
/// @param low,high ends, m
/// @param fine     where the elements are smallest, in [low, high], m
/// @return         ascending coordinates, m; `low`, `fine` and `high` are among them
std::vector<double> graded_line(double low, double high, double fine, const scene::PanelMesh& mesh);

}  // namespace weavefront::mesh
