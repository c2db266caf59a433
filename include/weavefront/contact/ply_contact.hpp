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
/// 3. `RaySearch` draws a line through each integration point of a slave, along the smoothed normal of its
///    ply. The line runs forward by the contact distance and backward by `max_penetration`. The master of the
///    point is the first candidate, in the order of `RayTargets`, that the line hits.
/// 4. `PenaltyLaw` turns the overlap of a point into a pressure; `PointMemory` keeps its penetration.
/// 5. `PairForces` shares the pressure out to the nodes of both facets, along the ray on both sides.
///    Therefore momentum and angular momentum are conserved.
/// 6. With friction, `CoulombLaw` turns pressure and slip into a traction, which goes the same way. Its two
///    sides act on mid-surfaces a contact distance apart. So friction conserves momentum, and it makes a
///    couple of its force and the contact distance, which nothing balances.
class PlyContact {
  public:
    /// @param law     of all pairs of plies
    /// @param spacing largest distance between points, m; none: contact at the nodes
    /// @param x       initial positions, m
    PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface,
               std::span<const Vec3> x);

    /// Searches for candidates. They hold while every node stays within half of `skin` of its swept bounds in
    /// x and y, no facet is eroded and the ghosts stay.
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
        FacetTractions* tractions = nullptr;  ///< none without friction
        Vec3 turn{0, 0, 0};                   ///< over the step, rad; with friction only
        ContactResponse sum{};
        bool in_contact = false;
    };
    /// A batch of points of the slave at hand.
    struct Batch {
        const QuadratureBatch& quadrature;
        const Rays& rays;
        PenetrationLanes& points;
        LaneMask unassigned;  ///< points without a master
        std::size_t index;    ///< of the batch
    };
    /// Points of a batch in contact with one target.
    struct Met {
        const LaneMask& points;
        const Lanes& pressure;    ///< Pa
        const ShapeFunctions& N;  ///< of the target
    };
    void evaluate_facet(std::int32_t facet, std::int32_t nearest, const Step& step, ContactForces& forces);
    /// Makes a target the master of the unassigned points whose rays hit it. Applies the penalty law to these
    /// points and adds their forces.
    /// @param target its number in the RaySearch
    void press_batch(Slave& slave, Batch& batch, std::size_t target, const Facet& master, const Step& step,
                     ContactForces& forces);

    /// Adds the friction of the points of a batch with a target.
    void add_friction(Slave& slave, const Batch& batch, std::size_t target, const Facet& master,
                      const Met& met, const Step& step, ContactForces& forces);

    ContactDistances distances_;
    PlyPairLaws laws_;
    std::optional<CoulombLaw> friction_;
    FacetQuadrature quadrature_;
    Candidates candidates_;
    CullingSchedule culling_;
    PointMemory memory_;
    RayTargets targets_;         ///< of the slave at hand
    PairForces pairs_;           ///< of the slave at hand
    PairForces friction_pairs_;  ///< the same of friction
};

}  // namespace weavefront::contact
