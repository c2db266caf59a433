#pragma once
/// @file
/// What a kernel's number type `Real` offers, and its scalar form `double`; pack.hpp has the form with eight
/// lanes. None of it calls the mathematical library, whose last bits vary with the processor.

#include <bit>
#include <cmath>
#include <cstdint>

/// Kernels are inlined whole: a pack passed through memory at every call would cost more than its arithmetic.
#define WEAVEFRONT_INLINE [[gnu::always_inline]] inline

namespace weavefront::simd {

/// Mask type, lanes, load and store of a number type.
template <class Real>
struct RealTraits;

template <>
struct RealTraits<double> {
    using Mask = bool;
    static constexpr int width = 1;
    WEAVEFRONT_INLINE static double load(const double* from) { return *from; }
    WEAVEFRONT_INLINE static void store(double value, double* to) { *to = value; }
};

/// Truth values of the comparisons of a number type, one per lane.
template <class Real>
using MaskOf = typename RealTraits<Real>::Mask;

/// Lanes of a number type.
template <class Real>
inline constexpr int width = RealTraits<Real>::width;

WEAVEFRONT_INLINE bool any(bool mask) { return mask; }
WEAVEFRONT_INLINE bool all(bool mask) { return mask; }
WEAVEFRONT_INLINE double select(bool mask, double a, double b) { return mask ? a : b; }

/// Correctly rounded square root: one instruction.
WEAVEFRONT_INLINE double sqrt(double a) { return __builtin_sqrt(a); }
WEAVEFRONT_INLINE double abs(double a) { return __builtin_fabs(a); }
/// a < b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE double min(double a, double b) { return a < b ? a : b; }
/// a > b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE double max(double a, double b) { return a > b ? a : b; }

/// A positive number as fraction * 2^exponent, fraction in [1/2, 1).
template <class Real>
struct Binary {
    Real fraction;
    Real exponent;
};

inline constexpr std::int64_t fraction_bits = 0x000fffffffffffff;
inline constexpr std::int64_t half_bits = 0x3fe0000000000000;       // 0.5
inline constexpr std::int64_t two_to_52_bits = 0x4330000000000000;  // 2^52: its last 52 bits count units
inline constexpr double two_to_52 = 4503599627370496.0;

/// Fraction in [1/2, 1) and power of two of a positive normal number.
WEAVEFRONT_INLINE Binary<double> binary(double a) {
    const auto bits = std::bit_cast<std::int64_t>(a);
    return {std::bit_cast<double>((bits & fraction_bits) | half_bits),
            std::bit_cast<double>((bits >> 52) | two_to_52_bits) - (two_to_52 + 1022.0)};
}

/// The value kept between two bounds; a value that is not a number stays so, for a guard to find.
template <class Real>
WEAVEFRONT_INLINE Real clamp(const Real& value, const Real& lower, const Real& upper) {
    return min(upper, max(lower, value));
}

}  // namespace weavefront::simd
