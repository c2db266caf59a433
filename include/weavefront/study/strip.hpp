#pragma once
/// @file
/// Waves in a strip of fabric that is hit across its middle, measured along its middle line.

#include <span>
#include <vector>

namespace weavefront::study {

/// The strip at one time.
struct StripFrame {
    double time = 0;             ///< s
    std::vector<double> x, z;    ///< of the nodes on the line, by initial x, m
    std::vector<double> centre;  ///< initial x of the middle of the elements, ascending, m
    std::vector<double> strain;  ///< of the yarns along the strip, mean over its width, one a centre, 1
};

/// What the waves do.
struct StripWaves {
    double strain;              ///< behind the longitudinal front, 1
    double transverse_speed;    ///< of the kink, m/s
    double longitudinal_speed;  ///< of the front, where the strain falls through half of its plateau, m/s
};

/// Measures over the last three quarters of the frames; the first is left to the strip under the face of the
/// projectile.
/// @param frames   at least four, of a strip whose waves have not reached its ends
/// @param expected strain behind the front, roughly, 1: tells where the front is
/// @throws std::runtime_error where there is no wave to measure
StripWaves measure_strip(std::span<const StripFrame> frames, double expected);

}  // namespace weavefront::study
