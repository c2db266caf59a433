#pragma once
/// @file
/// Which shots count as complete penetrations.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "weavefront/ballistics/limit_search.hpp"

namespace weavefront::app {

/// `perforated`: all plies have a hole. `any_ply`: at least one has. `witness`: all have, and the residual
/// velocity pierces a witness plate.
struct Criterion {
    enum class Kind { perforated, any_ply, witness };
    Kind kind = Kind::perforated;
    double least_residual = 0;        ///< of `witness`, m/s
    std::string text = "perforated";  ///< as written
};

/// Reads the option `--complete`. @return the criterion, or what was found and what is allowed
std::variant<Criterion, std::string> criterion_of(const std::string& text);

/// The result of a shot.
/// @param verdict          as summary.json has it
/// @param plies_perforated that have a hole
/// @param residual         velocity along the shot, m/s
/// @return none: not decided, or the projectile is behind plies that are whole
ballistics::Result result_of(const Criterion& criterion, const std::string& verdict,
                             std::int64_t plies_perforated, double residual);

}  // namespace weavefront::app
