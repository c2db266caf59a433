#pragma once
/// @file
/// Contact between the projectile and the frame, two rigid bodies.

#include <array>
#include <span>
#include <string_view>

#include "weavefront/body/rigid_body.hpp"
#include "weavefront/contact/frame.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// Each bar of the frame presses along its normal on the projectile's foremost point. The pressure of the
/// projectile's contact law acts on the cross-section of the projectile. Every rank computes the same force.
class ProjectileOnFrame {
  public:
    /// @param top height of the surface on which the last ply rests, m
    ProjectileOnFrame(const scene::Projectile& projectile, const scene::Frame& frame,
                      const scene::ContactLaw& law, double top);

    /// Force on the projectile at its present position, and its moment.
    /// @param dt the last step, s
    [[nodiscard]] body::Wrench evaluate(const body::RigidBody& projectile, double dt);

    /// Penetrations of the four bars, one after the other.
    template <class Archive>
    void state(Archive& archive, std::string_view name) {
        std::array<double, 3 * 4> all;
        for (std::size_t b = 0; b < bars_.size(); ++b) {
            const auto& [overlap, ignored, opened] = bars_[b].penetration;
            all[3 * b] = overlap, all[3 * b + 1] = ignored, all[3 * b + 2] = opened;
        }
        archive(name, std::span(all));
        for (std::size_t b = 0; b < bars_.size(); ++b)
            bars_[b].penetration = {all[3 * b], all[3 * b + 1], all[3 * b + 2]};
    }

  private:
    struct Bar {
        int axis;        ///< direction of the opening that the bar limits
        double outward;  ///< 1 or -1: the side of the opening on which the bar stands
        Penetration penetration;
    };
    FrameShape shape_;  ///< inflated by the edge radius of the projectile
    double area_;       ///< m2
    double
        inset_;  ///< distance of the edge's centre line from the side and from the nose of the projectile, m
    double reach_;  ///< distance of the edge's centre line from the axis, m
    PenaltyLaw law_;
    std::array<Bar, 4> bars_;
};

}  // namespace weavefront::contact
