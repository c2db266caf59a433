#pragma once
/// @file
/// Eight 64-bit integers and their exact passage to and from packs: bit for bit what the conversions of one
/// number do.

#include <cstdint>
#include <cstring>

#include "weavefront/simd/pack.hpp"

namespace weavefront::simd {

/// Bits as numbers that wrap: a diverging element may exceed the range before its fault is noticed.
using WrappingBits [[gnu::vector_size(8 * register_width)]] = std::uint64_t;
WEAVEFRONT_INLINE WrappingBits wrapping(const Bits& a) { return reinterpret_cast<WrappingBits>(a); }

/// Eight integers.
struct alignas(64) Integers {
    Bits part[registers];

    /// @param from eight integers, anywhere
    WEAVEFRONT_INLINE static Integers load(const std::int64_t* from) {
        Integers result;
        for (int i = 0; i < registers; ++i)
            std::memcpy(&result.part[i], from + i * register_width, sizeof(Bits));
        return result;
    }
    /// @param to room for eight integers, 64-byte aligned
    WEAVEFRONT_INLINE void store(std::int64_t* to) const {
        auto* aligned = static_cast<std::int64_t*>(__builtin_assume_aligned(to, 64));
        for (int i = 0; i < registers; ++i) std::memcpy(aligned + i * register_width, &part[i], sizeof(Bits));
    }
};

WEAVEFRONT_INLINE Integers operator+(const Integers& a, const Integers& b) {
    Integers result;
    for (int i = 0; i < registers; ++i)
        result.part[i] = reinterpret_cast<Bits>(wrapping(a.part[i]) + wrapping(b.part[i]));
    return result;
}
WEAVEFRONT_INLINE Integers operator-(const Integers& a) {
    Integers result;
    for (int i = 0; i < registers; ++i) result.part[i] = reinterpret_cast<Bits>(-wrapping(a.part[i]));
    return result;
}

/// Nearest integers, halves to even, as std::llrint. They mean nothing above 2^54 and where a number is not
/// finite.
WEAVEFRONT_INLINE Integers nearest(const Pack& a) {
    Integers result;
    for (int i = 0; i < registers; ++i) {
#if defined(__AVX512DQ__)
        result.part[i] = reinterpret_cast<Bits>(_mm512_maskz_cvtpd_epi64(0xff, a.part[i]));
#else
        // A number below 2^51 added to 3 2^51 is rounded to a whole one, which the last bits of the sum
        // count. A larger one is split into a multiple of 2^27 and a rest, exactly; the multiple is even, so
        // halves of the rest go the way of halves of the whole.
        const Register shift = 0x1.8p52 - Register{};
        const Register high = a.part[i] * 0x1p-27 + shift;
        const Register low = (a.part[i] - (high - shift) * 0x1p27) + shift;
        const auto zero = reinterpret_cast<WrappingBits>(shift);
        result.part[i] = reinterpret_cast<Bits>(((reinterpret_cast<WrappingBits>(high) - zero) << 27) +
                                                (reinterpret_cast<WrappingBits>(low) - zero));
#endif
    }
    return result;
}

/// Nearest doubles, as static_cast<double>.
WEAVEFRONT_INLINE Pack to_pack(const Integers& a) {
    Pack result;
    for (int i = 0; i < registers; ++i) {
#if defined(__AVX512DQ__)
        result.part[i] = _mm512_maskz_cvtepi64_pd(0xff, reinterpret_cast<__m512i>(a.part[i]));
#else
        // The lower half counts the units of 2^52, the upper one, raised by 2^31, those of 2^84: both are
        // exact, and so is their difference to these offsets; only the last sum rounds.
        const auto bits = wrapping(a.part[i]);
        const auto low = reinterpret_cast<Register>((bits & 0xffffffff) | 0x4330000000000000);
        const auto high = reinterpret_cast<Register>((bits >> 32) ^ 0x4530000080000000);
        result.part[i] = (high - (0x1p84 + 0x1p63 + 0x1p52)) + low;
#endif
    }
    return result;
}

}  // namespace weavefront::simd
