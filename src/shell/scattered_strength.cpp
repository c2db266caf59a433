#include "weavefront/shell/scattered_strength.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "weavefront/scene/trigonometry.hpp"
#include "weavefront/simd/math.hpp"

namespace weavefront::shell {

namespace {

/// Mixes the bits of a number: the finalizer of splitmix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
}

/// A stage of splitmix64 for each number, so that neighbouring places have unrelated bits.
std::uint64_t hashed(std::uint64_t state, std::int64_t number) {
    constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;
    return mixed((state ^ static_cast<std::uint64_t>(number)) + golden_ratio);
}

struct Interval {
    double begin = std::numeric_limits<double>::infinity(), end = -std::numeric_limits<double>::infinity();

    void include(double value) {
        begin = std::min(begin, value);
        end = std::max(end, value);
    }
    [[nodiscard]] double middle() const { return 0.5 * (begin + end); }
};

/// Part of the line at `height` that lies within a convex polygon of corners (along, height). A corner at the
/// height counts as above it.
Interval chord(const std::array<Eigen::Vector2d, 4>& corners, double height) {
    Interval inside;
    for (std::size_t a = 0; a < 4; ++a) {
        const auto &from = corners[a], &to = corners[(a + 1) % 4];
        if ((from.y() <= height) == (to.y() <= height)) continue;
        inside.include(from.x() + (to.x() - from.x()) * ((height - from.y()) / (to.y() - from.y())));
    }
    return inside;
}

std::int64_t cell_of(double place, double size) {
    return static_cast<std::int64_t>(std::floor(place / size));
}

}  // namespace

double exponential_draw(std::int64_t seed, const LinkPlace& place) {
    auto bits = hashed(0, seed);
    bits = hashed(bits, 2 * std::int64_t{place.ply} + (place.warp ? 1 : 0));
    bits = hashed(hashed(bits, place.yarn), place.link);
    // 2^52 numbers evenly inside of (0, 1), each exact
    const double uniform = (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
    return simd::log_ratio(1.0, uniform);
}

double relative_strength(const scene::Scatter& scatter, double length, double draw) {
    const double m = scatter.weibull_modulus;
    const double logarithm =
        (simd::log_ratio(scatter.gauge_length, length) + simd::log_ratio(draw, 1.0)) / m -
        simd::log_gamma(1 + 1 / m);
    return simd::exponential(logarithm);
}

ScatteredStrength::ScatteredStrength(const scene::Fabric& fabric, std::int32_t ply, double angle)
    : scatter_(*fabric.failure->scatter), ply_(ply) {
    const Eigen::Vector2d fill{scene::cosine(angle), scene::sine(angle)}, warp{-fill.y(), fill.x()};
    const auto of_fill = fabric.fill_system(), of_warp = fabric.warp_system();
    yarns_ = {{{false, fill, warp, of_fill.spacing, of_fill.yarn.span},
               {true, warp, fill, of_warp.spacing, of_warp.yarn.span}}};
}

RelativeStrength ScatteredStrength::of(const std::array<Eigen::Vector3d, 4>& corners) const {
    return {mean_of_yarns(yarns_[0], corners), mean_of_yarns(yarns_[1], corners)};
}

double ScatteredStrength::mean_of_yarns(const Yarns& yarns,
                                        const std::array<Eigen::Vector3d, 4>& corners) const {
    std::array<Eigen::Vector2d, 4> turned;
    Interval heights;
    for (std::size_t a = 0; a < 4; ++a) {
        const Eigen::Vector2d corner = corners[a].head<2>();
        turned[a] = {corner.dot(yarns.along), corner.dot(yarns.across)};
        heights.include(turned[a].y());
    }
    const auto strength = [&](std::int64_t yarn, const Interval& part) {
        return relative_strength(scatter_, yarns.link_length, weakest(yarns, yarn, part.begin, part.end));
    };
    double sum = 0, lengths = 0;
    const auto middle_of = [&](std::int64_t yarn) {
        return (static_cast<double>(yarn) + 0.5) * yarns.spacing;
    };
    for (auto yarn = cell_of(heights.begin, yarns.spacing); middle_of(yarn) < heights.end; ++yarn) {
        const auto part = chord(turned, middle_of(yarn));
        const double length = part.end - part.begin;
        if (!(length > 0)) continue;  // the line is beside the element
        sum += length * strength(yarn, part);
        lengths += length;
    }
    if (lengths > 0) return sum / lengths;
    return strength(cell_of(heights.middle(), yarns.spacing), chord(turned, heights.middle()));
}

double ScatteredStrength::weakest(const Yarns& yarns, std::int64_t yarn, double begin, double end) const {
    const auto draw = [&](std::int64_t link) {
        return exponential_draw(scatter_.seed, {ply_, yarns.warp, yarn, link});
    };
    const auto middle_of = [&](std::int64_t link) {
        return (static_cast<double>(link) + 0.5) * yarns.link_length;
    };
    double least = std::numeric_limits<double>::infinity();
    for (auto link = cell_of(begin, yarns.link_length); middle_of(link) < end; ++link)
        if (middle_of(link) >= begin) least = std::min(least, draw(link));
    return std::isfinite(least) ? least : draw(cell_of(0.5 * (begin + end), yarns.link_length));
}

}  // namespace weavefront::shell
