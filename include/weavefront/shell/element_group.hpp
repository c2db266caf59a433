#pragma once
/// @file
/// The elements of one fabric on one rank, in packs of eight.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "weavefront/fabric/features.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/shell/aligned_vector.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/quad.hpp"

namespace weavefront::shell {

/// Lanes of a pack.
inline constexpr int pack_width = 8;

/// Doubles of nodal force that a pack yields: corners 1 to 3, three directions, eight lanes. Corner 4 takes minus the sum.
inline constexpr std::size_t forces_per_pack = std::size_t{3} * 3 * pack_width;

/// One element of a group.
struct GroupElement {
    std::int32_t element = 0;             ///< local index in the part
    std::array<std::int32_t, 4> nodes{};  ///< local
    Quad<double> quad{};
};

/// What the fabric did during a step.
struct Events {
    std::int64_t broken_fill = 0, broken_warp = 0;  ///< yarns broken, element-directions
    struct Erosion {
        std::int32_t element;              ///< local index in the part
        double work, hourglass, friction;  ///< that it leaves behind, J
    };
    std::vector<Erosion> eroded;
    std::vector<double> lost_hourglass;  ///< hourglass potential that broken yarns no longer hold, J
    std::vector<std::int32_t> broken;    ///< local elements in which a yarn broke
};

/// Energies of one element, J.
struct ElementEnergy {
    double work = 0, hourglass = 0, friction = 0;
};

/// What results show of one element.
struct ElementOutput {
    double strain_fill, strain_warp;  ///< 1
    double stress_fill, stress_warp;  ///< of the yarns, Pa
    double braid_angle;               ///< rad
    double crimp_height;              ///< h_f, m
    bool broken_fill, broken_warp;
};

/// Bound on the highest frequency of the elements, and the elements that have turned over.
struct Condition {
    double omega_squared = 0;            ///< 1/s2
    std::vector<std::int32_t> inverted;  ///< local indices in the part
};

/// State and kernel of the elements that share a fabric. What the fabric does not ask for has neither state nor code here.
class ElementGroup {
  public:
    virtual ~ElementGroup() = default;

    /// Number of packs; the last one may be padded with lanes of no area.
    [[nodiscard]] std::int32_t packs() const { return packs_; }
    [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(elements_.size()); }
    /// Local element of lane i % 8 of pack i / 8, ascending.
    [[nodiscard]] std::span<const std::int32_t> elements() const { return elements_; }
    /// Corner nodes of a pack: [corner][lane].
    [[nodiscard]] const std::array<std::array<std::int32_t, pack_width>, 4>& nodes(std::int32_t pack) const {
        return nodes_[static_cast<std::size_t>(pack)];
    }
    [[nodiscard]] bool alive(std::int32_t index) const { return quad(index, 6) > 0; }
    /// Bytes held per element.
    [[nodiscard]] std::size_t bytes() const;

    /// Coefficients that depend on the time step.
    virtual void set_time_step(double dt) = 0;

    /// Advances packs [first, first + count) to positions x.
    /// @param x      positions of the local nodes, m
    /// @param forces count * forces_per_pack doubles, N, [pack][corner][direction][lane]; 64-byte aligned
    virtual void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x, std::span<double> forces,
                         Events& events) = 0;

    /// Bound on the squared frequency over the alive elements, from the instantaneous stiffness in the present state.
    [[nodiscard]] virtual Condition condition(std::span<const Eigen::Vector3d> x) const = 0;

    [[nodiscard]] virtual ElementEnergy energy(std::int32_t index) const = 0;
    /// @param x positions of the local nodes, m
    [[nodiscard]] virtual ElementOutput output(std::int32_t index, std::span<const Eigen::Vector3d> x) const = 0;

    /// All that an element is and has been through, to be taken up by another group of the same fabric.
    void save(std::int32_t index, std::vector<double>& record) const;
    /// @param record of `save`, with anything after it. @return what comes after it
    std::span<const double> restore(std::int32_t index, std::span<const double> record);

    /// Takes an element out (inverted, or broken); what it leaves behind.
    Events::Erosion erode(std::int32_t index);

  protected:
    ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements, int state_size);

    /// Field i of the Quad of an element.
    [[nodiscard]] double quad(std::int32_t index, int field) const { return quads_[slot(index, field, quad_size)]; }
    [[nodiscard]] double hourglass_energy(std::int32_t index) const { return hourglass_energy_[static_cast<std::size_t>(index)]; }
    static std::size_t slot(std::int32_t index, int field, int fields) {
        return static_cast<std::size_t>((index / pack_width * fields + field) * pack_width + index % pack_width);
    }
    void clear_quad(std::int32_t index);

    std::int32_t packs_ = 0;
    int state_size_;
    HourglassStiffness hourglass_;
    double areal_density_ = 0;
    std::vector<std::int32_t> elements_;
    std::vector<std::array<std::array<std::int32_t, pack_width>, 4>> nodes_;
    AlignedVector<double> quads_, state_, hourglass_energy_;
};

/// The group with exactly the features that the fabric asks for.
std::unique_ptr<ElementGroup> make_element_group(const scene::Fabric& fabric, std::span<const GroupElement> elements);

}  // namespace weavefront::shell
