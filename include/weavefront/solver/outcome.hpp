#pragma once
/// @file
/// What became of a shot.

#include <cstdint>
#include <optional>
#include <string_view>

#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

/// `passed` is no result: the projectile is behind plies that are whole where it passed, or flew past the
/// target.
enum class Verdict { still_moving, stopped, perforated, passed };

/// As written to summary.json and the log.
std::string_view name_of(Verdict verdict);

/// The outcome at one time.
struct Outcome {
    Verdict verdict = Verdict::still_moving;
    std::optional<double> decided_at;   ///< when the projectile turned back, or passed the last ply, s
    std::int64_t plies_perforated = 0;  ///< that the projectile has passed through a hole
};

/// Of a projectile that has contact; one without it is still moving.
Outcome outcome_of(const Shot& shot);

/// Whether the verdicts stand and the back face has swung back: that of every projectile is decided, nothing
/// has touched it over the last tenth of a diameter of its way, and the deflection has fallen by 1 % from its
/// largest. The latter is not asked of a perforated target that nothing supports, which flies on. Flaps
/// around a hole may swing farther later.
/// @param balance of the present time
bool is_settled(const Simulation& simulation, const Balance& balance);

}  // namespace weavefront::solver
