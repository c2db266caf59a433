#pragma once
/// @file
/// Nodal forces as sums that do not depend on their order.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"
#include "weavefront/parallel/fixed_point.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::solver {

/// Adds element and contact forces to the nodes. The last share of every element and of every pair in contact
/// is minus the integer sum of the others, so internal forces add up to exactly nothing.
class Assembly {
  public:
    Assembly() = default;
    /// @param largest_force that a single element or pair in contact is expected to exert, N
    /// @param largest_arm of the forces on a projectile about its centre of mass, m
    Assembly(double largest_force, double largest_arm)
        : scale_(largest_force), moment_scale_(largest_force * largest_arm) {}

    /// Clears the sums and the list of faults.
    void start(std::vector<FixedVector>& sums);

    /// Forces of consecutive packs of a group, as ElementGroup::advance leaves them.
    void add_packs(const shell::ElementGroup& group, std::int32_t first, std::int32_t count,
                   std::span<const double> forces, std::vector<FixedVector>& sums);

    /// A pair in contact. @param on_projectile takes what a pair with a projectile exerts on it
    void add_pair(const contact::PairForce& pair, std::vector<FixedVector>& sums, FixedVector* on_projectile);

    /// A force on one node, N. One that is out of range makes the contact faulty.
    void add_force(const Vec3& force, FixedVector& sum);

    /// The lowest local element whose force was not finite or out of range since `start`, or -1.
    [[nodiscard]] std::int32_t faulty_element() const { return faulty_element_; }
    /// True when a contact force, or its moment on the projectile, was not finite or out of range.
    [[nodiscard]] bool faulty_contact() const {
        return !faulty_contacts_.empty() || faulty_moment_ || faulty_force_;
    }
    /// Nodes of the slaves of these forces.
    [[nodiscard]] const std::vector<std::array<std::int32_t, 4>>& faulty_contacts() const {
        return faulty_contacts_;
    }

    [[nodiscard]] Vec3 value(const FixedVector& sum) const {
        return {scale_.to(sum[0]), scale_.to(sum[1]), scale_.to(sum[2])};
    }
    /// Adds a moment on the projectile, N m.
    void add_moment(const Vec3& moment, FixedVector& sum);
    [[nodiscard]] Vec3 moment(const FixedVector& sum) const {
        return {moment_scale_.to(sum[0]), moment_scale_.to(sum[1]), moment_scale_.to(sum[2])};
    }
    [[nodiscard]] const parallel::FixedPoint& scale() const { return scale_; }

  private:
    /// Adds all lanes of a pack, or none and returns false when one of them is out of range.
    bool add_pack(const std::array<std::array<std::int32_t, shell::pack_width>, 4>& nodes,
                  const double* forces, std::size_t lanes, std::vector<FixedVector>& sums) const;
    void add_lane(const std::array<std::int32_t, 4>& nodes, std::span<const double> forces, std::size_t lane,
                  std::vector<FixedVector>& sums, std::int32_t element);
    void distribute(const std::array<std::int32_t, 4>& nodes, const std::array<Vec3, 4>& forces,
                    const FixedVector& total, std::vector<FixedVector>& sums) const;

    parallel::FixedPoint scale_, moment_scale_;
    bool faulty_moment_ = false, faulty_force_ = false;
    std::int32_t faulty_element_ = -1;
    std::vector<std::array<std::int32_t, 4>> faulty_contacts_;
};

}  // namespace weavefront::solver
