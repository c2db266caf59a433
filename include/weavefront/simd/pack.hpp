#pragma once
/// @file
/// Eight doubles computed at once. Every operation gives in each lane the bits that it gives on a `double`:
/// only + - * / sqrt, comparisons and selections, all of them exact or correctly rounded, so scalar, AVX2 and
/// AVX-512 builds agree. The same names work on `double` with `bool` as mask (real.hpp).

#include <cstdint>
#include <cstring>

#include "weavefront/simd/real.hpp"

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace weavefront::simd {

#if defined(__AVX512F__)
inline constexpr int register_width = 8;
#elif defined(__AVX__)
inline constexpr int register_width = 4;
#else
inline constexpr int register_width = 2;
#endif
inline constexpr int pack_width = 8;
inline constexpr int registers = pack_width / register_width;

/// One processor register of doubles, and of integers of the same size.
using Register [[gnu::vector_size(8 * register_width)]] = double;
using Bits [[gnu::vector_size(8 * register_width)]] = std::int64_t;

/// One truth value per lane.
struct Mask {
#if defined(__AVX512F__)
    __mmask8 lanes = 0;
#else
    Bits lanes[registers];  // all ones or all zeros
#endif
    [[nodiscard]] bool get(int lane) const {
#if defined(__AVX512F__)
        return (lanes >> lane & 1) != 0;
#else
        return lanes[lane / register_width][lane % register_width] != 0;
#endif
    }
};

/// Eight doubles.
struct alignas(64) Pack {
    Register part[registers];

    Pack() = default;
    /// The same value in every lane.
    WEAVEFRONT_INLINE Pack(double value) {
        for (Register& r : part) r = value - Register{};
    }
    /// @param lane 0..7
    [[nodiscard]] double get(int lane) const { return part[lane / register_width][lane % register_width]; }
    void set(int lane, double value) { part[lane / register_width][lane % register_width] = value; }

    /// @param from eight doubles, 64-byte aligned
    WEAVEFRONT_INLINE static Pack load(const double* from) {
        return load_anywhere(static_cast<const double*>(__builtin_assume_aligned(from, 64)));
    }
    /// @param to room for eight doubles, 64-byte aligned
    WEAVEFRONT_INLINE void store(double* to) const {
        store_anywhere(static_cast<double*>(__builtin_assume_aligned(to, 64)));
    }

    /// The same at any address. Register by register: g++ copies a whole pack in smaller pieces and waits for
    /// them to join.
    WEAVEFRONT_INLINE static Pack load_anywhere(const double* from) {
        Pack result;
        for (int i = 0; i < registers; ++i)
            std::memcpy(&result.part[i], from + i * register_width, sizeof(Register));
        return result;
    }
    WEAVEFRONT_INLINE void store_anywhere(double* to) const {
        for (int i = 0; i < registers; ++i) std::memcpy(to + i * register_width, &part[i], sizeof(Register));
    }
};

/// Applies `operation` to each register of a and b.
template <class Operation>
WEAVEFRONT_INLINE Pack by_register(const Pack& a, const Pack& b, Operation operation) {
    Pack result;
    for (int i = 0; i < registers; ++i) result.part[i] = operation(a.part[i], b.part[i]);
    return result;
}

WEAVEFRONT_INLINE Pack operator+(const Pack& a, const Pack& b) {
    return by_register(a, b, [](Register x, Register y) { return x + y; });
}
WEAVEFRONT_INLINE Pack operator-(const Pack& a, const Pack& b) {
    return by_register(a, b, [](Register x, Register y) { return x - y; });
}
WEAVEFRONT_INLINE Pack operator*(const Pack& a, const Pack& b) {
    return by_register(a, b, [](Register x, Register y) { return x * y; });
}
WEAVEFRONT_INLINE Pack operator/(const Pack& a, const Pack& b) {
    return by_register(a, b, [](Register x, Register y) { return x / y; });
}
WEAVEFRONT_INLINE Pack operator-(const Pack& a) {
    return by_register(a, a, [](Register x, Register) { return -x; });
}
WEAVEFRONT_INLINE Pack& operator+=(Pack& a, const Pack& b) { return a = a + b; }
WEAVEFRONT_INLINE Pack& operator-=(Pack& a, const Pack& b) { return a = a - b; }
WEAVEFRONT_INLINE Pack& operator*=(Pack& a, const Pack& b) { return a = a * b; }

#if defined(__AVX512F__)

WEAVEFRONT_INLINE Mask operator<(const Pack& a, const Pack& b) {
    return {_mm512_cmp_pd_mask(a.part[0], b.part[0], _CMP_LT_OQ)};
}
WEAVEFRONT_INLINE Mask operator<=(const Pack& a, const Pack& b) {
    return {_mm512_cmp_pd_mask(a.part[0], b.part[0], _CMP_LE_OQ)};
}
WEAVEFRONT_INLINE Mask operator==(const Pack& a, const Pack& b) {
    return {_mm512_cmp_pd_mask(a.part[0], b.part[0], _CMP_EQ_OQ)};
}
WEAVEFRONT_INLINE Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.lanes & b.lanes)}; }
WEAVEFRONT_INLINE Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.lanes | b.lanes)}; }
WEAVEFRONT_INLINE Mask operator!(Mask a) { return {static_cast<__mmask8>(~a.lanes)}; }
WEAVEFRONT_INLINE bool any(Mask a) { return a.lanes != 0; }
WEAVEFRONT_INLINE bool all(Mask a) { return a.lanes == 0xff; }
WEAVEFRONT_INLINE Pack select(Mask mask, const Pack& a, const Pack& b) {
    return by_register(
        a, b, [mask](Register x, Register y) -> Register { return _mm512_mask_blend_pd(mask.lanes, y, x); });
}

#else

/// Applies `operation` to each register of a and b, giving a mask.
template <class Operand, class Operation>
WEAVEFRONT_INLINE Mask mask_by_register(const Operand (&a)[registers], const Operand (&b)[registers],
                                        Operation operation) {
    Mask result;
    for (int i = 0; i < registers; ++i) result.lanes[i] = operation(a[i], b[i]);
    return result;
}

WEAVEFRONT_INLINE Mask operator<(const Pack& a, const Pack& b) {
    return mask_by_register(a.part, b.part, [](Register x, Register y) -> Bits { return x < y; });
}
WEAVEFRONT_INLINE Mask operator<=(const Pack& a, const Pack& b) {
    return mask_by_register(a.part, b.part, [](Register x, Register y) -> Bits { return x <= y; });
}
WEAVEFRONT_INLINE Mask operator==(const Pack& a, const Pack& b) {
    return mask_by_register(a.part, b.part, [](Register x, Register y) -> Bits { return x == y; });
}
WEAVEFRONT_INLINE Mask operator&(const Mask& a, const Mask& b) {
    return mask_by_register(a.lanes, b.lanes, [](Bits x, Bits y) { return x & y; });
}
WEAVEFRONT_INLINE Mask operator|(const Mask& a, const Mask& b) {
    return mask_by_register(a.lanes, b.lanes, [](Bits x, Bits y) { return x | y; });
}
WEAVEFRONT_INLINE Mask operator!(const Mask& a) {
    return mask_by_register(a.lanes, a.lanes, [](Bits x, Bits) { return ~x; });
}
WEAVEFRONT_INLINE bool any(const Mask& a) {
    Bits joined = a.lanes[0];
    for (int i = 1; i < registers; ++i) joined |= a.lanes[i];
#if defined(__AVX__)
    return _mm256_movemask_pd(reinterpret_cast<__m256d>(joined)) != 0;
#else
    return (joined[0] | joined[1]) != 0;
#endif
}
WEAVEFRONT_INLINE bool all(const Mask& a) { return !any(!a); }
WEAVEFRONT_INLINE Pack select(const Mask& mask, const Pack& a, const Pack& b) {
    Pack result;
    for (int i = 0; i < registers; ++i) result.part[i] = mask.lanes[i] ? a.part[i] : b.part[i];
    return result;
}

#endif

WEAVEFRONT_INLINE Mask operator>(const Pack& a, const Pack& b) { return b < a; }
WEAVEFRONT_INLINE Mask operator>=(const Pack& a, const Pack& b) { return b <= a; }

/// Correctly rounded square root.
WEAVEFRONT_INLINE Pack sqrt(const Pack& a) {
    return by_register(a, a, [](Register x, Register) -> Register {
#if defined(__AVX512F__)
        return _mm512_maskz_sqrt_pd(0xff, x);  // the plain form trips -Wuninitialized in GCC 12's own header
#elif defined(__AVX__)
        return _mm256_sqrt_pd(x);
#else
        return Register{sqrt(x[0]), sqrt(x[1])};
#endif
    });
}
WEAVEFRONT_INLINE Pack abs(const Pack& a) {
    return by_register(a, a, [](Register x, Register) {
        return reinterpret_cast<Register>(reinterpret_cast<Bits>(x) & std::int64_t{0x7fffffffffffffff});
    });
}
/// a < b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE Pack min(const Pack& a, const Pack& b) { return select(a < b, a, b); }
/// a > b ? a : b, so b where either is not a number.
WEAVEFRONT_INLINE Pack max(const Pack& a, const Pack& b) { return select(a > b, a, b); }

/// Fraction in [1/2, 1) and power of two of a positive normal number.
WEAVEFRONT_INLINE Binary<Pack> binary(const Pack& a) {
    Binary<Pack> result;
    for (int i = 0; i < registers; ++i) {
        const auto bits = reinterpret_cast<Bits>(a.part[i]);
        result.fraction.part[i] = reinterpret_cast<Register>((bits & fraction_bits) | half_bits);
        result.exponent.part[i] =
            reinterpret_cast<Register>((bits >> 52) | two_to_52_bits) - (two_to_52 + 1022.0);
    }
    return result;
}

template <>
struct RealTraits<Pack> {
    using Mask = simd::Mask;
    static constexpr int width = pack_width;
    WEAVEFRONT_INLINE static Pack load(const double* from) { return Pack::load(from); }
    WEAVEFRONT_INLINE static void store(const Pack& value, double* to) { value.store(to); }
};

}  // namespace weavefront::simd
