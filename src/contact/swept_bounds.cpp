#include "weavefront/contact/swept_bounds.hpp"

#include <cmath>

#include "weavefront/simd/short_vectors.hpp"

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
    const auto whole = x.size() / 2 * 2;
    simd::Mask4 outside{};
    for (std::size_t n = 0; n < whole; n += 2) {
        const auto middle = simd::widened(simd::load<simd::Float4>(middles_[n].data()));
        const auto half = simd::widened(simd::load<simd::Float4>(halves_[n].data()));
        const auto position =
            simd::joined(simd::load<simd::Double2>(x[n].data()), simd::load<simd::Double2>(x[n + 1].data()));
        outside |= simd::abs(position - middle) - half > margin;
    }
    bool found = simd::any(outside);
    for (std::size_t n = whole; n < x.size(); ++n)
        for (std::size_t d = 0; d < 2; ++d) {
            const double way = x[n][static_cast<Eigen::Index>(d)] - static_cast<double>(middles_[n][d]);
            found = found || std::abs(way) - static_cast<double>(halves_[n][d]) > margin;
        }
    return found;
}

}  // namespace weavefront::contact
