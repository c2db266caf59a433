#pragma once
/// @file
/// The elements of one fabric on one rank, in packs of eight.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "weavefront/fabric/constants.hpp"
#include "weavefront/fabric/state.hpp"
#include "weavefront/scene/scene.hpp"
#include "weavefront/shell/aligned_vector.hpp"
#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/hourglass.hpp"
#include "weavefront/shell/pack_blocks.hpp"
#include "weavefront/shell/quad.hpp"
#include "weavefront/shell/repeated_quads.hpp"
#include "weavefront/shell/scattered_strength.hpp"
#include "weavefront/simd/vectors.hpp"

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
    RelativeStrength strength{};  ///< read where the fabric's strength is scattered
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

/// Output of one element.
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

/// Names of the stored fields of a fabric's state, in the order in which they are stored.
struct StateNames {
    std::vector<const char*> changing;  ///< of every pack
    std::vector<const char*> packing;   ///< of packs whose yarns are packed
    std::vector<const char*> damage;    ///< of packs with a broken yarn; empty: the fabric does not break
};

/// State and kernel of the elements that share a fabric. A feature that the fabric does not ask for has
/// neither state nor code here.
class ElementGroup {
  public:
    virtual ~ElementGroup() = default;

    /// Number of packs. Copies of earlier elements fill the rest of the last one.
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

    /// Checks the stiffness of elements as soon as a step has advanced them, while their state is in the
    /// cache.
    class Monitor {
      public:
        virtual ~Monitor() = default;
        /// @param first, count packs that have been advanced; a step begins with pack 0
        virtual void check(std::int32_t first, std::int32_t count) = 0;
        /// Whether the last step has made elements stiffer than the bound on the time step allows for.
        [[nodiscard]] virtual bool has_stiffened() const = 0;
    };
    /// @param monitor of this group; null: the stiffness is not checked
    void set_monitor(std::unique_ptr<Monitor> monitor) { monitor_ = std::move(monitor); }
    [[nodiscard]] Monitor* monitor() { return monitor_.get(); }
    [[nodiscard]] bool has_stiffened() const { return monitor_ && monitor_->has_stiffened(); }

    /// Number of alive elements that are folded over themselves. @param x positions of the local nodes, m
    [[nodiscard]] std::int64_t inverted(std::span<const Eigen::Vector3d> x) const;

    [[nodiscard]] IntactYarns intact_yarns(std::int32_t index) const;
    [[nodiscard]] ElementEnergy energy(std::int32_t index) const;
    /// @param x positions of the local nodes, m
    [[nodiscard]] ElementCondition condition(std::int32_t index, std::span<const Eigen::Vector3d> x) const;
    /// @param x positions of the local nodes, m
    [[nodiscard]] ElementOutput output(std::int32_t index, std::span<const Eigen::Vector3d> x) const;

    /// All state of an element, for an archive of module `state`. Lanes that fill the last pack follow the
    /// element that they copy.
    template <class Archive>
    void state(Archive& archive, std::int32_t index) {
        for (int field = 0; field < number_of(names_.changing); ++field)
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
    /// State of a pack, or of one of its elements, with the yarns' stresses. Fields that the fabric does not
    /// ask for have their values at rest.
    [[nodiscard]] virtual fabric::State<simd::Pack> pack_state(std::int32_t pack) const = 0;
    [[nodiscard]] virtual fabric::State<double> element_state(std::int32_t index) const = 0;
    /// Whether any yarns are packed; of the consistent formulation.
    [[nodiscard]] bool any_packed() const { return packing_.any(); }

    [[nodiscard]] const fabric::Constants& constants() const { return constants_; }
    [[nodiscard]] double areal_density() const { return areal_density_; }
    /// Whether all elements are parallelograms.
    [[nodiscard]] bool parallelograms() const { return parallelograms_; }
    [[nodiscard]] const RepeatedQuads& quads() const { return quads_; }
    /// Place of a field among those stored with every pack; -1: not among them.
    [[nodiscard]] int place_of(std::string_view field) const;
    /// The fields stored with every pack, eight lanes each; 64-byte aligned.
    [[nodiscard]] const double* changing_fields(std::int32_t pack) const {
        return state_.data() + slot(pack * pack_width, 0);
    }
    /// What damage has left of a pack: of its elements, its fills and its warps, eight lanes each; null: all.
    [[nodiscard]] const double* damage(std::int32_t pack) const {
        return damage_.fields() > 0 ? damage_.find(pack) : nullptr;
    }
    /// Corners of a pack's elements. @param x positions of the local nodes, m
    [[nodiscard]] WEAVEFRONT_INLINE std::array<Vector<simd::Pack>, 4> corners(
        std::int32_t pack, std::span<const Eigen::Vector3d> x) const {
        std::array<Vector<simd::Pack>, 4> corners;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto [px, py, pz] = simd::gather_vectors(x[0].data(), nodes(pack)[a]);
            corners[a] = {px, py, pz};
        }
        return corners;
    }
    /// Calls with each pack and with the place of its geometry in `quads`.
    template <class Call>
    WEAVEFRONT_INLINE void for_packs(std::int32_t first, std::int32_t count, Call call) const {
        auto at = first * pack_width % quads_.repeat_length();
        for (auto pack = first; pack < first + count; ++pack) {
            call(pack, at);
            at += pack_width;
            if (at >= quads_.repeat_length()) at %= quads_.repeat_length();
        }
    }

    /// Erodes an element of a fabric that breaks. @return the energies that it leaves behind
    Events::Erosion erode(std::int32_t index);

  protected:
    ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements, StateNames names);

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
    [[nodiscard]] std::size_t slot(std::int32_t index, int field) const {
        const auto pack = static_cast<std::size_t>(index / pack_width),
                   lane = static_cast<std::size_t>(index % pack_width);
        return (pack * names_.changing.size() + static_cast<std::size_t>(field)) * pack_width + lane;
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
    AlignedVector<double> weakness_;  ///< of fill and warp of each pack, eight lanes; empty: no scatter
    PackBlocks packing_;              ///< zeros in packs whose yarns do not pack
    PackBlocks damage_;               ///< ones in packs that are whole
    std::unique_ptr<Monitor> monitor_;
    fabric::Constants constants_;

  private:
    [[nodiscard]] std::array<Vector<double>, 4> element_corners(std::int32_t index,
                                                                std::span<const Eigen::Vector3d> x) const;
    /// Half of the angle between the yarns, rad.
    [[nodiscard]] double braid_angle(std::int32_t index, const std::array<Vector<double>, 4>& corners) const;
    /// Elements of consecutive local indices.
    struct Run {
        std::int32_t first, element;  ///< index in the group, local index in the part
    };

    [[nodiscard]] static int number_of(const std::vector<const char*>& fields) {
        return static_cast<int>(fields.size());
    }

    /// Copies an element's state to the lanes that stand for it in the last pack.
    void fill_lanes(std::int32_t index);

    StateNames names_;
    std::vector<Run> runs_;
};

/// The group with exactly the features that the fabric asks for.
std::unique_ptr<ElementGroup> make_element_group(const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements);

}  // namespace weavefront::shell
