#pragma once
/// @file
/// The element group of one set of features.

#include <utility>

#include "largest_lane.hpp"
#include "weavefront/fabric/cell.hpp"
#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/shell/internal_force.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::shell {

template <fabric::Features F>
class FeatureGroup final : public ElementGroup {
    using Pack = simd::Pack;
    using Fields = fabric::Fields;
    static constexpr int changing_fields = fabric::state_size<F, Fields::changing>();
    static constexpr bool packs_yarns = fabric::state_size<F, Fields::packing>() > 0;

  public:
    FeatureGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements)
        : ElementGroup(fabric, elements, names()), any_yarn_(any_yarn_erodes(fabric)) {
        const auto initial = fabric::initial_state<F, Pack>(constants_);
        for (std::int32_t pack = 0; pack < packs_; ++pack) store(pack, initial);
        if constexpr (F.scatter) set_weakness(elements);
    }

    void set_time_step(double dt) override { step_ = fabric::step_of(constants_, F, dt); }

    void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x,
                 std::span<double> forces, Events& events) override {
        for_packs(first, count, [&](std::int32_t pack, std::int32_t at) {
            advance_pack(pack, at, x,
                         forces.data() + static_cast<std::size_t>(pack - first) * forces_per_pack, events);
        });
        if (monitor_) monitor_->check(first, count);
    }

    [[nodiscard]] Frequencies<double> frequencies() const override {
        Frequencies<Pack> highest;
        for_packs(0, packs_, [&](std::int32_t pack, std::int32_t at) {
            auto quad = quads_.pack_from(at);
            const auto state = load(pack, quad);
            const auto alive = quad.area > 0.0;
            const auto bounds = critical_frequencies(quad, fabric::stiffness_bound<F>(constants_, state),
                                                     state, hourglass_, areal_density_);
            raise(highest.in_plane, alive, bounds.in_plane);
            raise(highest.out_of_plane, alive, bounds.out_of_plane);
            raise(highest.hourglass, alive, bounds.hourglass);
        });
        return {largest_lane(highest.in_plane), largest_lane(highest.out_of_plane),
                largest_lane(highest.hourglass)};
    }

    [[nodiscard]] fabric::State<Pack> pack_state(std::int32_t pack) const override {
        Quad<Pack> no_quad{};
        auto state = load(pack, no_quad);
        add_stresses(state);
        return state;
    }

    [[nodiscard]] fabric::State<double> element_state(std::int32_t index) const override {
        fabric::State<double> state;
        std::array<double, changing_fields> fields;
        for (int f = 0; f < changing_fields; ++f)
            fields[static_cast<std::size_t>(f)] = state_[slot(index, f)];
        fabric::load_fields<F, double, Fields::changing>(state, fields.data());
        if constexpr (packs_yarns) fill_from<Fields::packing>(packing_, 0, index, state);
        if constexpr (F.failure) fill_from<Fields::damage>(damage_, alive_field + 1, index, state);
        add_stresses(state);
        return state;
    }

  private:
    WEAVEFRONT_INLINE static void raise(Pack& highest, const simd::Mask& alive, const Pack& bound) {
        highest = select(alive & (bound > highest), bound, highest);
    }

    /// Yarns without viscosity keep no stress: it follows from their lengths.
    template <class Real>
    void add_stresses(fabric::State<Real>& state) const {
        if constexpr (!F.viscous) {
            const auto yarns = fabric::yarn_state<F>(constants_, state);
            state.sigma_f = yarns.sigma_f;
            state.sigma_w = yarns.sigma_w;
        }
    }

    [[nodiscard]] std::size_t at(std::int32_t pack) const {
        return static_cast<std::size_t>(pack) * changing_fields * pack_width;
    }

    /// The state of a pack; what is eroded loses area and shape of `quad`.
    [[nodiscard]] WEAVEFRONT_INLINE fabric::State<Pack> load(std::int32_t pack, Quad<Pack>& quad) const {
        fabric::State<Pack> state;
        fabric::load_fields<F, Pack, Fields::changing>(state, state_.data() + at(pack));
        if constexpr (packs_yarns)
            if (const double* packing = packing_.find(pack))
                fabric::load_fields<F, Pack, Fields::packing>(state, packing);
        if constexpr (F.scatter) {
            const double* weakness = weakness_.data() + static_cast<std::size_t>(pack) * 2 * pack_width;
            state.weakness_f = Pack::load(weakness);
            state.weakness_w = Pack::load(weakness + pack_width);
        }
        if constexpr (F.failure)
            if (const double* damage = damage_.find(pack)) {
                const Pack left = Pack::load(damage);
                quad.area = quad.area * left;
                quad.shape = quad.shape * left;
                fabric::load_fields<F, Pack, Fields::damage>(state, damage + pack_width);
            }
        return state;
    }

    /// Stores the state of a pack but for its damage.
    WEAVEFRONT_INLINE void store(std::int32_t pack, const fabric::State<Pack>& state) {
        fabric::store_state<F, Pack, Fields::changing>(state, state_.data() + at(pack));
        if constexpr (packs_yarns) {
            if (simd::any(state.alpha > 0.0))
                fabric::store_state<F, Pack, Fields::packing>(state, packing_.take(pack));
            else
                packing_.give_back(pack);
        }
    }

    template <Fields which>
    static void fill_from(const PackBlocks& blocks, int field, std::int32_t index,
                          fabric::State<double>& state) {
        fabric::for_each_field<F, which>(state, [&](const char*, double& value) {
            value = blocks.get(index / pack_width, field++, index % pack_width);
        });
    }

    void advance_pack(std::int32_t pack, std::int32_t at, std::span<const Eigen::Vector3d> x, double* forces,
                      Events& events) {
        auto quad = quads_.pack_from(at);
        auto state = load(pack, quad);
        [[maybe_unused]] const Pack intact_f = state.intact_f, intact_w = state.intact_w;
        const auto result =
            internal_force<F, Pack>(constants_, step_, hourglass_, quad, corners(pack, x), state);
        for (int a = 0; a < 3; ++a) {
            const auto& f = result.corner[static_cast<std::size_t>(a)];
            f.x.store(forces + (a * 3 + 0) * pack_width);
            f.y.store(forces + (a * 3 + 1) * pack_width);
            f.z.store(forces + (a * 3 + 2) * pack_width);
        }
        if constexpr (F.failure)
            if (simd::any((state.intact_f < intact_f) | (state.intact_w < intact_w))) {
                note_breaks(pack, quad, state, result.hourglass_energy, forces, events);
                return;
            }
        store(pack, state);
        result.hourglass_energy.store(hourglass_energy_.data() + static_cast<std::size_t>(pack) * pack_width);
    }

    /// Counts broken yarns. An element that erodes gives no force from this step on, so the work of the step
    /// is corrected.
    /// @param after state at the end of the step; what is stored is that at its start, and is replaced
    void note_breaks(std::int32_t pack, Quad<Pack> quad, const fabric::State<Pack>& after,
                     const Pack& hourglass, double* forces, Events& events) {
        const auto before = load(pack, quad);
        store(pack, after);
        fabric::store_state<F, Pack, Fields::damage>(after, damage_.take(pack) + pack_width);
        for (int lane = 0; lane < pack_width; ++lane) {
            const auto index = pack * pack_width + lane;
            const auto at = static_cast<std::size_t>(index);
            if (index >= size() || !alive(index)) continue;
            const double last_hourglass = std::exchange(hourglass_energy_[at], hourglass.get(lane));
            const double whole_before = before.intact_f.get(lane) + before.intact_w.get(lane);
            const double whole = after.intact_f.get(lane) + after.intact_w.get(lane);
            if (whole == whole_before) continue;
            events.broken_fill += after.intact_f.get(lane) != before.intact_f.get(lane);
            events.broken_warp += after.intact_w.get(lane) != before.intact_w.get(lane);
            events.broken.push_back(element(index));
            const bool eroded = any_yarn_ ? whole < 2 : whole == 0;
            // The hourglass potential is let go with the first yarn; the nodes felt it for half of the step,
            // which changed it but little.
            events.lost_hourglass.push_back(last_hourglass);
            if (eroded) events.eroded.push_back(erode_lane(index, before, after, forces));
        }
    }

    Events::Erosion erode_lane(std::int32_t index, const fabric::State<Pack>& before,
                               const fabric::State<Pack>& after, double* forces) {
        const int lane = index % pack_width;
        for (std::size_t i = 0; i < forces_per_pack / pack_width; ++i)
            forces[i * pack_width + static_cast<std::size_t>(lane)] = 0;
        const double forward = (after.N_f.get(lane) * (after.lambda_f.get(lane) - before.lambda_f.get(lane)) +
                                after.N_w.get(lane) * (after.lambda_w.get(lane) - before.lambda_w.get(lane)) +
                                after.m.get(lane) * (after.phi.get(lane) - before.phi.get(lane))) /
                               2;
        hourglass_energy_[static_cast<std::size_t>(index)] = 0;
        const double size = area(index);
        auto left = erode(index);
        left.work -= forward * size;
        return left;
    }

    static StateNames names() {
        const auto list = [](const auto& of) { return std::vector<const char*>(of.begin(), of.end()); };
        StateNames names{list(fabric::field_names<F, Fields::changing>()),
                         list(fabric::field_names<F, Fields::packing>()),
                         {}};
        if constexpr (F.failure) {
            names.damage = list(fabric::field_names<F, Fields::damage>());
            names.damage.insert(names.damage.begin() + alive_field, "alive");
        }
        return names;
    }

    /// Lanes beyond the last element are never alive.
    void set_weakness(std::span<const GroupElement> elements) {
        weakness_.assign(static_cast<std::size_t>(packs_) * 2 * pack_width, 1);
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const auto place = i / pack_width * 2 * pack_width + i % pack_width;
            weakness_[place] = 1 / elements[i].strength.fill;
            weakness_[place + pack_width] = 1 / elements[i].strength.warp;
        }
    }

    static bool any_yarn_erodes(const scene::Fabric& fabric) {
        return fabric.failure && fabric.failure->erode == scene::Erode::any_yarn;
    }

    fabric::Step step_;
    bool any_yarn_;
};

}  // namespace weavefront::shell
