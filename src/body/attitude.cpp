#include "weavefront/body/attitude.hpp"

namespace weavefront::body {

Attitude::Attitude(const std::array<double, 4>& quaternion) : q_(quaternion) {
    const double length = std::sqrt((q_[0] * q_[0] + q_[1] * q_[1]) + (q_[2] * q_[2] + q_[3] * q_[3]));
    for (auto& part : q_) part /= length;
    find_rows();
}

Attitude Attitude::of_unit(const std::array<double, 4>& quaternion) {
    Attitude attitude;
    attitude.q_ = quaternion;
    attitude.find_rows();
    return attitude;
}

void Attitude::find_rows() {
    const auto [w, x, y, z] = q_;
    rows_ = {Vec3(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
             Vec3(2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
             Vec3(2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))};
}

Attitude Attitude::turned(const Vec3& v) const {
    const auto [w, x, y, z] = q_;
    const double a = v.x() / 2, b = v.y() / 2, c = v.z() / 2;
    // The product with the quaternion (1, v/2), before it is normalised.
    return Attitude({w - (x * a + y * b + z * c), x + (w * a + y * c - z * b), y + (w * b + z * a - x * c),
                     z + (w * c + x * b - y * a)});
}

}  // namespace weavefront::body
