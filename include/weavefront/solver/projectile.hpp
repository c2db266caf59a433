#pragma once
/// @file
/// A projectile of the model.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "weavefront/body/rigid_body.hpp"
#include "weavefront/body/shape.hpp"
#include "weavefront/contact/projectile_contact.hpp"
#include "weavefront/contact/projectile_on_frame.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::solver {

/// A rigid body, the same on all ranks, and its contacts. That with the fabric is of this rank's facets.
struct Projectile {
    body::RigidBody body;
    std::shared_ptr<const body::Shape> shape;
    std::vector<Vec3> surface_points;  ///< in body axes, and the middle of the bounds, m
    double arm = 0;                    ///< bound on the distance of its points from its centre of mass, m
    std::string contact_name = {};     ///< of the state of `contact`
    std::optional<contact::ProjectileContact> contact = {};
    std::optional<contact::ProjectileOnFrame> on_frame = {};

    /// Bound on the speed of its points, m/s.
    [[nodiscard]] double fastest_point() const {
        return body.velocity().norm() + body.angular_velocity().norm() * arm;
    }

    template <class Archive>
    void state(Archive& archive, const std::string& name) {
        body.state(archive, name);
        if (on_frame) on_frame->state(archive, name + "_on_frame");
    }
};

/// A projectile as it starts, without contacts.
Projectile make_projectile(const scene::Projectile& projectile);

/// How deep one projectile is inside another one, m; 0: they are apart. Of the points of their surfaces.
double overlap(const Projectile& one, const Projectile& other);

/// The deepest that two projectiles have been inside each other, since no contact keeps them apart.
struct ProjectileOverlap {
    double depth = 0;                    ///< m
    double time = 0;                     ///< s
    std::int64_t first = 0, second = 0;  ///< of the two, from 0

    /// Takes up the present overlaps.
    void look(const std::vector<Projectile>& projectiles, double now);

    template <class Archive>
    void state(Archive& archive) {
        archive("projectile_overlap.depth", depth);
        archive("projectile_overlap.time", time);
        archive("projectile_overlap.first", first);
        archive("projectile_overlap.second", second);
    }
};

/// Name of a projectile in checkpoints: projectile, projectile2, projectile3 ...
inline std::string name_of_projectile(std::size_t number) {
    return number == 0 ? "projectile" : "projectile" + std::to_string(number + 1);
}

}  // namespace weavefront::solver
