#pragma once
/// @file
/// Fabric that slips between the jaws of a clamp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/coulomb.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// Coulomb friction under the constant pressure of a clamp.
///
/// The jaws stand still. They press a stack of plies whose nodes lie over each other: a column. Each ply
/// slips on its neighbours, and the outer plies slip on the jaws. So a clamp resists a column by 2 mu p an
/// area, whether one ply is pulled or all are pulled alike. Neighbours are those at rest: friction does not
/// depend on how far they have slipped.
class ClampFriction {
  public:
    /// Nodes of one column between jaws.
    struct Column {
        std::size_t node = 0;      ///< in the first ply
        std::size_t clamp = 0;     ///< 0, 1: of the edges across x, y
        std::vector<double> area;  ///< of the nodes of all plies, m2
    };
    /// Force on a node, N.
    struct Force {
        std::size_t node;
        Vec3 force;
    };

    /// @param stiffness    of the contact between fabric and jaws, Pa/m
    /// @param nodes_of_ply the nodes of a ply follow those of the ply before
    ClampFriction(const std::array<std::optional<scene::Clamp>, 2>& clamps, double stiffness,
                  std::vector<Column> columns, std::size_t nodes_of_ply, std::size_t plies);

    /// Advances the friction by a step and replaces the forces of the step before.
    /// @param v  velocities over the step, m/s
    /// @param dt s
    void evaluate(std::span<const Vec3> v, double dt);

    /// Of all nodes in clamps.
    [[nodiscard]] std::span<const Force> forces() const { return forces_; }

    /// State of a node; none outside of clamps.
    template <class Archive>
    void state(Archive& archive, std::size_t node) {
        const auto place = column_of_[node % nodes_of_ply_];
        if (place < 0) return;
        const auto ply = node / nodes_of_ply_;
        archive.within("clamp.front", [&] { traction(place, ply).state(archive); });
        if (ply + 1 == plies_) archive.within("clamp.back", [&] { traction(place, plies_).state(archive); });
    }

  private:
    /// On the front of a ply; of index `plies_` on the jaw behind the last one.
    [[nodiscard]] TangentialTraction& traction(std::int32_t column, std::size_t face) {
        return tractions_[static_cast<std::size_t>(column) * (plies_ + 1) + face];
    }

    struct Law {
        CoulombLaw friction;
        double pressure;  ///< Pa
    };
    std::array<std::optional<Law>, 2> laws_;
    std::vector<Column> columns_;
    std::size_t nodes_of_ply_, plies_;
    std::vector<std::int32_t> column_of_;        ///< of the nodes of a ply, or -1
    std::vector<TangentialTraction> tractions_;  ///< of a column from the front to the back, Pa
    std::vector<Force> forces_;
};

}  // namespace weavefront::contact
