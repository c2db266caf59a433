#pragma once
/// @file
/// Two to four numbers computed at once, for data that stand in memory by twos, threes and fours. Every
/// operation gives the bits that it gives on one number.

#include <cstdint>
#include <cstring>

#include "weavefront/simd/real.hpp"

namespace weavefront::simd {

using Double2 [[gnu::vector_size(16)]] = double;
using Double4 [[gnu::vector_size(32)]] = double;
using Float4 [[gnu::vector_size(16)]] = float;
/// Truth values of a comparison of Double4, all bits set or none.
using Mask4 [[gnu::vector_size(32)]] = std::int64_t;

/// Loads a vector from any address.
/// @param from as many numbers as the vector has
template <class Vector, class Number>
WEAVEFRONT_INLINE Vector load(const Number* from) {
    Vector result;
    std::memcpy(&result, from, sizeof result);
    return result;
}

WEAVEFRONT_INLINE Double4 joined(const Double2& low, const Double2& high) {
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
WEAVEFRONT_INLINE Double4 widened(const Float4& a) { return __builtin_convertvector(a, Double4); }
WEAVEFRONT_INLINE Double4 abs(const Double4& a) {
    return reinterpret_cast<Double4>(reinterpret_cast<Mask4>(a) & std::int64_t{0x7fffffffffffffff});
}
/// a < b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE Double4 min(const Double4& a, const Double4& b) { return a < b ? a : b; }
/// a > b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE Double4 max(const Double4& a, const Double4& b) { return a > b ? a : b; }
WEAVEFRONT_INLINE bool any(const Mask4& a) { return (a[0] | a[1] | a[2] | a[3]) != 0; }

}  // namespace weavefront::simd
