#pragma once
/// @file
/// Contact between plies, on the rank that owns the element of the ply nearer to the shot.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/contact_forces.hpp"
#include "weavefront/contact/culling_schedule.hpp"
#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/pair_forces.hpp"
#include "weavefront/contact/ply_pair_laws.hpp"
#include "weavefront/contact/point_memory.hpp"
#include "weavefront/contact/ray_search.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Penalty contact of facets with the plies behind them. Every owned facet is a slave; the facets that its
/// points meet are its masters.
///
/// 1. `Candidates` lists, at a search, the facets that may come within contact distance before the next one.
/// 2. `CullingSchedule` leaves out slaves that cannot touch a candidate in this step.
/// 3. `RaySearch` follows a ray from each integration point of a slave, along the smoothed normal of its ply.
///    The first facet that the ray hits is the master of the point.
/// 4. `PenaltyLaw` turns the overlap of a point into a pressure; `PointMemory` keeps its penetration.
/// 5. `PairForces` shares the pressure out to the nodes of both facets, along the ray on both sides.
///    Therefore momentum and angular momentum are conserved.
class PlyContact {
  public:
    /// @param law     of all pairs of plies
    /// @param spacing largest distance between points, m; none: contact at the nodes
    /// @param x       initial positions, m
    PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
               std::span<const Vec3> x);

    /// Searches for candidates. They hold until a node is more than half of `skin` outside of its swept
    /// bounds in x or y, a facet is eroded or ghosts change.
    /// @param x    present positions, m
    /// @param skin m
    void update_candidates(const Surface& surface, const SweptBounds& swept, std::span<const Vec3> x,
                           double skin);

    /// Appends the forces at the present positions.
    /// @param normals of the plies, at these positions
    /// @param x       present positions, m
    /// @param v       velocities over the last step, m/s: a node has moved by `dt` times its velocity since
    ///                the last call
    /// @param dt      length of the last step, s
    /// @param sliding_share part of the overlap caused by sliding that may press, see Surroundings
    void evaluate(const Surface& surface, NodalNormals& normals, std::span<const Vec3> x,
                  std::span<const Vec3> v, double dt, double sliding_share, ContactForces& forces);

    /// See `facets_behind_next_ply`. @param x present positions, m
    [[nodiscard]] std::vector<std::int32_t> behind_next_ply(const Surface& surface,
                                                            std::span<const Vec3> x) const;

    /// Whether any point of an owned facet is in contact.
    [[nodiscard]] bool touches(std::int32_t facet) const { return memory_.holds(facet); }
    /// The largest penetration of an owned facet's points, in contact distances to the next ply.
    [[nodiscard]] double penetration(const Surface& surface, std::int32_t facet) const;
    /// State of an owned facet.
    template <class Archive>
    void state(Archive& archive, std::int32_t facet) {
        memory_.state(archive, facet);
    }

  private:
    /// Input of a step.
    struct Step {
        const Surface& surface;
        NodalNormals& normals;
        NodalMotion nodes;
        double sliding_share;
    };
    /// The slave at hand: constants of the step, and sums over its points.
    struct Slave {
        const Facet& facet;
        double area;  ///< initial, m2
        std::array<Vec3, 4> velocities;
        FacetPoints points;
        Surroundings around;
        ContactResponse sum{};
        bool in_contact = false;
    };
    void evaluate_facet(std::int32_t facet, std::int32_t nearest, const Step& step, ContactForces& forces);
    /// Applies the penalty law to the points of a batch whose rays hit one target, and adds their forces.
    /// @param open points without a master; those that hit are taken out
    void press_batch(Slave& slave, PenetrationLanes& points, const QuadratureBatch& batch, const Rays& rays,
                     std::size_t target, const Facet& master, LaneMask& open, const Step& step,
                     ContactForces& forces);

    ContactDistances distances_;
    PlyPairLaws laws_;
    FacetQuadrature quadrature_;
    Candidates candidates_;
    CullingSchedule culling_;
    PointMemory memory_;
    RayTargets targets_;  ///< of the slave at hand
    PairForces pairs_;    ///< of the slave at hand
};

}  // namespace weavefront::contact
