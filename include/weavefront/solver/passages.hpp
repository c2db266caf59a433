#pragma once
/// @file
/// Which plies a projectile has passed.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/joined_fabric.hpp"
#include "weavefront/solver/model.hpp"

namespace weavefront::solver {

/// How the projectile came behind a ply: through a hole, through fabric with nothing eroded around it, or
/// past its edge.
enum class Way { hole, whole_fabric, beside };

struct Passage {
    double time;  ///< s
    Way way;
    std::int64_t element;  ///< that lies across its way; -1: none does
};

/// The projectile has passed a ply when its middle is behind the fabric of the ply within its radius, as seen
/// along z, and the ply does not press on it. Debris, elements with a broken yarn and those at the edge of a
/// hole do not count: they may fly or hang ahead of it for long.
class Passages {
  public:
    explicit Passages(std::size_t plies) : plies_(plies) {}

    /// Notes the plies that the projectile has passed since the last look.
    /// @param fabric that is joined to the target now
    /// @param pairs  in contact now
    /// @param number of the projectile, which has contact
    /// @note Collective
    void look(const Model& model, const JoinedFabric& fabric, const mesh::Panel& panel,
              std::span<const contact::PairForce> pairs, std::size_t number, double time,
              const parallel::Communicator& comm);

    /// Of each ply; absent: the projectile has not passed it.
    [[nodiscard]] const std::vector<std::optional<Passage>>& plies() const { return plies_; }
    [[nodiscard]] bool all() const;

    template <class Archive>
    void state(Archive& archive, const std::string& name) {
        std::vector<double> times;
        std::vector<std::int64_t> plies, ways, elements;
        for (std::size_t ply = 0; ply < plies_.size(); ++ply) {
            if (!plies_[ply]) continue;
            times.push_back(plies_[ply]->time);
            plies.push_back(static_cast<std::int64_t>(ply));
            ways.push_back(static_cast<std::int64_t>(plies_[ply]->way));
            elements.push_back(plies_[ply]->element);
        }
        archive(name + ".time", times);
        archive(name + ".ply", plies);
        archive(name + ".way", ways);
        archive(name + ".element", elements);
        for (std::size_t i = 0; i < plies.size(); ++i)
            plies_[static_cast<std::size_t>(plies[i])] = {times[i], static_cast<Way>(ways[i]), elements[i]};
    }

  private:
    std::vector<std::optional<Passage>> plies_;
};

}  // namespace weavefront::solver
