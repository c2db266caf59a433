#pragma once
/// @file
/// The limit velocity of a target without scatter: which speeds to shoot next.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace weavefront::ballistics {

/// Of a shot; `none`: it was not decided, or was stopped by the guard.
enum class Result { none, partial, complete };

/// A speed that was shot.
struct Trial {
    double speed;  ///< m/s
    Result result;
};

/// Speeds are whole multiples of this, which a message can write, m/s.
inline constexpr double speed_grain = 0.01;

/// Highest speed that a search goes to by itself, m/s.
inline constexpr double most_speed = 10'000;

/// Nearest speed that is shot, m/s.
double rounded_speed(double speed);

/// What is looked for.
struct SearchPlan {
    std::optional<double> from{}, to{};  ///< between which the limit is to lie, m/s; none: it is looked for
    double start = 0;                    ///< first speed where `from` or `to` is missing, m/s
    double step = 0;                     ///< first step away from it, doubled in each round, m/s
    double width = 0;                    ///< of the last bracket, m/s
    int side_by_side = 1;                ///< shots of a round
};

/// The limit lies between them.
struct Bracket {
    std::optional<double> low{};   ///< highest partial penetration below `high`, m/s
    std::optional<double> high{};  ///< lowest complete penetration, m/s
};

/// What the shots up to now say.
Bracket bracket_of(std::span<const Trial> trials);

/// The next round: speeds to shoot, or why there is none.
struct Round {
    std::vector<double> speeds{};  ///< ascending, m/s; empty: the search has ended
    std::string failure{};  ///< why it has ended without a bracket of the wanted width; empty: it has not
};

/// The next round of a search. A round of k shots cuts the bracket into k + 1 equal parts: bisection for one.
/// An end that was named, `from` or `to`, is shot when two rounds have left it the end of the bracket.
/// A speed without a result is not shot again; after three of them in a bracket the search gives up.
Round next_round(const SearchPlan& plan, std::span<const Trial> trials);

/// Rounds that are left until the bracket has its width, at the least.
int rounds_left(const SearchPlan& plan, std::span<const Trial> trials);

}  // namespace weavefront::ballistics
