#pragma once
/// @file
/// The angle between contact and the normals of the elements.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// Bounds the angle by twice the largest angle of a normal or of contact to one axis. The axis turns with the
/// ply.
class FlatContact {
  public:
    explicit FlatContact(const mesh::Panel& panel);

    /// The unit normal of the first ply. Three of its corners define it, so it turns with the ply.
    /// @note Collective; all ranks get the same bits
    [[nodiscard]] Vec3 axis(const Model& model, const parallel::Communicator& comm) const;

    /// Square of the sine of the largest angle between a normal of an element and a direction of contact; 1
    /// from 90 deg on.
    /// @param pairs in contact at present; other contact is taken to act along the normals of plies
    /// @note Collective
    [[nodiscard]] double sine_squared(const Model& model, const Vec3& axis,
                                      std::span<const contact::PairForce> pairs,
                                      const parallel::Communicator& comm);

  private:
    std::array<std::int64_t, 3> corners_;  // of the first ply: global nodes, counter-clockwise
    std::array<bool, 2> symmetry_;
    std::vector<std::int32_t> steepest_;  // by group: the pack from which the next search starts
};

}  // namespace weavefront::solver
