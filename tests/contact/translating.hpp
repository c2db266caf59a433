#pragma once
/// @file
/// A projectile that moves without turning.

#include "weavefront/body/rigid_body.hpp"

namespace weavefront {

struct Translating {
    Vec3 position{0, 0, 0}, velocity{0, 0, 0};  // m, m/s

    operator body::RigidBody() const {
        body::RigidBody body({.mass = 1}, false);
        body.place(position, body::Attitude(), velocity);
        return body;
    }
};

}  // namespace weavefront
