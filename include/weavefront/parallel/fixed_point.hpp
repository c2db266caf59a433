#pragma once
/// @file
/// Sums that do not depend on their order.

#include <cmath>
#include <cstdint>

namespace weavefront::parallel {

/// Represents reals as 64-bit integers. Integer addition is associative and commutative. So a sum has the
/// same bits in any order of its terms and with any distribution of them over ranks.
///
/// The scale is a power of two, so scaling does not round. A single term may use 1/256 of the range, so a sum
/// of 256 terms cannot overflow. For nodal forces these are the 4 elements of a node and the contact points
/// around it.
class FixedPoint {
  public:
    FixedPoint() = default;

    /// @param largest expected upper bound of a single term; terms up to 1024 times of it are representable
    explicit FixedPoint(double largest) {
        int exponent = 0;
        std::frexp(largest, &exponent);  // largest <= 2^exponent
        scale_ = std::ldexp(1.0, 62 - 8 - 10 - exponent);
        quantum_ = 1 / scale_;
    }

    /// Upper bound of a term times the scale.
    static constexpr double limit = 0x1p54;

    /// Whether a term is representable. False for NaN and infinity.
    [[nodiscard]] bool fits(double value) const { return std::abs(value) * scale_ < limit; }

    /// Nearest integer of the scaled value. @pre fits(value)
    [[nodiscard]] std::int64_t from(double value) const { return std::llrint(value * scale_); }

    [[nodiscard]] double to(std::int64_t sum) const { return static_cast<double>(sum) * quantum_; }

    [[nodiscard]] double scale() const { return scale_; }

    /// The smallest representable difference.
    [[nodiscard]] double quantum() const { return quantum_; }

  private:
    double scale_ = 1, quantum_ = 1;
};

}  // namespace weavefront::parallel
