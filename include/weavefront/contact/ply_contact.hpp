#pragma once
/// @file
/// Contact between plies, on the rank that owns the element of the ply nearer to the shot.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/facet_boxes.hpp"
#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/ray.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Integration points of a facet look along the smoothed normal of their ply for the next ply that is not eroded there. The force acts
/// along that line on both sides, so momentum and angular momentum stay as they are.
class PlyContact {
  public:
    /// @param x initial positions, m
    PlyContact(const scene::ContactLaw& law, std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x);

    /// Chooses the facets that may meet while no point moves by more than half of `skin` in x or y; to be called again then, or when
    /// facets were eroded or ghosts changed.
    void update_candidates(const Surface& surface, std::span<const Vec3> x, double skin);

    /// Appends the forces at the present positions.
    /// @param v  velocities over the last step, m/s
    /// @param dt the last step, s
    void evaluate(const Surface& surface, std::span<const Vec3> x, std::span<const Vec3> v, double dt, std::vector<PairForce>& forces);

    /// Whether any point of an owned facet remembers a penetration, or may soon.
    [[nodiscard]] bool touches(std::int32_t facet) const { return !points_[static_cast<std::size_t>(facet)].empty(); }
    /// Memory of the points of an owned facet, to be taken up on another rank.
    void save(std::int32_t facet, std::vector<double>& record) const;
    /// @param record of `save`, with anything after it. @return what comes after it
    std::span<const double> restore(std::int32_t facet, std::span<const double> record);

    /// How far apart footprints may be and still matter, m, without the skin.
    [[nodiscard]] double reach() const { return depth_; }

    /// Overlaps deeper than this are not looked for, m. @param thickness of the thickest ply, m
    static double depth(double thickness);

  private:
    /// A facet that may touch the one at hand.
    struct Near {
        std::int32_t facet, ply;
        double apart;  ///< of the centres, m2
    };
    /// The points of a facet, eight by eight.
    struct Batch {
        std::array<Penetration, batch_width> point;
    };
    /// The points of a batch that have met nothing yet.
    struct OpenPoints {
        std::array<bool, batch_width> lane;
        std::size_t count;
    };
    struct Slave;
    [[nodiscard]] double touching_distance(std::int32_t ply, std::int32_t other) const;
    void find_reachable(const Surface& surface, std::int32_t facet);
    [[nodiscard]] Slave lines_of(std::int32_t facet, const Surface& surface, std::span<const Vec3> x);
    void find_near(const Slave& slave, const Surface& surface, std::span<const Vec3> x);
    bool evaluate_facet(std::int32_t facet, const Surface& surface, std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                        std::vector<PairForce>& forces);
    void press(Slave& slave, const QuadratureBatch& points, const Rays& rays, std::size_t near, const Surface& surface,
               std::span<const Vec3> x, std::span<const Vec3> v, double dt, OpenPoints& open, Batch& batch, std::vector<PairForce>& forces);
    [[nodiscard]] const PenaltyLaw& law(std::int32_t ply, std::int32_t other) const {
        return laws_[static_cast<std::size_t>(ply) * plies_.size() + static_cast<std::size_t>(other)];
    }

    std::vector<PlyProperties> plies_;
    std::vector<PenaltyLaw> laws_;  ///< by the two plies
    double most_touching_ = 0;      ///< largest distance at which plies touch, m
    double depth_ = 0;              ///< overlaps deeper than this are not looked for, m
    Quadrature quadrature_;
    std::vector<std::int32_t> rules_;  ///< of the owned facets
    Candidates candidates_;
    NodalNormals normals_;
    FacetBoxes boxes_;                        ///< now
    std::vector<std::int32_t> reachable_;     ///< candidates of the facet at hand that do not lie wholly beyond reach along z
    std::vector<Near> near_;                  ///< nearest ply first, in it the nearest centre first
    std::vector<std::int32_t> pair_of_;       ///< of each of `near_`: its place among the forces, or -1
    std::vector<std::vector<Batch>> points_;  ///< of the owned facets; empty where they do not touch
    std::vector<double> reserves_;            ///< of the owned facets, J/m2: see PenaltyLaw
};

}  // namespace weavefront::contact
