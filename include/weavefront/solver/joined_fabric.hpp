#pragma once
/// @file
/// Which fabric still belongs to the target, and which is debris.

#include <cstdint>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// Fabric is joined where unbroken yarns lead to a support: an edge that is held. A ply without one keeps its
/// largest piece. All other fabric is debris.
///
/// A yarn joins the nodes of its element along its direction. In a turned ply, whose yarns cross elements at
/// a slant, it joins all four.
class JoinedFabric {
  public:
    /// Finds the pieces of all plies. @note Collective
    void find(const Model& model, const mesh::Panel& panel, const parallel::Communicator& comm);

    /// Whether nothing was ever looked for: everything is joined.
    [[nodiscard]] bool is_whole() const { return nodes_.empty(); }
    /// Of a local node, ghosts excepted.
    [[nodiscard]] bool has_node(std::size_t node) const { return nodes_.empty() || nodes_[node] != 0; }
    /// Of an owned element: it is not eroded, and one of its yarns is joined.
    [[nodiscard]] bool has_element(const Model& model, std::size_t element) const {
        return !is_eroded(model, element) && is_at_joined_node(model, element);
    }
    /// Of an owned element: it is neither eroded nor joined.
    [[nodiscard]] bool is_debris(const Model& model, std::size_t element) const {
        return !is_eroded(model, element) && !is_at_joined_node(model, element);
    }

  private:
    [[nodiscard]] static bool is_eroded(const Model& model, std::size_t element);
    [[nodiscard]] bool is_at_joined_node(const Model& model, std::size_t element) const;

    std::vector<std::uint8_t> nodes_;
};

}  // namespace weavefront::solver
