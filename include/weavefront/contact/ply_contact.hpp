#pragma once
/// @file
/// Contact between plies, on the rank that owns the element of the ply nearer to the shot.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/clearance_query.hpp"
#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/contact_forces.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/point_memory.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/ray_targets.hpp"
#include "weavefront/contact/relative_motion_bound.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Integration points of a facet look along the smoothed normal of their ply for the next ply that is not
/// eroded there. The force acts along that line on both sides, so momentum and angular momentum stay as they
/// are.
///
/// A facet that cannot touch anything before others have approached by some distance is left alone until they
/// have.
class PlyContact {
  public:
    /// @param x initial positions, m
    PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
               std::span<const Vec3> x);

    /// Chooses the facets that may meet while no node is more than half of `skin` away from where it is
    /// expected in x or y; to be called again then, or when facets were eroded or ghosts changed. @param x
    /// present positions, m
    void update_candidates(const Surface& surface, const SweptBounds& swept, std::span<const Vec3> x,
                           double skin);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param v       velocities over the last step, m/s: nodes have moved by `dt` times these since the last
    /// call
    /// @param dt      the last step, s
    /// @param sliding_share part of the overlap brought about by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces);

    /// Owned facets whose middle lies behind one of the next ply, as seen along their normals; rims of holes
    /// do not count.
    [[nodiscard]] std::vector<std::int32_t> behind_next_ply(const Surface& surface,
                                                            std::span<const Vec3> x) const;

    /// Whether any point of an owned facet remembers a penetration.
    [[nodiscard]] bool touches(std::int32_t facet) const { return memory_.holds(facet); }
    /// State of an owned facet.
    template <class Archive>
    void state(Archive& archive, std::int32_t facet) {
        auto& budget = dissipated_budgets_[static_cast<std::size_t>(facet)];
        if (archive.size("dissipated_budget", budget != 0 ? 1 : 0) > 0) archive("dissipated_budget", budget);
        constexpr std::size_t lanes = most_batches * batch_width;
        if (archive.size("overlap", memory_.holds(facet) ? lanes : 0) == 0) return;
        FacetPoints points = memory_.recall(facet);
        for (auto& batch : points)
            for (std::size_t i = 0; i < batch_width; ++i) {
                Penetration point{batch.overlap[i], batch.ignored[i], batch.opened[i]};
                point.state(archive);
                batch.overlap[i] = point.overlap, batch.ignored[i] = point.ignored,
                batch.opened[i] = point.opened;
            }
        if constexpr (Archive::reads) memory_.keep(facet, points);
    }

  private:
    /// What a facet waits for while it touches nothing.
    enum class Culled : std::uint8_t {
        no,             ///< it may touch something
        by_group,       ///< for the approach of all candidates of its group
        by_candidates,  ///< for that of its own near candidates, which is much less and costs more to know
    };
    /// What a facet knows of its candidates. There is one for every element of a rank.
    struct [[gnu::packed]] CullingState {
        float until = 0;  ///< approach of the group up to which it holds, m; where it waits for its own, what
                          ///< is left to these
        std::int32_t first =
            -1;          ///< the nearest candidate, or -1: not known; where the facet waits, the one that was
        Shortlist near;  ///< of the candidates
        Culled culled = Culled::no;
    };
    static_assert(sizeof(CullingState) == 17);
    /// Where and when.
    struct Now {
        const Surface& surface;
        NodalNormals& normals;
        std::span<const Vec3> x, v;
        double dt, sliding_share;
    };
    /// The points of a facet and what they meet.
    struct Slave {
        std::int32_t facet;
        std::array<Vec3, 4> velocities;
        FacetPoints points;
        Surroundings around;
        ContactResponse sum{};
        bool touching = false;
    };
    [[nodiscard]] std::span<CullingState> culling_states(std::int32_t group) {
        return std::span(culling_).subspan(relative_motion_.before(group),
                                           relative_motion_.facets(group).size());
    }
    void evaluate_group(std::int32_t group, const Now& now, ContactForces& forces);
    /// By how much a facet and its near candidates may have approached over the last step, m.
    [[nodiscard]] double own_approach(std::int32_t facet, const Shortlist& near, const Now& now) const;
    /// Whether what a facet knows no longer holds.
    [[nodiscard]] bool expired(CullingState& state, std::int32_t facet, double accumulated,
                               const Now& now) const;
    void recheck(std::int32_t facet, CullingState& state, std::int32_t group, const Now& now);
    void evaluate_facet(std::int32_t facet, std::int32_t first, const Now& now, ContactForces& forces);
    void press(Slave& slave, const QuadratureBatch& batch, const Rays& rays, PenetrationLanes& points,
               std::size_t near, LaneMask& open, const Now& now, ContactForces& forces);
    [[nodiscard]] const PenaltyLaw& law(std::int32_t ply, std::int32_t other) const {
        return laws_[weights_[static_cast<std::size_t>(ply)] * different_weights_ +
                     weights_[static_cast<std::size_t>(other)]];
    }

    ContactDistances distances_;
    std::vector<std::size_t> weights_;  ///< by ply: index among the different areal densities
    std::size_t different_weights_;
    std::vector<PenaltyLaw> laws_;  ///< by the areal densities of the two plies
    Quadrature quadrature_;
    Candidates candidates_;
    RelativeMotionBound relative_motion_;
    RayTargets targets_;                 ///< of the facet at hand
    std::vector<std::int32_t> pair_of_;  ///< of each of `targets_`: its place among the forces, or -1
    std::vector<CullingState> culling_;  ///< of the owned facets, group by group
    std::vector<double> due_;  ///< of each group: when its first facet has to be looked at, as bounded by
                               ///< RelativeMotionBound, m
    // of the owned facets
    std::vector<std::uint8_t> rules_;
    PointMemory memory_;
    std::vector<double> dissipated_budgets_;  ///< J/m2: see PenaltyLaw
};

}  // namespace weavefront::contact
