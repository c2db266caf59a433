#pragma once
/// @file
/// The unit in which speeds are told.

#include <string>

namespace weavefront::app {

inline constexpr double foot_per_second = 0.3048;  ///< m/s

/// A unit of speed by the name that the user gives it.
struct SpeedUnit {
    std::string name = "m/s";
    double si = 1;  ///< m/s

    /// `358.25 m/s`, or `1175.36 ft/s (358.25 m/s)`.
    [[nodiscard]] std::string text(double speed) const;
    /// The same for an interval: `355.10 to 361.90 m/s`.
    [[nodiscard]] std::string text(double low, double high) const;
};

}  // namespace weavefront::app
