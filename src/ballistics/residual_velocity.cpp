#include "weavefront/ballistics/residual_velocity.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <set>

namespace weavefront::ballistics {

namespace {

constexpr int bits = 40;           // of a minimum's place that the method can find at all
constexpr int coarse_points = 24;  // in which the deepest of several minima is looked for
constexpr double least_p = 1, most_p = 8;
constexpr std::size_t least_shots = 4;

/// Smallest value of a function between two places, which may have several minima.
template <class Function>
double place_of_minimum(Function f, double low, double high) {
    const double step = (high - low) / coarse_points;
    int best = 0;
    for (int i = 1; i <= coarse_points; ++i)
        if (f(low + i * step) < f(low + best * step)) best = i;
    const double a = low + std::max(best - 1, 0) * step, b = low + std::min(best + 1, coarse_points) * step;
    return boost::math::tools::brent_find_minima(f, a, b, bits).first;
}

double least_striking(std::span<const Perforation> shots) {
    return std::ranges::min_element(shots, {}, &Perforation::striking)->striking;
}

double mean_square(std::span<const Perforation> shots, const ResidualCurve& curve) {
    double sum = 0;
    for (const auto& shot : shots) {
        const double difference = shot.residual - curve.residual(shot.striking);
        sum += difference * difference / static_cast<double>(shots.size());
    }
    return sum;
}

/// The factor of least squares for a limit velocity and an exponent.
ResidualCurve with_best_factor(std::span<const Perforation> shots, double v50, double p) {
    const ResidualCurve shape{v50, 1, p};
    double product = 0, square = 0;
    for (const auto& shot : shots) {
        const double value = shape.residual(shot.striking);
        product += value * shot.residual;
        square += value * value;
    }
    return {v50, square > 0 ? std::clamp(product / square, 0.0, 1.0) : 1.0, p};
}

ResidualCurve with_deviation(std::span<const Perforation> shots, ResidualCurve curve) {
    curve.deviation = std::sqrt(mean_square(shots, curve));
    return curve;
}

}  // namespace

double ResidualCurve::residual(double striking) const {
    if (striking <= v50) return 0;
    return a * striking * std::pow(1 - std::pow(v50 / striking, p), 1 / p);
}

std::optional<ResidualCurve> fit_recht_ipson(std::span<const Perforation> shots) {
    if (shots.empty()) return std::nullopt;
    const auto error = [&](double v50) { return mean_square(shots, {v50}); };
    return with_deviation(shots, {place_of_minimum(error, 0, least_striking(shots))});
}

std::optional<ResidualCurve> fit_lambert_jonas(std::span<const Perforation> shots) {
    std::set<double> speeds;
    for (const auto& shot : shots) speeds.insert(shot.striking);
    if (speeds.size() < least_shots) return std::nullopt;
    const auto best_of = [&](double p) {
        const auto error = [&](double v50) { return mean_square(shots, with_best_factor(shots, v50, p)); };
        return with_best_factor(shots, place_of_minimum(error, 0, least_striking(shots)), p);
    };
    const auto error = [&](double p) { return mean_square(shots, best_of(p)); };
    return with_deviation(shots, best_of(place_of_minimum(error, least_p, most_p)));
}

}  // namespace weavefront::ballistics
