#include "weavefront/ballistics/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

#include "weavefront/ballistics/likelihood.hpp"

namespace weavefront::ballistics {

namespace {

/// Twice the loss of log-likelihood at the ends of an interval: quantile of chi squared of one degree.
double allowed_deviance(double confidence) {
    const double z = deviations_at(Distribution::normal, 0.5 * (1 + confidence));
    return z * z;
}

/// Where a function that rises from a negative value at `start` in the direction of `step` vanishes.
template <class Function>
double crossing(Function f, double start, double step) {
    double end = start + step;
    while (f(end) < 0) {
        start = end;
        step *= 2;
        end += step;
    }
    std::uintmax_t iterations = 200;
    const auto [a, b] =
        boost::math::tools::toms748_solve(f, std::min(start, end), std::max(start, end),
                                          boost::math::tools::eps_tolerance<double>(40), iterations);
    return 0.5 * (a + b);
}

/// Intervals of one fit.
class Intervals {
  public:
    Intervals(const Likelihood& likelihood, const Response& best, double confidence)
        : likelihood_(likelihood),
          best_(best),
          least_(likelihood.log_likelihood(best) - 0.5 * allowed_deviance(confidence)) {}

    [[nodiscard]] Estimate speed_at(double probability) const {
        Estimate estimate{best_.speed(probability)};
        const auto lack = [&](double speed) {
            return least_ - likelihood_.profile_of_speed(speed, probability);
        };
        if (likelihood_.profile_far_below(probability) < least_)
            estimate.lower = crossing(lack, estimate.value, -best_.sigma);
        if (likelihood_.profile_far_above(probability) < least_)
            estimate.upper = crossing(lack, estimate.value, best_.sigma);
        return estimate;
    }

    [[nodiscard]] Estimate sigma() const {
        Estimate estimate{best_.sigma};
        const auto lack = [&](double slope) { return least_ - likelihood_.profile_of_sigma(1 / slope); };
        const double slope = 1 / best_.sigma;
        estimate.lower = 1 / crossing(lack, slope, slope);
        if (likelihood_.profile_of_constant() >= least_) return estimate;
        double low = slope / 2;
        while (lack(low) < 0) low /= 2;
        estimate.upper = 1 / crossing(lack, slope, low - slope);
        return estimate;
    }

  private:
    const Likelihood& likelihood_;
    Response best_;
    double least_;  ///< log-likelihood at the ends of the intervals
};

std::string refusal(std::span<const Shot> shots) {
    const auto zone = mixed_zone(shots);
    if (!zone)
        return fmt::format("no fit: {} shots, all of them {} penetrations", shots.size(),
                           !shots.empty() && shots.front().is_complete ? "complete" : "partial");
    if (!zone->exists())
        return fmt::format(
            "no fit: no zone of mixed results, the highest partial penetration, {:.2f} m/s, lies below the "
            "lowest complete one, {:.2f} m/s",
            zone->highest_partial, zone->lowest_complete);
    return {};
}

}  // namespace

const Estimate& Fit::speed_at(double probability) const {
    return std::ranges::find(quantiles, probability, &Quantile::probability)->speed;
}

std::variant<Fit, std::string> fit(std::span<const Shot> shots, Distribution distribution,
                                   std::span<const double> probabilities, double confidence) {
    if (auto reason = refusal(shots); !reason.empty()) return reason;
    const Likelihood likelihood(shots, distribution);
    const auto best = likelihood.maximum();
    if (!best) return "no fit: the share of complete penetrations does not rise with speed";
    const Intervals intervals(likelihood, *best, confidence);
    Fit fit{*best, confidence, likelihood.log_likelihood(*best), intervals.sigma(), {}};
    for (const double probability : probabilities)
        fit.quantiles.push_back({probability, intervals.speed_at(probability)});
    return fit;
}

}  // namespace weavefront::ballistics
