#pragma once
/// @file
/// One case of the stability table, computed with one formulation.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::stability {

/// What the table says of a case in advance, for the consistent formulation.
enum class Expected {
    finish,  ///< to the end, energy error below 2 %
    guard,   ///< a message of the guard: the step is above a bound that is attained, or the case beyond the
             ///< model
    either,  ///< above the bound where nothing attains it: finishes as below it, or the guard stops it
};

/// A run: a scene made from a base by overrides, and what scenes have no words for.
struct Case {
    std::string family;                    ///< cases of one kind
    std::string name;                      ///< one word
    std::string what;                      ///< one phrase
    std::vector<std::string> overrides{};  ///< of the base scene, `PATH=VALUE`
    Expected expected = Expected::finish;
    std::string reason{};    ///< why it is not to finish; empty: it is
    bool reduced = false;    ///< stands in the reduced table
    std::int64_t steps = 0;  ///< ends after so many steps; 0: at the scene's time.end
    std::function<void(solver::Simulation&)> prepare{};  ///< initial velocities, yarns broken from the start
    std::string same_as{};                               ///< must leave the bits of this case
};

/// `endless`: far more steps than promised; `crashed`: an exception that no user should see.
enum class Outcome { finished, stopped, refused, endless, crashed };

/// What came of a run.
struct Result {
    Outcome outcome = Outcome::finished;
    std::string message;  ///< of the guard, or of the reader of scenes
    std::int64_t steps = 0;
    double time = 0;             ///< s
    double energy_error = 0;     ///< largest over the rows, over the energy transferred until then, 1
    double hourglass_share = 0;  ///< largest hourglass energy over the same, 1
    double given =
        0;  ///< most that yarns, friction or contact had given beyond what they took, over the same, 1
    double given_by_single =
        0;  ///< the same of the yarns and friction of single elements, added up where they had, 1
    std::int64_t broken_yarns = 0, eroded_elements = 0;
    bool finite = true;      ///< every number looked at
    std::uint64_t bits = 0;  ///< hash of every row and of the last positions
    double seconds = 0;      ///< wall clock
};

/// Runs a case. @param base YAML of the scene that the case changes
/// @param formulation `consistent` or `paper`
/// @note Collective
Result run(const Case& trial, const std::string& base, const std::string& formulation,
           const parallel::Communicator& comm);

}  // namespace weavefront::stability
