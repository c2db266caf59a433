#pragma once
/// @file
/// The steps of the nodes that touch each of them, eight nodes at once.

#include <array>
#include <span>
#include <vector>

#include "weavefront/parallel/fixed_point.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::solver {

/// v += step f/m and x += dt v of all nodes, ghosts among them.
/// @param scale of the forces
/// @param step  from the middle of the last step to that of this one, s
/// @param dt    this step, s
void move_freely(Nodes& nodes, const parallel::FixedPoint& scale, double step, double dt);

/// Nodes whose energies are computed at once.
inline constexpr std::size_t energies_at_once = 8;

/// Kinetic energies of nodes without damping, J, with which the ledger closes; the bits of one after the
/// other.
/// @param first    of the nodes; as many follow as are computed at once
/// @param step     from the middle of the last step to that of the next one, s
/// @param last_dt  the last step, s
[[nodiscard]] std::array<double, energies_at_once> kinetic_energies(const Nodes& nodes,
                                                                    const parallel::FixedPoint& scale,
                                                                    std::size_t first, double step,
                                                                    double last_dt);

}  // namespace weavefront::solver
