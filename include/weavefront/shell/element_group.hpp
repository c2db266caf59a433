#pragma once
/// @file
/// The elements of one fabric on one rank, in packs of eight.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "weavefront/fabric/features.hpp"
#include "weavefront/fabric/vectors.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/shell/aligned_vector.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/null_lagrangian.hpp"
#include "weavefront/shell/pack_blocks.hpp"
#include "weavefront/shell/quad.hpp"
#include "weavefront/shell/repeated_quads.hpp"

namespace weavefront::shell {

/// Lanes of a pack.
inline constexpr int pack_width = 8;

/// Doubles of nodal force that a pack yields: corners 1 to 3, three directions, eight lanes. Corner 4 takes
/// minus the sum.
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

/// Energies of one element.
struct ElementEnergy {
    double work = 0, hourglass = 0, friction = 0;  ///< J
};

/// What results show of one element.
struct ElementOutput {
    double strain_fill, strain_warp;  ///< 1
    double stress_fill, stress_warp;  ///< of the yarns, Pa
    double braid_angle;               ///< rad
    double crimp_height;              ///< h_f, m
    bool broken_fill, broken_warp;

    template <class Archive>
    void state(Archive& archive) {
        archive("strain_fill", strain_fill), archive("strain_warp", strain_warp);
        archive("stress_fill", stress_fill), archive("stress_warp", stress_warp);
        archive("braid_angle", braid_angle), archive("crimp_height", crimp_height);
        double fill = broken_fill ? 1 : 0, warp = broken_warp ? 1 : 0;
        archive("broken_fill", fill), archive("broken_warp", warp);
        broken_fill = fill != 0, broken_warp = warp != 0;
    }
};

/// What may have gone wrong with an element.
struct ElementCondition {
    bool folded = false;        ///< folded over itself
    double contact_factor = 0;  ///< alpha: 0 in the open trellis, 1 from the locking angle on
    double braid_angle = 0;     ///< half of the angle between the yarns, rad
};

/// Which yarns of an element are not broken.
struct IntactYarns {
    bool fill = true, warp = true;
};

/// Stored fields of a fabric's state, by how many packs need them.
struct StateSizes {
    int changing, packing,
        damage;  ///< of damage with that of the element, none where the fabric does not break
};

/// Names of these fields, in the order in which they are stored.
struct StateNames {
    std::vector<const char*> changing, packing, damage;
};

/// State and kernel of the elements that share a fabric. What the fabric does not ask for has neither state
/// nor code here.
class ElementGroup {
  public:
    virtual ~ElementGroup() = default;

    /// Number of packs; where the last one is not full, elements of before fill its lanes.
    [[nodiscard]] std::int32_t packs() const { return packs_; }
    [[nodiscard]] std::int32_t size() const { return size_; }
    /// Local element of lane index % 8 of pack index / 8, ascending.
    [[nodiscard]] std::int32_t element(std::int32_t index) const;
    /// Corner nodes of a pack: [corner][lane].
    [[nodiscard]] const std::array<std::array<std::int32_t, pack_width>, 4>& nodes(std::int32_t pack) const {
        return nodes_[static_cast<std::size_t>(pack)];
    }
    [[nodiscard]] bool alive(std::int32_t index) const {
        return damage_.fields() == 0 || damage_.get(index / pack_width, alive_field, index % pack_width) > 0;
    }
    /// Bytes held per element.
    [[nodiscard]] std::size_t bytes() const;

    /// Coefficients that depend on the time step.
    virtual void set_time_step(double dt) = 0;

    /// Advances packs [first, first + count) to positions x.
    /// @param x      positions of the local nodes, m
    /// @param forces count * forces_per_pack doubles, N, [pack][corner][direction][lane]; 64-byte aligned
    virtual void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x,
                         std::span<double> forces, Events& events) = 0;

    /// Bounds on the squared frequencies over the alive elements, from the instantaneous stiffness in the
    /// present state with all crossovers held.
    [[nodiscard]] virtual Frequencies<double> frequencies() const = 0;

    /// Whether `tighten` may find less by free crossovers and a coupling of fill and warp: yarns are crimped,
    /// in the consistent formulation.
    [[nodiscard]] virtual bool is_crimped() const = 0;
    /// Whether it may by redistributed mass: yarns are packed.
    [[nodiscard]] virtual bool is_packed() const = 0;

    /// Raises tighter bounds on `along` for each of `null_lagrangians` by those of the alive elements, with
    /// the crossovers that are free let go.
    /// @param x positions of the local nodes, m
    void tighten(const TighteningStart& start, std::span<const Eigen::Vector3d> x, TightBounds& bounds) const;

    /// omega^2 in the plane of the alive elements if their yarns were slack and at right angles, 1/s2; 0
    /// where `tighten` lets no crossover go. It follows from the stretches and the crossover alone, and rises
    /// when slack yarns straighten.
    [[nodiscard]] virtual double slack_frequency(const NullLagrangian& term, double smallest_area) const = 0;

    /// What makes yarns stiffer than the bounds allow for, to be looked out for from now on. By default
    /// nothing.
    struct StiffeningTrigger {
        double slack = std::numeric_limits<double>::infinity();  ///< the first slack_frequency above it, 1/s2
        NullLagrangian term{};
        double smallest_area = 0;  ///< m2
        bool packing = false;      ///< the first packed yarns, where none of any rank are
    };
    void set_trigger(const StiffeningTrigger& trigger) { trigger_ = trigger; }
    /// Whether it has come, in the last step of all elements.
    [[nodiscard]] bool has_stiffened() const {
        return has_straightened_ || (trigger_.packing && is_packed());
    }

    /// Least n |n| over the alive elements, n the cosine of the angle between the element's normal and
    /// `axis`, of unit length; at most `known`. It stops looking where it finds less than `enough`. @param x
    /// positions of the local nodes, m
    [[nodiscard]] double least_facing(std::span<const Eigen::Vector3d> x, const Eigen::Vector3d& axis,
                                      double known, double enough);

    /// Number of alive elements that are folded over themselves. @param x positions of the local nodes, m
    [[nodiscard]] virtual std::int64_t inverted(std::span<const Eigen::Vector3d> x) const = 0;

    [[nodiscard]] virtual IntactYarns intact_yarns(std::int32_t index) const = 0;
    [[nodiscard]] virtual ElementEnergy energy(std::int32_t index) const = 0;
    /// @param x positions of the local nodes, m
    [[nodiscard]] virtual ElementCondition condition(std::int32_t index,
                                                     std::span<const Eigen::Vector3d> x) const = 0;
    /// @param x positions of the local nodes, m
    [[nodiscard]] virtual ElementOutput output(std::int32_t index,
                                               std::span<const Eigen::Vector3d> x) const = 0;

    /// All state of an element, for an archive of module `state`. Lanes that fill the last pack follow the
    /// element that they copy.
    template <class Archive>
    void state(Archive& archive, std::int32_t index) {
        for (int field = 0; field < changing_fields_; ++field)
            archive(names_.changing[static_cast<std::size_t>(field)], state_[slot(index, field)]);
        const auto of_blocks = [&](PackBlocks& blocks, const std::vector<const char*>& names) {
            for (int field = 0; field < blocks.fields(); ++field) {
                double value = blocks.get(index / pack_width, field, index % pack_width);
                archive(names[static_cast<std::size_t>(field)], value);
                if constexpr (Archive::reads)
                    blocks.set(index / pack_width, field, index % pack_width, value);
            }
        };
        of_blocks(packing_, names_.packing);
        of_blocks(damage_, names_.damage);
        archive("hourglass_energy", hourglass_energy_[static_cast<std::size_t>(index)]);
        if constexpr (Archive::reads) fill_lanes(index);
    }

    /// Takes an element of a fabric that breaks out; what it leaves behind.
    Events::Erosion erode(std::int32_t index);

  protected:
    /// What `tighten` does, of uniform deformation alone: without hourglass modes.
    virtual void tighten_uniform(const TighteningStart& start, std::span<const Eigen::Vector3d> x,
                                 TightBounds& bounds) const = 0;

    ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements, const StateSizes& sizes,
                 StateNames names);

    /// Reference geometry of an element, eroded or not.
    [[nodiscard]] Quad<double> whole_quad(std::int32_t index) const {
        return quads_.of(index % quads_.repeat_length());
    }
    [[nodiscard]] double area(std::int32_t index) const {
        return alive(index) ? whole_quad(index).area : 0.0;
    }
    [[nodiscard]] double hourglass_energy(std::int32_t index) const {
        return hourglass_energy_[static_cast<std::size_t>(index)];
    }
    std::size_t slot(std::int32_t index, int field) const {
        const auto pack = static_cast<std::size_t>(index / pack_width),
                   lane = static_cast<std::size_t>(index % pack_width);
        return (pack * static_cast<std::size_t>(changing_fields_) + static_cast<std::size_t>(field)) *
                   pack_width +
               lane;
    }
    /// Corners of a pack's elements.
    [[nodiscard]] WEAVEFRONT_INLINE std::array<Vector<fabric::Pack>, 4> gather(
        std::int32_t pack, std::span<const Eigen::Vector3d> x) const {
        std::array<Vector<fabric::Pack>, 4> corners;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto [px, py, pz] = fabric::gather_vectors(x[0].data(), nodes(pack)[a]);
            corners[a] = {px, py, pz};
        }
        return corners;
    }
    void take_out(std::int32_t index) { damage_.set(index / pack_width, alive_field, index % pack_width, 0); }

    /// Of damage_: 1, or 0 once the element is eroded. The fabric's flags follow it.
    static constexpr int alive_field = 0;

    std::int32_t size_, packs_;
    HourglassStiffness hourglass_;
    bool parallelograms_ = true;  ///< all of the elements
    double areal_density_ = 0;
    std::vector<std::array<std::array<std::int32_t, pack_width>, 4>> nodes_;
    RepeatedQuads quads_;
    AlignedVector<double> state_, hourglass_energy_;
    PackBlocks packing_;  ///< zeros in packs whose yarns do not pack
    PackBlocks damage_;   ///< ones in packs that are whole
    StiffeningTrigger trigger_;
    bool has_straightened_ = false;

  private:
    /// Elements of consecutive local indices.
    struct Run {
        std::int32_t first, element;  ///< index in the group, local index in the part
    };

    /// Copies an element's state to the lanes that stand for it in the last pack.
    void fill_lanes(std::int32_t index);

    int changing_fields_;
    StateNames names_;
    std::vector<Run> runs_;
    std::int32_t steepest_ = 0;  // pack in which least_facing found enough, to start from
};

/// The group with exactly the features that the fabric asks for.
std::unique_ptr<ElementGroup> make_element_group(const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements);

}  // namespace weavefront::shell
