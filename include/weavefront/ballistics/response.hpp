#pragma once
/// @file
/// Probability of a complete penetration over striking velocity.

#include <string_view>

namespace weavefront::ballistics {

/// Distribution of the limit velocity over targets: normal (probit) or logistic (logit).
enum class Distribution { normal, logistic };

/// As results and options name it.
std::string_view name_of(Distribution distribution);

/// Probability of a complete penetration at `z` standard deviations above the median.
double probability_at(Distribution distribution, double z);

/// The inverse of `probability_at`. @param probability above 0 and below 1
double deviations_at(Distribution distribution, double probability);

/// Logarithm of `probability_at` with its first two derivatives; accurate in the far tails.
struct LogProbability {
    double value, slope, curvature;
};
LogProbability log_probability(Distribution distribution, double z);

/// An S-curve.
struct Response {
    Distribution distribution = Distribution::normal;
    double v50 = 0, sigma = 0;  ///< median and standard deviation, m/s

    [[nodiscard]] double probability(double speed) const {
        return probability_at(distribution, (speed - v50) / sigma);
    }
    /// Speed at which a share of the shots perforates, m/s.
    [[nodiscard]] double speed(double probability) const {
        return v50 + sigma * deviations_at(distribution, probability);
    }
};

}  // namespace weavefront::ballistics
