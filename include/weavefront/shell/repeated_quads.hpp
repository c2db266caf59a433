#pragma once
/// @file
/// Reference geometry of many elements that repeats itself.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/shell/quad.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::shell {

/// The quads of a group's elements in their order. Plies over one grid of columns repeat theirs: one repeat
/// is stored.
class RepeatedQuads {
  public:
    explicit RepeatedQuads(std::span<const Quad<double>> quads);

    /// Number of quads after which they repeat, at least 1.
    [[nodiscard]] std::int32_t repeat_length() const { return repeat_length_; }

    /// That of element `at`, or of any a whole number of periods away. @param at 0..repeat-1
    [[nodiscard]] Quad<double> of(std::int32_t at) const {
        return with_fields<double>([&](std::size_t field) { return *from(at, field); });
    }

    /// Those of eight elements from `at` on. @param at 0..repeat-1
    [[nodiscard]] WEAVEFRONT_INLINE Quad<simd::Pack> pack_from(std::int32_t at) const {
        return with_fields<simd::Pack>([&](std::size_t field) __attribute__((always_inline)) {
            return simd::Pack::load_anywhere(from(at, field));
        });
    }

    [[nodiscard]] std::size_t bytes() const { return fields_.size() * sizeof(double); }

  private:
    [[nodiscard]] WEAVEFRONT_INLINE const double* from(std::int32_t at, std::size_t field) const {
        return fields_.data() + field * length_ + static_cast<std::size_t>(at);
    }
    template <class Real, class Field>
    WEAVEFRONT_INLINE static Quad<Real> with_fields(Field field) {
        return {field(0), field(1), field(2), field(3), field(4), field(5), field(6), field(7)};
    }

    std::int32_t repeat_length_;
    std::size_t length_;  ///< of a field: a repeat and the start of the next, for packs that reach into it
    std::vector<double> fields_;  ///< [field][element]
};

}  // namespace weavefront::shell
