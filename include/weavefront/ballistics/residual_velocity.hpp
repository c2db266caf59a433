#pragma once
/// @file
/// Residual velocity over striking velocity, and the limit velocity that it leads to.

#include <optional>
#include <span>

namespace weavefront::ballistics {

/// A shot that went through.
struct Perforation {
    double striking = 0, residual = 0;  ///< m/s, above 0
};

/// Vr = a (Vs^p - V50^p)^(1/p), J. P. Lambert and G. H. Jonas (1976). With a = 1 and p = 2 the form of R. F.
/// Recht and T. W. Ipson (1963) for a projectile that takes no part of the target with it.
struct ResidualCurve {
    double v50 = 0;  ///< m/s
    double a = 1, p = 2;
    double deviation = 0;  ///< root of the mean square of the differences to the shots, m/s

    /// m/s; 0 up to the limit velocity
    [[nodiscard]] double residual(double striking) const;
};

/// The Recht-Ipson curve of least squares. @return none: no shot went through
std::optional<ResidualCurve> fit_recht_ipson(std::span<const Perforation> shots);

/// The Lambert-Jonas curve of least squares with a up to 1 and p from 1 to 8. @return none: fewer than four
/// shots of different striking velocities went through, which decide nothing about three constants
std::optional<ResidualCurve> fit_lambert_jonas(std::span<const Perforation> shots);

}  // namespace weavefront::ballistics
