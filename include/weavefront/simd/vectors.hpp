#pragma once
/// @file
/// Vectors that stand in memory one after the other, as packs of their components.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "weavefront/simd/pack.hpp"

namespace weavefront::simd {

#if defined(__AVX__)

/// Components of four vectors of three, each in one register: lane l is that of vector l.
struct FourVectors {
    __m256d x, y, z;
};

/// @param vectors x, y, z of each @param index of the four
WEAVEFRONT_INLINE FourVectors gather_four(const double* vectors, const std::int32_t* index) {
    const __m256i three = _mm256_set_epi64x(0, -1, -1, -1);
    const auto row = [&](int i) __attribute__((always_inline)) {
        return _mm256_maskload_pd(vectors + std::ptrdiff_t{3} * index[i], three);
    };
    const __m256d r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const __m256d xz01 = _mm256_unpacklo_pd(r0, r1), xz23 = _mm256_unpacklo_pd(r2, r3);
    const __m256d y01 = _mm256_unpackhi_pd(r0, r1), y23 = _mm256_unpackhi_pd(r2, r3);
    return {_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_permute2f128_pd(y01, y23, 0x20),
            _mm256_permute2f128_pd(xz01, xz23, 0x31)};
}

WEAVEFRONT_INLINE Pack joined(const __m256d& low, const __m256d& high) {
    Pack result;
#if defined(__AVX512F__)
    result.part[0] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
    result.part[0] = low;
    result.part[1] = high;
#endif
    return result;
}

/// Components of eight vectors. @param vectors x, y, z of each @param index of the eight
WEAVEFRONT_INLINE std::array<Pack, 3> gather_vectors(const double* vectors,
                                                     const std::array<std::int32_t, pack_width>& index) {
    const FourVectors low = gather_four(vectors, index.data()), high = gather_four(vectors, index.data() + 4);
    return {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
}

#else

/// Components of eight vectors. @param vectors x, y, z of each @param index of the eight
WEAVEFRONT_INLINE std::array<Pack, 3> gather_vectors(const double* vectors,
                                                     const std::array<std::int32_t, pack_width>& index) {
    std::array<Pack, 3> result;
    for (std::size_t d = 0; d < 3; ++d)
        for (int lane = 0; lane < pack_width; ++lane)
            result[d].set(lane, vectors[std::ptrdiff_t{3} * index[static_cast<std::size_t>(lane)] +
                                        static_cast<std::ptrdiff_t>(d)]);
    return result;
}

#endif

/// Register `i` of `spread<block>`.
template <int block, int i, int... lane>
WEAVEFRONT_INLINE Register spread_register(const Pack& of_vectors, std::integer_sequence<int, lane...>) {
    constexpr int flat = block * pack_width + i * register_width, from = flat / 3 / register_width;
    return __builtin_shufflevector(of_vectors.part[from], of_vectors.part[from],
                                   ((flat + lane) / 3 - from * register_width)...);
}

/// Eight vectors that stand in memory one after the other fill three packs. In pack `block` of these, lane l
/// is a component of vector (8 block + l)/3; here it gets this vector's lane of `of_vectors`.
template <int block>
WEAVEFRONT_INLINE Pack spread(const Pack& of_vectors) {
    Pack result;
    [&]<int... i>(std::integer_sequence<int, i...>) __attribute__((always_inline)) {
        ((result.part[i] =
              spread_register<block, i>(of_vectors, std::make_integer_sequence<int, register_width>{})),
         ...);
    }
    (std::make_integer_sequence<int, registers>{});
    return result;
}

}  // namespace weavefront::simd
