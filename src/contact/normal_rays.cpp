#include "weavefront/contact/normal_rays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

Rays rays_of(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals,
             const QuadratureBatch& points) {
    const auto n = interpolate(normals, points.N);
    Rays rays{.origin = interpolate(corners, points.N), .direction = n};
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double square = n.x[i] * n.x[i] + n.y[i] * n.y[i] + n.z[i] * n.z[i];
        const double inverse = (square > 0 ? 1.0 : 0.0) / std::sqrt(square > 0 ? square : 1.0);
        rays.direction.x[i] = n.x[i] * inverse;
        rays.direction.y[i] = n.y[i] * inverse;
        rays.direction.z[i] = n.z[i] * inverse;
    }
    return rays;
}

/// Least and largest coordinate of stretches of lines.
struct Extent {
    Lanes low, high;

    Extent(const Lanes& origin, const Lanes& direction, double back, double ahead) {
        for (std::size_t i = 0; i < batch_width; ++i) {
            const double behind = origin[i] - back * direction[i], before = origin[i] + ahead * direction[i];
            low[i] = behind < before ? behind : before;
            high[i] = behind < before ? before : behind;
        }
    }
    [[nodiscard]] double lowest() const {
        return Eigen::Map<const Eigen::Array<double, batch_width, 1>>(low.of).minCoeff();
    }
    [[nodiscard]] double highest() const {
        return Eigen::Map<const Eigen::Array<double, batch_width, 1>>(high.of).maxCoeff();
    }
};

}  // namespace

NormalRays::NormalRays(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
                       const std::array<Vec3, 4>& normals, double back, double ahead)
    : batch_count_(rule.size()), back_(back), ahead_(ahead) {
    for (std::size_t b = 0; b < batch_count_; ++b) batches[b] = rays_of(corners, normals, rule[b]);
}

bool NormalRays::may_reach(const Box& box) {
    const auto& [origin, direction] = batches[0];
    const auto meets_one = [&](const Lanes& from, const Lanes& along, double low, double high) {
        const double behind = from[0] - back_ * along[0], before = from[0] + ahead_ * along[0];
        return low <= std::max(behind, before) && high >= std::min(behind, before);
    };
    if (meets_one(origin.x, direction.x, box.low.x(), box.high.x()) &&
        meets_one(origin.y, direction.y, box.low.y(), box.high.y()) &&
        meets_one(origin.z, direction.z, box.low.z(), box.high.z()))
        return true;
    if (!stretch_) stretch_ = stretch();
    return box.meets(*stretch_);
}

Box NormalRays::stretch() const {
    Box box{Vec3::Constant(std::numeric_limits<double>::max()),
            Vec3::Constant(-std::numeric_limits<double>::max())};
    for (std::size_t b = 0; b < batch_count_; ++b) {
        const auto& [origin, direction] = batches[b];
        const Extent x(origin.x, direction.x, back_, ahead_), y(origin.y, direction.y, back_, ahead_),
            z(origin.z, direction.z, back_, ahead_);
        box.low = box.low.cwiseMin(Vec3(x.lowest(), y.lowest(), z.lowest()));
        box.high = box.high.cwiseMax(Vec3(x.highest(), y.highest(), z.highest()));
    }
    return box;
}

}  // namespace weavefront::contact
