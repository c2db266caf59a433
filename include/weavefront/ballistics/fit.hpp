#pragma once
/// @file
/// Maximum-likelihood fit of an S-curve with profile-likelihood intervals.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "weavefront/ballistics/response.hpp"
#include "weavefront/ballistics/shot.hpp"

namespace weavefront::ballistics {

/// An estimate and its confidence interval; none: unbounded on that side, the shots do not decide it.
struct Estimate {
    double value = 0;
    std::optional<double> lower{}, upper{};
};

/// Speed at which a share of the shots perforates.
struct Quantile {
    double probability = 0;
    Estimate speed;  ///< m/s
};

/// A fitted S-curve.
struct Fit {
    Response response;
    double confidence = 0.95;  ///< of all intervals
    double log_likelihood = 0;
    Estimate sigma;  ///< m/s
    std::vector<Quantile> quantiles;

    /// @pre the fit was asked for this probability
    [[nodiscard]] const Estimate& speed_at(double probability) const;
};

/// Fits an S-curve to shots.
/// @param probabilities of which the speeds are estimated
/// @param confidence    above 0 and below 1
/// @return why there is no fit: without a zone of mixed results the likelihood has no maximum, and where
/// complete penetrations lie at lower speeds than partial ones none that rises
std::variant<Fit, std::string> fit(std::span<const Shot> shots, Distribution distribution,
                                   std::span<const double> probabilities, double confidence);

}  // namespace weavefront::ballistics
