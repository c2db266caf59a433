#pragma once
/// @file
/// The transcendental functions of the model, from + - * / alone. Lanes take the short or the long way of a
/// function by selection, so that the result of a lane never depends on the others.

#include <array>
#include <cmath>
#include <numbers>

#include "weavefront/simd/real.hpp"

namespace weavefront::simd {

/// 1/3, 1/5, 1/7 ...: the series of atanh and, with alternating signs, of atan.
inline constexpr std::array<double, 12> odd_reciprocals{1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,
                                                        1.0 / 11, 1.0 / 13, 1.0 / 15, 1.0 / 17,
                                                        1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25};

/// sum over k >= 1 of z^(k-1)/(2k+1), the first `terms` of them.
template <int terms, class Real>
WEAVEFRONT_INLINE Real odd_series(const Real& z) {
    Real sum = odd_reciprocals[terms - 1];
    for (int k = terms - 2; k >= 0; --k) sum = sum * z + odd_reciprocals[static_cast<std::size_t>(k)];
    return sum;
}

/// atan(x) for |x| < tan(pi/16) = 0.199; the first term left out is below 2e-18 of the result.
template <class Real>
WEAVEFRONT_INLINE Real atan_series(const Real& x) {
    const Real z = x * x;
    return x - x * z * odd_series<12>(-z);
}

/// Inverse tangent of |x| <= 1, within 2 units of the last place.
/// Beyond 0.19 the angle is taken from the nearer of two base angles: atan x = atan b + atan((x - b)/(1 + b
/// x)).
template <class Real>
WEAVEFRONT_INLINE Real atan(const Real& x) {
    const Real short_way = atan_series(x);
    const Real size = abs(x);
    const MaskOf<Real> far = size > 0.19;
    if (!any(far)) return short_way;
    // b = 13/32 or 1, with its angle in two pieces
    const MaskOf<Real> upper = size > 0.66;
    const Real base = select(upper, Real(1.0), Real(13.0 / 32.0));
    const Real angle = select(upper, Real(std::numbers::pi / 4), Real(0x1.8b24d394a1b25p-2));
    const Real remainder = select(upper, Real(0x1.1a62633145c07p-55), Real(0x1.b6d0ba3748fa8p-56));
    const Real rest = atan_series(Real((size - base) / (1.0 + base * size)));
    const Real long_way = angle + (rest + remainder);
    return select(far, select(x < 0.0, Real(-long_way), long_way), short_way);
}

/// 2 atanh(u) for |u| <= 0.1716, that is ln of ratios up to sqrt(2); the first term left out is below 1e-18
/// of the result.
template <class Real>
WEAVEFRONT_INLINE Real two_atanh(const Real& u) {
    const Real z = u * u;
    return 2.0 * u + 2.0 * u * z * odd_series<11>(z);
}

/// ln(a/b) of two positive numbers; digits cancel where they are close.
template <class Real>
WEAVEFRONT_INLINE Real log_far_ratio(const Real& a, const Real& b) {
    const Binary<Real> ratio = binary(Real(a / b));
    const MaskOf<Real> low = ratio.fraction < std::numbers::sqrt2 / 2;
    const Real fraction = select(low, Real(2.0 * ratio.fraction), ratio.fraction);
    const Real exponent = select(low, Real(ratio.exponent - 1.0), ratio.exponent);
    // ln 2 in two pieces: the first has few enough bits for an exact product
    return exponent * 0x1.62e42fee00000p-1 +
           (exponent * 0x1.a39ef35793c76p-33 + two_atanh(Real((fraction - 1.0) / (fraction + 1.0))));
}

/// ln(a/b) of two positive numbers, without cancellation where they are close.
template <class Real>
WEAVEFRONT_INLINE Real log_ratio(const Real& a, const Real& b) {
    const Real u = (a - b) / (a + b);
    const Real short_way = two_atanh(u);
    const MaskOf<Real> far = abs(u) > 0.17;
    if (!any(far)) return short_way;
    return select(far, log_far_ratio(a, b), short_way);
}

/// 1 - e^-a for a >= 0, accurate relative to itself, so that (1 - e^-a)/a is accurate down to a = 0.
/// The argument is halved until its Taylor series is short, then 1 - e^-2x = y (2 - y) with y = 1 - e^-x goes
/// back up.
inline double one_minus_exp(double a) {
    if (a > 64.0) return 1.0;  // e^-64 is below the rounding of 1
    int halvings = 0;
    while (a > 0.0625) {
        a *= 0.5;
        ++halvings;
    }
    double y = 0.0;
    for (int k = 10; k >= 1; --k) y = (a / k) * (1.0 - y);
    while (halvings-- > 0) y *= 2.0 - y;
    return y;
}

/// e^a for |a| <= 700: 2^k e^r with |r| <= ln 2/2, and e^r by its Taylor series.
inline double exponential(double a) {
    const double k = std::floor(a * std::numbers::log2e + 0.5);
    const double r = (a - k * 0x1.62e42fee00000p-1) - k * 0x1.a39ef35793c76p-33;
    double sum = 0.0;
    for (int n = 14; n >= 1; --n) sum = (r / n) * (1.0 + sum);
    return std::ldexp(1.0 + sum, static_cast<int>(k));
}

/// ln Gamma(z) for z from 1 to 2, within 1e-13: Stirling's series of Gamma(z + 12).
inline double log_gamma(double z) {
    double product = 1.0;
    for (int i = 0; i < 12; ++i) product *= z + i;
    const double y = z + 12.0, square = 1.0 / (y * y);
    const double series =
        (1.0 / 12.0 - square * (1.0 / 360.0 - square * (1.0 / 1260.0 - square * (1.0 / 1680.0)))) / y;
    constexpr double half_log_two_pi = 0.91893853320467274178;
    return (y - 0.5) * log_ratio(y, 1.0) - y + half_log_two_pi + series - log_ratio(product, 1.0);
}

/// sin(a) for |a| <= pi/2 by its Taylor series.
inline double sine(double a) {
    double sum = 0.0;
    for (int k = 12; k >= 1; --k) sum = a * a / ((2.0 * k) * (2.0 * k + 1.0)) * (1.0 - sum);
    return a * (1.0 - sum);
}

}  // namespace weavefront::simd
