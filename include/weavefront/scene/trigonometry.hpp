#pragma once
/// @file
/// Functions of angles for the geometry of a scene. They are computed in extended precision and rounded once.
/// In double precision the mathematical library chooses its code, and with it the last bit, by the processor.

#include <cmath>

namespace weavefront::scene {

/// @param x rad
inline double sine(double x) { return static_cast<double>(std::sin(static_cast<long double>(x))); }
/// @param x rad
inline double cosine(double x) { return static_cast<double>(std::cos(static_cast<long double>(x))); }
/// @param x rad
inline double tangent(double x) { return static_cast<double>(std::tan(static_cast<long double>(x))); }
inline double arc_sine(double x) { return static_cast<double>(std::asin(static_cast<long double>(x))); }
inline double arc_cosine(double x) { return static_cast<double>(std::acos(static_cast<long double>(x))); }
inline double arc_tangent(double y, double x) {
    return static_cast<double>(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
}

}  // namespace weavefront::scene
