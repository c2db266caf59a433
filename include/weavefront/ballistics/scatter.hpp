#pragma once
/// @file
/// Values of the scene that differ from shot to shot.

#include <cstdint>
#include <string>
#include <variant>

namespace weavefront::ballistics {

/// How a value of the scene scatters. `seed`: the number of the shot, for a scene that draws by itself.
struct ScatterLaw {
    enum class Kind { normal, uniform, seed };
    Kind kind = Kind::normal;
    std::string path{};            ///< of the scene, as `--set` takes it
    double first = 0, second = 0;  ///< mean and standard deviation, or the ends, in the unit below
    std::string unit{};            ///< as written; empty: none
};

/// Reads `PATH=normal(MEAN, DEVIATION)`, `PATH=uniform(LOW, HIGH)` or `PATH=seed`. Both values have the same
/// unit, such as `normal(3.3 %, 0.1 %)`.
/// @return the law, or the problem: what was found and what is allowed
std::variant<ScatterLaw, std::string> scatter_law_of(const std::string& text);

/// What `--set` takes for one shot: `PATH=VALUE`. The draw depends on the seed, the path and the number of
/// the shot only, so it is the same on any machine and in any order of the shots.
/// @param shot number, from 1
std::string drawn_setting(const ScatterLaw& law, std::uint64_t seed, std::int64_t shot);

}  // namespace weavefront::ballistics
