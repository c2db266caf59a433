#include "weavefront/contact/whereabouts.hpp"

#include <cstdint>
#include <cstring>

namespace weavefront::contact {

Whereabouts::Whereabouts(std::span<const Vec3> x, std::span<const Vec3> v, double ahead) : corners_(x.size()) {
    for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3 then = x[n] + ahead * v[n];
        const Vec3 low = x[n].cwiseMin(then), high = x[n].cwiseMax(then);
        corners_[n] = {static_cast<float>(low.x()), static_cast<float>(low.y()), static_cast<float>(high.x()),
                       static_cast<float>(high.y())};
    }
}

bool Whereabouts::any_left(std::span<const Vec3> x, double margin) const {
    using Floats [[gnu::vector_size(16)]] = float;
    using TwoDoubles [[gnu::vector_size(16)]] = double;
    using Doubles [[gnu::vector_size(32)]] = double;
    constexpr Doubles outwards{1, 1, -1, -1};
    using Bits [[gnu::vector_size(32)]] = std::int64_t;
    Bits left{};
    for (std::size_t n = 0; n < x.size(); ++n) {
        Floats corners;
        TwoDoubles at;
        std::memcpy(&corners, corners_[n].data(), sizeof corners);
        std::memcpy(&at, x[n].data(), sizeof at);
        left |= (__builtin_convertvector(corners, Doubles) - __builtin_shufflevector(at, at, 0, 1, 0, 1)) * outwards > margin;
    }
    return (left[0] | left[1] | left[2] | left[3]) != 0;
}

}  // namespace weavefront::contact
