#pragma once
/// @file
/// The arithmetic V50 of MIL-STD-662F.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/ballistics/shot.hpp"

namespace weavefront::ballistics {

/// Largest spread of the speeds of an arithmetic V50, 125 ft/s, m/s.
inline constexpr double most_spread = 38.1;

/// Mean of equal numbers of highest partial and lowest complete penetrations.
struct MeanLimit {
    double v50 = 0;                  ///< m/s
    double spread = 0;               ///< largest less smallest speed, m/s
    std::vector<std::size_t> shots;  ///< indices of the shots used, by speed
};

/// The arithmetic V50 from five partial and five complete penetrations, or else from three and three.
/// @return none: fewer lie within `most_spread`
std::optional<MeanLimit> mean_limit(std::span<const Shot> shots);

}  // namespace weavefront::ballistics
