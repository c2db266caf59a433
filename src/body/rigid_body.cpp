#include "weavefront/body/rigid_body.hpp"

namespace weavefront::body {

namespace {

// The iteration gains a factor of dt |W|/2 each time, 1e-3 or less. It ends when nothing changes any more, or
// when the last bit alternates.
constexpr int most_iterations = 30;

/// Rows of the inverse of a symmetric matrix, whose rows are its columns.
std::array<Vec3, 3> inverse_of(const std::array<Vec3, 3>& rows) {
    const std::array<Vec3, 3> cofactors{rows[1].cross(rows[2]), rows[2].cross(rows[0]),
                                        rows[0].cross(rows[1])};
    const double determinant = rows[0].dot(cofactors[0]);
    return {cofactors[0] / determinant, cofactors[1] / determinant, cofactors[2] / determinant};
}

}  // namespace

RigidBody::RigidBody(const Inertia& inertia, bool turns)
    : inertia_(inertia), inverse_(inverse_of(inertia.tensor)), turns_(turns), arm_(inertia.centre) {}

void RigidBody::place(const Vec3& position, const Attitude& attitude, const Vec3& velocity) {
    position_ = position;
    velocity_ = velocity;
    attitude_ = attitude;
    arm_ = attitude_.to_space(inertia_.centre);
}

void RigidBody::spin(const Vec3& angular_velocity) {
    const Vec3 w = attitude_.to_body(angular_velocity);
    const auto& J = inertia_.tensor;
    angular_momentum_ = attitude_.to_space({J[0].dot(w), J[1].dot(w), J[2].dot(w)});
    angular_velocity_ = angular_velocity_of(angular_momentum_);
}

Vec3 RigidBody::angular_velocity_of(const Vec3& angular_momentum) const {
    return attitude_.to_space(inverse_times(attitude_.to_body(angular_momentum)));
}

double RigidBody::kinetic_energy(const Wrench& wrench, double last_dt) const {
    const Vec3 acceleration = wrench.force / inertia_.mass;
    const double of_translation = inertia_.mass * velocity_.dot(Vec3(velocity_ + last_dt * acceleration)) / 2;
    if (!turns_) return of_translation;
    const Vec3 opposite = angular_momentum_ + last_dt * wrench.moment;
    return of_translation + angular_velocity_.dot(opposite) / 2;
}

void RigidBody::accelerate(const Wrench& wrench, double step) {
    velocity_ += step / inertia_.mass * wrench.force;
    if (!turns_) return;
    angular_momentum_ += step * wrench.moment;
    angular_velocity_ = angular_velocity_of(angular_momentum_);
}

void RigidBody::move(double dt) {
    position_ += dt * velocity_;
    if (turns_) turn(dt);
}

void RigidBody::turn(double dt) {
    const Vec3 before = attitude_.to_body(angular_momentum_);
    Vec3 after = before, w;
    for (int i = 0; i < most_iterations; ++i) {
        const Vec3 mean = (before + after) / 2;
        w = inverse_times(mean);
        const Vec3 next = before + dt * mean.cross(w);
        if (next == after) break;
        after = next;
    }
    attitude_ = attitude_.turned(dt * w);
    const Vec3 arm = attitude_.to_space(inertia_.centre);
    position_ += arm_ - arm;  // the centre of mass moves straight on
    arm_ = arm;
    angular_velocity_ = angular_velocity_of(angular_momentum_);
}

void RigidBody::restore(const std::array<double, 4>& quaternion) {
    attitude_ = Attitude::of_unit(quaternion);
    arm_ = attitude_.to_space(inertia_.centre);
    angular_velocity_ = angular_velocity_of(angular_momentum_);
}

}  // namespace weavefront::body
