#include "attitude.hpp"

#include <cmath>

#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::scene {

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[0] * b[0] - (a[1] * b[1] + a[2] * b[2] + a[3] * b[3]),
            a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]),
            a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]),
            a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1])};
}

Quaternion about(const std::array<double, 3>& axis, double angle) {
    const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const double along = sine(angle / 2) / length;
    return {cosine(angle / 2), along * axis[0], along * axis[1], along * axis[2]};
}

Quaternion normalized(const Quaternion& q) {
    constexpr double rounding = 1e-14;
    const double square = (q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3]);
    if (std::abs(square - 1) < rounding) return q;
    const double length = std::sqrt(square);
    return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

std::array<double, 3> turned_axis(const Quaternion& q, std::size_t axis) {
    const auto [w, x, y, z] = q;
    if (axis == 0) return {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    if (axis == 1) return {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
    return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

}  // namespace weavefront::scene
