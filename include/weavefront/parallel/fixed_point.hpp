#pragma once
/// @file
/// Sums that do not depend on their order.

#include <cmath>
#include <cstdint>

namespace weavefront::parallel {

/// Represents reals as 64-bit integers. Integers add associatively and commutatively, so a sum has the same
/// bits whatever the order of its terms and however they are spread over ranks.
///
/// The scale is a power of two, so that scaling itself never rounds. A single term may use 1/256 of the
/// range: a sum of up to 256 terms cannot overflow. For nodal forces that is the valence of a node (4
/// elements) plus the contact points around it.
class FixedPoint {
  public:
    FixedPoint() = default;

    /// @param largest a magnitude that no single term is expected to pass; up to 1024 times of it is
    /// representable
    explicit FixedPoint(double largest) {
        int exponent = 0;
        std::frexp(largest, &exponent);  // largest <= 2^exponent
        scale_ = std::ldexp(1.0, 62 - 8 - 10 - exponent);
        quantum_ = 1 / scale_;
    }

    /// A term times the scale stays below this.
    static constexpr double limit = 0x1p54;

    /// True when a term of this value may be added; false for NaN and infinity.
    [[nodiscard]] bool fits(double value) const { return std::abs(value) * scale_ < limit; }

    /// Nearest integer of the scaled value. @pre fits(value)
    [[nodiscard]] std::int64_t from(double value) const { return std::llrint(value * scale_); }

    [[nodiscard]] double to(std::int64_t sum) const { return static_cast<double>(sum) * quantum_; }

    [[nodiscard]] double scale() const { return scale_; }

    /// The smallest difference that is represented.
    [[nodiscard]] double quantum() const { return quantum_; }

  private:
    double scale_ = 1, quantum_ = 1;
};

}  // namespace weavefront::parallel
