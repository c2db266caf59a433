#pragma once
/// @file
/// How evenly the ranks are loaded while a run goes on.

#include <cstdint>
#include <optional>

#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/partition/decomposition.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

/// A better decomposition than the present one.
struct Rebalancing {
    partition::Decomposition decomposition;
    double measured;   ///< slowest rank over the mean, in the last window
    double predicted;  ///< the same of the new decomposition
};

/// Measures what elements and contact cost on every rank, in windows of some steps. Where the slowest rank
/// stays above the mean by more than a limit, columns are shared out anew by what they have to do now, if
/// that promises to win back more than the limit: perforation and the spreading deflection move the work of
/// contact.
class LoadWatch {
  public:
    static constexpr std::int64_t window = 200;  ///< steps

    /// @param limit slowest rank over the mean, less 1, that is borne
    LoadWatch(const scene::Scene& scene, double limit);

    /// To be called after every step. @return what to change to, on all ranks; mostly nothing
    /// @note Collective at the ends of windows
    std::optional<Rebalancing> look(const Simulation& simulation, const parallel::Communicator& comm);

    /// Slowest rank over the mean in the worst window so far; 0: there was none.
    [[nodiscard]] double worst() const { return worst_; }

  private:
    static constexpr int windows_above = 2;  // a single one may be a disturbance from outside

    double limit_;
    partition::ContactZone zone_;
    double elements_ = 0, contact_ = 0;  // s, at the last look
    int above_ = 0;
    double worst_ = 0;
};

}  // namespace weavefront::solver
