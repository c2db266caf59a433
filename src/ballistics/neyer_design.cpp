#include "weavefront/ballistics/neyer_design.hpp"

#include <algorithm>
#include <cmath>

#include "weavefront/ballistics/likelihood.hpp"
#include "weavefront/ballistics/limit_search.hpp"
#include "weavefront/ballistics/response.hpp"

namespace weavefront::ballistics {

namespace {

// Of the guessed deviation after each shot that leaves the results unmixed.
constexpr double shrinkage = 0.8;

// The best place of a shot lies within about 1.5 deviations of the median, one that balances others farther
// out.
constexpr double farthest = 5, resolution = 0.01;  // deviations

/// Fisher information of shots on the median and the deviation of a normal S-curve of deviation 1.
struct Information {
    double median = 0, both = 0, deviation = 0;

    void add(double z) {
        const auto p = log_probability(Distribution::normal, z),
                   q = log_probability(Distribution::normal, -z);
        const double weight = p.slope * q.slope;  // density squared over p q
        median += weight;
        both += weight * z;
        deviation += weight * z * z;
    }
    [[nodiscard]] double determinant() const { return median * deviation - both * both; }
    /// That speaks where a single shot leaves the determinant at zero.
    [[nodiscard]] bool is_more_than(const Information& other) const {
        const double mine = determinant(), others = other.determinant();
        return mine != others ? mine > others : median > other.median;
    }
};

/// Where a shot adds most to the information.
double best_speed(const Response& guess, Information& information) {
    double best = 0;
    Information most;
    const int half = static_cast<int>(farthest / resolution);
    for (int i = -half; i <= half; ++i) {
        Information with = information;
        with.add(i * resolution);
        if (i == -half || with.is_more_than(most)) {
            most = with;
            best = i * resolution;
        }
    }
    information = most;
    return guess.v50 + guess.sigma * best;
}

Information information_of(const Response& guess, std::span<const Shot> shots) {
    Information information;
    for (const auto& shot : shots) information.add((shot.speed - guess.v50) / guess.sigma);
    return information;
}

/// Guess of the deviation after the shots fired since the gap fell below it.
double shrunk_sigma(const NeyerPlan& plan, std::span<const Shot> shots) {
    double sigma = plan.sigma;
    for (std::size_t i = 1; i < shots.size(); ++i) {
        const auto zone = mixed_zone(shots.first(i));
        if (zone && -zone->width() <= sigma) sigma *= shrinkage;
    }
    return sigma;
}

Response guess_of(const NeyerPlan& plan, std::span<const Shot> shots, const MixedZone& zone) {
    const Response unmixed{Distribution::normal, 0.5 * (zone.lowest_complete + zone.highest_partial),
                           shrunk_sigma(plan, shots)};
    if (!zone.exists()) return unmixed;
    const auto [lowest, highest] = std::ranges::minmax(shots, {}, &Shot::speed);
    auto guess = Likelihood(shots, Distribution::normal).maximum().value_or(unmixed);
    guess.v50 = std::clamp(guess.v50, lowest.speed, highest.speed);
    guess.sigma = std::min(guess.sigma, highest.speed - lowest.speed);
    return guess;
}

/// All results are alike: away from the speeds shot, towards the end of the guess and beyond it.
double next_outwards(const NeyerPlan& plan, std::span<const Shot> shots) {
    const auto [lowest, highest] = std::ranges::minmax(shots, {}, &Shot::speed);
    if (shots.front().is_complete)  // not lower than half of the lowest speed
        return std::max(0.5 * lowest.speed,
                        std::min({0.5 * (plan.from + lowest.speed), lowest.speed - 2 * plan.sigma,
                                  2 * lowest.speed - highest.speed}));
    return std::min(most_speed, std::max({0.5 * (plan.to + highest.speed), highest.speed + 2 * plan.sigma,
                                          2 * highest.speed - lowest.speed}));
}

std::vector<double> section(double low, double high, int count) {
    std::vector<double> speeds;
    for (int i = 1; i <= count; ++i) speeds.push_back(low + (high - low) * i / (count + 1));
    return speeds;
}

}  // namespace

std::vector<double> next_speeds(const NeyerPlan& plan, std::span<const Shot> shots, int count) {
    std::vector<double> speeds;
    const auto zone = mixed_zone(shots);
    if (shots.empty()) {
        speeds = section(plan.from, plan.to, count);
    } else if (!zone) {
        std::vector<Shot> fired(shots.begin(), shots.end());
        for (int i = 0; i < count; ++i) {
            speeds.push_back(next_outwards(plan, fired));
            fired.push_back({speeds.back(), shots.front().is_complete});
        }
    } else if (-zone->width() > shrunk_sigma(plan, shots)) {
        speeds = section(zone->highest_partial, zone->lowest_complete, count);
    } else {
        const auto guess = guess_of(plan, shots, *zone);
        auto information = information_of(guess, shots);
        for (int i = 0; i < count; ++i)
            speeds.push_back(std::max(speed_grain, best_speed(guess, information)));
    }
    for (double& speed : speeds) speed = rounded_speed(speed);
    return speeds;
}

}  // namespace weavefront::ballistics
