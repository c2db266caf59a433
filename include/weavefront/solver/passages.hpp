#pragma once
/// @file
/// Which plies the projectile has passed.

#include <cstdint>
#include <optional>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// How the projectile came behind a ply: through a hole, through fabric with nothing eroded around it, or past its edge.
enum class Way { hole, whole_fabric, beside };

struct Passage {
    double time;  ///< s
    Way way;
    std::int64_t element;  ///< that lies across its way; -1: none does
};

/// The projectile has passed a ply when its middle is behind all fabric of the ply within its radius, as seen along z.
class Passages {
  public:
    explicit Passages(std::size_t plies) : plies_(plies) {}

    /// Notes the plies that the projectile has passed since the last look.
    /// @param middle of the projectile, m
    /// @param radius of the projectile about its axis, m
    /// @note Collective
    void look(const Model& model, const mesh::Panel& panel, const Vec3& middle, double radius, double time,
              const parallel::Communicator& comm);

    /// Of each ply; absent: the projectile has not passed it.
    [[nodiscard]] const std::vector<std::optional<Passage>>& plies() const { return plies_; }
    [[nodiscard]] bool all() const;

  private:
    std::vector<std::optional<Passage>> plies_;
};

}  // namespace weavefront::solver
