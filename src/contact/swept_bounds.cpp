#include "weavefront/contact/swept_bounds.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace weavefront::contact {

SweptBounds::SweptBounds(std::span<const Vec3> x, std::span<const Vec3> v, double ahead)
    : middles_(x.size()), halves_(x.size()) {
    for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3 way = ahead / 2 * v[n], middle = x[n] + way;
        middles_[n] = {static_cast<float>(middle.x()), static_cast<float>(middle.y())};
        halves_[n] = {static_cast<float>(std::abs(way.x())), static_cast<float>(std::abs(way.y()))};
    }
}

bool SweptBounds::any_outside(std::span<const Vec3> x, double margin) const {
    using Floats [[gnu::vector_size(16)]] = float;
    using TwoDoubles [[gnu::vector_size(16)]] = double;
    using Doubles [[gnu::vector_size(32)]] = double;
    using Bits [[gnu::vector_size(32)]] = std::int64_t;
    const auto whole = x.size() / 2 * 2;
    Bits left{};
    for (std::size_t n = 0; n < whole; n += 2) {
        Floats middle, half;
        TwoDoubles one, other;
        std::memcpy(&middle, middles_[n].data(), sizeof middle);
        std::memcpy(&half, halves_[n].data(), sizeof half);
        std::memcpy(&one, x[n].data(), sizeof one);
        std::memcpy(&other, x[n + 1].data(), sizeof other);
        const Doubles way =
            __builtin_shufflevector(one, other, 0, 1, 2, 3) - __builtin_convertvector(middle, Doubles);
        const auto size =
            reinterpret_cast<Doubles>(reinterpret_cast<Bits>(way) & std::int64_t{0x7fffffffffffffff});
        left |= size - __builtin_convertvector(half, Doubles) > margin;
    }
    bool found = (left[0] | left[1] | left[2] | left[3]) != 0;
    for (std::size_t n = whole; n < x.size(); ++n)
        for (std::size_t d = 0; d < 2; ++d) {
            const double way = x[n][static_cast<Eigen::Index>(d)] - static_cast<double>(middles_[n][d]);
            found = found || std::abs(way) - static_cast<double>(halves_[n][d]) > margin;
        }
    return found;
}

}  // namespace weavefront::contact
