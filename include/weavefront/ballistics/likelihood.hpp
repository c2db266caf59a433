#pragma once
/// @file
/// Likelihood of S-curves for given shots, and its profiles.

#include <optional>
#include <span>
#include <vector>

#include "weavefront/ballistics/response.hpp"
#include "weavefront/ballistics/shot.hpp"

namespace weavefront::ballistics {

/// Log-likelihood of an S-curve. It is concave in z = a + b speed, so its maximum is the only one, and sets
/// of likely medians, deviations and speeds of a probability are intervals.
class Likelihood {
  public:
    /// @param shots with a zone of mixed results
    Likelihood(std::span<const Shot> shots, Distribution distribution);

    /// The most likely S-curve. @return none: the share of complete penetrations does not rise with speed
    [[nodiscard]] std::optional<Response> maximum() const;
    /// Of an S-curve.
    [[nodiscard]] double log_likelihood(const Response& response) const;
    /// Largest log-likelihood of all S-curves that reach a probability at a speed.
    [[nodiscard]] double profile_of_speed(double speed, double probability) const;
    /// Largest log-likelihood of all S-curves of a standard deviation.
    [[nodiscard]] double profile_of_sigma(double sigma) const;
    /// Limits of `profile_of_speed` for a speed of minus and plus infinity.
    [[nodiscard]] double profile_far_below(double probability) const;
    [[nodiscard]] double profile_far_above(double probability) const;
    /// Limit of `profile_of_sigma` for an infinite standard deviation: one probability at all speeds.
    [[nodiscard]] double profile_of_constant() const;

  private:
    struct Sum {
        double value, slope;
    };
    /// Sum over the shots of the log-likelihood at z(u) and of its derivative times weight(u).
    template <class Z, class Weight>
    [[nodiscard]] Sum sum(Z z, Weight weight) const;
    [[nodiscard]] double of_constant(double z) const;
    [[nodiscard]] double most_likely_constant() const;

    Distribution distribution_;
    double centre_ = 0, scale_ = 1;  ///< of the speeds: u = (speed - centre) / scale
    std::vector<double> u_;
    std::vector<bool> complete_;
};

}  // namespace weavefront::ballistics
