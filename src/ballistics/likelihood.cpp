#include "weavefront/ballistics/likelihood.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace weavefront::ballistics {

namespace {

constexpr std::uintmax_t most_iterations = 200;

/// Root of a function that falls from a positive value at `low`. @param step first width of the search above
template <class Function>
double falling_root(Function f, double low, double step) {
    double high = low + step;
    while (f(high) > 0) {
        low = high;
        step *= 2;
        high += step;
    }
    std::uintmax_t iterations = most_iterations;
    const auto [a, b] = boost::math::tools::toms748_solve(
        f, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
    return 0.5 * (a + b);
}

}  // namespace

Likelihood::Likelihood(std::span<const Shot> shots, Distribution distribution) : distribution_(distribution) {
    const auto count = static_cast<double>(shots.size());
    for (const Shot& shot : shots) centre_ += shot.speed / count;
    double square = 0;
    for (const Shot& shot : shots) square += (shot.speed - centre_) * (shot.speed - centre_) / count;
    if (square > 0) scale_ = std::sqrt(square);
    for (const Shot& shot : shots) {
        u_.push_back((shot.speed - centre_) / scale_);
        complete_.push_back(shot.is_complete);
    }
}

template <class Z, class Weight>
Likelihood::Sum Likelihood::sum(Z z, Weight weight) const {
    Sum sum{0, 0};
    for (std::size_t i = 0; i < u_.size(); ++i) {
        // Both distributions are symmetric.
        const double sign = complete_[i] ? 1 : -1;
        const auto term = log_probability(distribution_, sign * z(u_[i]));
        sum.value += term.value;
        sum.slope += sign * term.slope * weight(u_[i]);
    }
    return sum;
}

std::optional<Response> Likelihood::maximum() const {
    const auto unit = [](double) { return 1.0; };
    const auto itself = [](double u) { return u; };
    const auto best_a = [&](double b) {
        const auto slope = [&](double a) { return sum([&](double u) { return a + b * u; }, unit).slope; };
        double low = -1;
        while (slope(low) < 0) low *= 2;
        return falling_root(slope, low, 1);
    };
    const auto slope_of_profile = [&](double b) {
        const double a = best_a(b);
        return sum([&](double u) { return a + b * u; }, itself).slope;
    };
    if (!(slope_of_profile(0) > 0)) return std::nullopt;
    const double b = falling_root(slope_of_profile, 0, 1);
    return Response{distribution_, centre_ - scale_ * best_a(b) / b, scale_ / b};
}

double Likelihood::log_likelihood(const Response& response) const {
    const double v50 = (response.v50 - centre_) / scale_, b = scale_ / response.sigma;
    return sum([&](double u) { return b * (u - v50); }, [](double) { return 1.0; }).value;
}

double Likelihood::profile_of_speed(double speed, double probability) const {
    const double at = (speed - centre_) / scale_, z = deviations_at(distribution_, probability);
    const auto of = [&](double b) {
        return sum([&](double u) { return z + b * (u - at); }, [&](double u) { return u - at; });
    };
    if (!(of(0).slope > 0)) return of(0).value;
    return of(falling_root([&](double b) { return of(b).slope; }, 0, 1)).value;
}

double Likelihood::profile_of_sigma(double sigma) const {
    const double b = scale_ / sigma;
    const auto of = [&](double a) {
        return sum([&](double u) { return a + b * u; }, [](double) { return 1.0; });
    };
    double low = -1;
    while (of(low).slope < 0) low *= 2;
    return of(falling_root([&](double a) { return of(a).slope; }, low, 1)).value;
}

double Likelihood::of_constant(double z) const {
    return sum([&](double) { return z; }, [](double) { return 1.0; }).value;
}

double Likelihood::most_likely_constant() const {
    const auto complete = static_cast<double>(std::ranges::count(complete_, true));
    return deviations_at(distribution_, complete / static_cast<double>(complete_.size()));
}

double Likelihood::profile_far_below(double probability) const {
    return of_constant(std::max(deviations_at(distribution_, probability), most_likely_constant()));
}

double Likelihood::profile_far_above(double probability) const {
    return of_constant(std::min(deviations_at(distribution_, probability), most_likely_constant()));
}

double Likelihood::profile_of_constant() const { return of_constant(most_likely_constant()); }

}  // namespace weavefront::ballistics
