#include "weavefront/ballistics/limit_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace weavefront::ballistics {

namespace {

constexpr int most_without_result = 3;
constexpr double least_speed = 1;  // m/s, of a search without ends

// A bracket that is wider than asked for by the rounding of its ends is narrow enough.
constexpr double rounding = 2 * speed_grain;

bool is_shot(std::span<const Trial> trials, double speed) {
    return std::ranges::any_of(
        trials, [&](const Trial& trial) { return std::abs(trial.speed - speed) < speed_grain / 2; });
}

/// Points that cut an interval into equal parts; `shift` of a part moves them all.
std::vector<double> section(double low, double high, int points, double shift = 0) {
    std::vector<double> speeds;
    for (int i = 1; i <= points; ++i)
        speeds.push_back(rounded_speed(low + (high - low) * (i + shift) / (points + 1)));
    return speeds;
}

/// Points of the bracket that were not shot.
std::vector<double> inside(double low, double high, int points, std::span<const Trial> trials) {
    std::vector<double> speeds;
    for (const double shift : {0.0, 0.25, -0.25, 0.4, -0.4}) {
        speeds = section(low, high, points, shift);
        std::erase_if(speeds,
                      [&](double speed) { return is_shot(trials, speed) || speed <= low || speed >= high; });
        speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
        if (!speeds.empty()) break;
    }
    return speeds;
}

int without_result(const Bracket& bracket, std::span<const Trial> trials) {
    return static_cast<int>(std::ranges::count_if(trials, [&](const Trial& trial) {
        return trial.result == Result::none && (!bracket.low || trial.speed > *bracket.low) &&
               (!bracket.high || trial.speed < *bracket.high);
    }));
}

/// Steps away from the speeds shot up to now, each twice as long as the one before.
Round outwards(const SearchPlan& plan, const Bracket& bracket, std::span<const Trial> trials) {
    if (trials.empty()) {
        Round round;
        for (int i = 0; i < plan.side_by_side; ++i)
            round.speeds.push_back(
                rounded_speed(plan.start + plan.step * (i - 0.5 * (plan.side_by_side - 1))));
        std::erase_if(round.speeds, [](double speed) { return speed < least_speed; });
        return round;
    }
    const bool is_up = !bracket.high;
    double end = trials.front().speed;
    for (const auto& trial : trials) end = is_up ? std::max(end, trial.speed) : std::min(end, trial.speed);
    const auto rounds = static_cast<double>((static_cast<int>(trials.size()) - 1) / plan.side_by_side);
    Round round;
    double step = plan.step * std::exp2(rounds);
    for (int i = 0; i < plan.side_by_side; ++i, step *= 2) {
        end = rounded_speed(is_up ? end + step : std::max(end - step, end / 2));
        if (end >= least_speed && end <= most_speed && !is_shot(trials, end)) round.speeds.push_back(end);
    }
    std::ranges::sort(round.speeds);
    if (round.speeds.empty())
        round.failure = is_up ? fmt::format("no complete penetration up to {} m/s", most_speed)
                              : fmt::format("no partial penetration down to {} m/s", least_speed);
    return round;
}

/// Between an end that was named but not shot and a shot, or two of either.
Round between(const SearchPlan& plan, double low, double high, const Bracket& bracket,
              std::span<const Trial> trials) {
    std::vector<double> ends;
    const bool is_due = static_cast<int>(trials.size()) > plan.side_by_side;
    if (is_due && !bracket.low && !is_shot(trials, low)) ends.push_back(rounded_speed(low));
    if (is_due && !bracket.high && !is_shot(trials, high)) ends.push_back(rounded_speed(high));
    if (std::ssize(ends) > plan.side_by_side) ends.pop_back();
    const int left = plan.side_by_side - static_cast<int>(ends.size());
    Round round;
    if (left > 0) round.speeds = inside(low, high, left, trials);
    round.speeds.insert(round.speeds.end(), ends.begin(), ends.end());
    std::ranges::sort(round.speeds);
    return round;
}

std::string failure_of_end(const SearchPlan& plan, std::span<const Trial> trials) {
    for (const auto& trial : trials) {
        if (plan.from && trial.result == Result::complete && trial.speed <= rounded_speed(*plan.from))
            return fmt::format("the limit lies below {:.2f} m/s, the lowest speed allowed", *plan.from);
        if (plan.to && trial.result == Result::partial && trial.speed >= rounded_speed(*plan.to))
            return fmt::format("the limit lies above {:.2f} m/s, the highest speed allowed", *plan.to);
    }
    return {};
}

}  // namespace

double rounded_speed(double speed) { return std::round(speed / speed_grain) / std::round(1 / speed_grain); }

Bracket bracket_of(std::span<const Trial> trials) {
    Bracket bracket;
    for (const auto& trial : trials)
        if (trial.result == Result::complete)
            bracket.high = std::min(trial.speed, bracket.high.value_or(trial.speed));
    for (const auto& trial : trials)
        if (trial.result == Result::partial && (!bracket.high || trial.speed < *bracket.high))
            bracket.low = std::max(trial.speed, bracket.low.value_or(trial.speed));
    return bracket;
}

Round next_round(const SearchPlan& plan, std::span<const Trial> trials) {
    if (auto failure = failure_of_end(plan, trials); !failure.empty()) return {{}, failure};
    const auto bracket = bracket_of(trials);
    const auto low = bracket.low ? bracket.low : plan.from, high = bracket.high ? bracket.high : plan.to;
    if (bracket.low && bracket.high && *high - *low <= plan.width + rounding) return {};
    if (without_result(bracket, trials) >= most_without_result)
        return {{}, fmt::format("{} shots inside the bracket gave no result", most_without_result)};
    auto round = low && high ? between(plan, *low, *high, bracket, trials) : outwards(plan, bracket, trials);
    if (round.speeds.empty() && round.failure.empty())
        round.failure = "no speed is left to be shot in the bracket";
    return round;
}

int rounds_left(const SearchPlan& plan, std::span<const Trial> trials) {
    const auto bracket = bracket_of(trials);
    const auto low = bracket.low ? bracket.low : plan.from, high = bracket.high ? bracket.high : plan.to;
    const double width = low && high ? *high - *low : plan.step;
    const double rounds = std::log(width / plan.width) / std::log(plan.side_by_side + 1);
    return std::max(0, static_cast<int>(std::ceil(rounds))) + (low && high ? 0 : 1);
}

}  // namespace weavefront::ballistics
