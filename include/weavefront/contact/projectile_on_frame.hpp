#pragma once
/// @file
/// Contact between the projectile and the frame, two rigid bodies.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "weavefront/body/depth.hpp"
#include "weavefront/body/rigid_body.hpp"
#include "weavefront/contact/coulomb.hpp"
#include "weavefront/contact/frame.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// Forces of the frame on the projectile, and their moments.
struct FromFrame {
    body::Wrench pressure, friction;
};

/// Each bar of the frame presses along its normal on the point of the projectile that is deepest in it. Of a
/// sphere, and of a cylinder along z, this point is known; of any other projectile it is one of its outline.
/// The pressure of the projectile's contact law acts on the cross-section of the projectile, and so does the
/// friction of that law. Every rank computes the same forces.
class ProjectileOnFrame {
  public:
    /// @param top height of the surface on which the last ply rests, m
    ProjectileOnFrame(const scene::Projectile& projectile, const scene::Frame& frame,
                      const scene::ContactLaw& law, double top);

    /// Forces on the projectile at its present position, and their moments.
    /// @param dt the last step, s
    [[nodiscard]] FromFrame evaluate(const body::RigidBody& projectile, double dt);

    /// Penetrations of the bars, one after the other; with friction their tractions, too.
    template <class Archive>
    void state(Archive& archive, std::string_view name) {
        std::vector<double> all(3 * bars_.size());
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const auto& [overlap, ignored, opened] = bars_[b].penetration;
            all[3 * b] = overlap, all[3 * b + 1] = ignored, all[3 * b + 2] = opened;
        }
        archive(name, std::span(all));
        for (std::size_t b = 0; b < bars_.size(); ++b)
            bars_[b].penetration = {all[3 * b], all[3 * b + 1], all[3 * b + 2]};
        if (friction_) friction_state(archive, std::string(name) + ".traction");
    }

  private:
    struct Bar {
        std::optional<Vec3> outward;  ///< from the opening into the bar; none: a ring
        Penetration penetration = {};
        TangentialTraction traction = {};
    };
    /// A point of the projectile in a bar.
    struct Touch {
        Vec3 point;  ///< m
        body::Depth depth;
    };
    [[nodiscard]] static std::vector<Bar> bars_of(const scene::Frame& frame);
    /// The deepest point of the projectile in a bar; none outside.
    [[nodiscard]] std::optional<Touch> deepest_in(const Bar& bar, const body::RigidBody& projectile) const;

    template <class Archive>
    void friction_state(Archive& archive, const std::string& name) {
        std::vector<double> all(4 * bars_.size());
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const auto& [traction, slips] = bars_[b].traction;
            all[4 * b] = traction.x(), all[4 * b + 1] = traction.y(), all[4 * b + 2] = traction.z();
            all[4 * b + 3] = slips ? 1 : 0;
        }
        archive(name, std::span(all));
        for (std::size_t b = 0; b < bars_.size(); ++b)
            bars_[b].traction = {{all[4 * b], all[4 * b + 1], all[4 * b + 2]}, all[4 * b + 3] != 0};
    }

    std::vector<Vec3> outline_;  ///< in body axes, m; empty: the rim of the foremost face, or a centre
    FrameShape shape_;           ///< inflated by the edge radius of a rim
    double area_;                ///< m2
    double
        inset_;  ///< distance of the edge's centre line from the side and from the nose of the projectile, m
    double reach_;  ///< distance of the edge's centre line from the axis, m
    PenaltyLaw law_;
    std::optional<CoulombLaw> friction_;
    std::vector<Bar> bars_;
};

}  // namespace weavefront::contact
