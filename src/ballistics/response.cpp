#include "weavefront/ballistics/response.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

namespace weavefront::ballistics {

namespace {

// A logistic distribution of scale 1 has this standard deviation.
constexpr double logistic_deviation = std::numbers::pi / std::numbers::sqrt3;

// Below, erfc comes near the smallest double; the error of the series is of the order of 105 / z^8 there.
constexpr double far_tail = -35;

double log_normal_probability(double z) {
    if (z > far_tail) return std::log(0.5 * std::erfc(-z / std::numbers::sqrt2));
    const double r = 1 / (z * z);  // Abramowitz and Stegun (26.2.12)
    return -0.5 * z * z - std::log(-z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(r * (-1 + r * (3 - 15 * r)));
}

}  // namespace

std::string_view name_of(Distribution distribution) {
    return distribution == Distribution::normal ? "normal" : "logistic";
}

double probability_at(Distribution distribution, double z) {
    return distribution == Distribution::normal ? 0.5 * std::erfc(-z / std::numbers::sqrt2)
                                                : 1 / (1 + std::exp(-logistic_deviation * z));
}

double deviations_at(Distribution distribution, double probability) {
    if (distribution == Distribution::normal)
        return boost::math::quantile(boost::math::normal(), probability);
    return std::log(probability / (1 - probability)) / logistic_deviation;
}

LogProbability log_probability(Distribution distribution, double z) {
    if (distribution == Distribution::normal) {
        const double value = log_normal_probability(z);
        const double ratio = std::exp(-0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi) - value);
        return {value, ratio, -ratio * (ratio + z)};
    }
    const double k = logistic_deviation, e = std::exp(-std::abs(k * z));
    const double value = z > 0 ? -std::log1p(e) : k * z - std::log1p(e);
    const double rest = z > 0 ? e / (1 + e) : 1 / (1 + e);  // 1 - p
    return {value, k * rest, -k * k * rest * (1 - rest)};
}

}  // namespace weavefront::ballistics
