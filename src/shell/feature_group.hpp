#pragma once
/// @file
/// The element group of one set of features.

#include <cmath>
#include <utility>

#include "weavefront/fabric/cell.hpp"
#include "weavefront/fabric/pack.hpp"
#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/fabric/vectors.hpp"
#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/shell/internal_force.hpp"
#include "weavefront/shell/inversion.hpp"

namespace weavefront::shell {

template <fabric::Features F>
class FeatureGroup final : public ElementGroup {
    using Pack = fabric::Pack;
    using Fields = fabric::Fields;
    static constexpr StateSizes sizes{fabric::state_size<F, Fields::changing>(), fabric::state_size<F, Fields::packing>(),
                                      F.failure ? alive_field + 1 + fabric::state_size<F, Fields::damage>() : 0};

  public:
    FeatureGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements)
        : ElementGroup(fabric, elements, sizes), constants_(fabric::constants_of(fabric)), any_yarn_(any_yarn_erodes(fabric)) {
        const auto initial = fabric::initial_state<F, Pack>(constants_);
        for (std::int32_t pack = 0; pack < packs_; ++pack) store(pack, initial);
    }

    void set_time_step(double dt) override { step_ = fabric::step_of(constants_, F, dt); }

    void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x, std::span<double> forces,
                 Events& events) override {
        for_packs(first, count, [&](std::int32_t pack, std::int32_t at) {
            advance_pack(pack, at, x, forces.data() + static_cast<std::size_t>(pack - first) * forces_per_pack, events);
        });
    }

    [[nodiscard]] double frequency_squared() const override {
        double highest = 0;
        for_packs(0, packs_, [&](std::int32_t pack, std::int32_t at) {
            auto quad = quads_.pack_from(at);
            const auto state = load(pack, quad);
            const auto alive = quad.area > 0.0;
            const Pack rough =
                critical_frequency_squared(quad, fabric::stiffness_bound<F>(constants_, state), state, hourglass_, areal_density_);
            if (fabric::any(alive & (rough > highest))) raise(highest, pack, alive, rough);
        });
        return highest;
    }

    [[nodiscard]] std::int64_t inverted(std::span<const Eigen::Vector3d> x) const override {
        std::int64_t count = 0;
        for (std::int32_t pack = 0; pack < packs_; ++pack) {
            const auto folded = is_inverted(gather(pack, x));
            if (!fabric::any(folded)) continue;
            for (int lane = 0; lane < pack_width; ++lane) {
                const auto index = pack * pack_width + lane;
                count += index < size() && folded.get(lane) && alive(index) ? 1 : 0;
            }
        }
        return count;
    }

    [[nodiscard]] ElementEnergy energy(std::int32_t index) const override {
        const auto state = state_of(index);
        const double size = area(index);
        return {state.work * size, hourglass_energy(index), F.friction ? state.friction_work * size : 0.0};
    }

    [[nodiscard]] ElementOutput output(std::int32_t index, std::span<const Eigen::Vector3d> x) const override {
        const auto state = state_of(index);
        const auto yarns = fabric::yarn_state<F>(constants_, state);
        const auto k = kinematics_of(whole_quad(index), corners_of(index, x));
        const double cos_2theta = dot(k.g_f, k.g_w) / std::sqrt(dot(k.g_f, k.g_f) * dot(k.g_w, k.g_w));
        return {yarns.eps_f,
                yarns.eps_w,
                yarns.sigma_f,
                yarns.sigma_w,
                std::acos(std::clamp(cos_2theta, -1.0, 1.0)) / 2,
                F.crimp ? state.h_f : 0.0,
                state.intact_f == 0,
                state.intact_w == 0};
    }

  private:
    /// Raises `known` to the bounds on the squared frequencies of a pack, the rough ones or sharper ones where these pay.
    void raise(double& known, std::int32_t pack, const fabric::Mask& alive, const Pack& rough) const {
        for (int lane = 0; lane < pack_width; ++lane) {
            double bound = rough.get(lane);
            if (!alive.get(lane) || !(bound > known)) continue;
            const auto index = pack * pack_width + lane;
            const auto state = state_of(index);
            if (sharper_bound_pays(state))
                bound = std::min(bound, critical_frequency_squared(whole_quad(index), fabric::tangent_bound<F>(constants_, state),
                                                                   hourglass_, areal_density_));
            known = std::max(known, bound);
        }
    }

    /// Only packed yarns couple so strongly that the exact tangent is far below its rough bound. The printed stresses derive from no
    /// energy and have no such tangent.
    [[nodiscard]] static bool sharper_bound_pays(const fabric::State<double>& state) {
        if constexpr (F.lateral && !F.paper()) return state.alpha > 0;
        return false;
    }

    /// Calls with each pack and with the place of its geometry.
    template <class Call>
    void for_packs(std::int32_t first, std::int32_t count, Call call) const {
        auto at = first * pack_width % quads_.period();
        for (auto pack = first; pack < first + count; ++pack) {
            call(pack, at);
            at += pack_width;
            if (at >= quads_.period()) at %= quads_.period();
        }
    }

    [[nodiscard]] std::size_t at(std::int32_t pack) const { return static_cast<std::size_t>(pack) * sizes.changing * pack_width; }

    /// The state of a pack; what is eroded loses area and shape of `quad`.
    [[nodiscard]] WEAVEFRONT_INLINE fabric::State<Pack> load(std::int32_t pack, Quad<Pack>& quad) const {
        fabric::State<Pack> state;
        fabric::load_fields<F, Pack, Fields::changing>(state, state_.data() + at(pack));
        if constexpr (sizes.packing > 0)
            if (const double* packing = packing_.find(pack)) fabric::load_fields<F, Pack, Fields::packing>(state, packing);
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
        if constexpr (sizes.packing > 0) {
            if (fabric::any(state.alpha > 0.0))
                fabric::store_state<F, Pack, Fields::packing>(state, packing_.take(pack));
            else
                packing_.give_back(pack);
        }
    }

    [[nodiscard]] fabric::State<double> state_of(std::int32_t index) const {
        fabric::State<double> state;
        std::array<double, sizes.changing> fields;
        for (int f = 0; f < sizes.changing; ++f) fields[static_cast<std::size_t>(f)] = state_[slot(index, f)];
        fabric::load_fields<F, double, Fields::changing>(state, fields.data());
        if constexpr (sizes.packing > 0) fill_from<Fields::packing>(packing_, 0, index, state);
        if constexpr (sizes.damage > 0) fill_from<Fields::damage>(damage_, alive_field + 1, index, state);
        return state;
    }

    template <Fields which>
    static void fill_from(const PackBlocks& blocks, int field, std::int32_t index, fabric::State<double>& state) {
        fabric::for_each_field<F, which>(state,
                                         [&](double& value) { value = blocks.get(index / pack_width, field++, index % pack_width); });
    }

    [[nodiscard]] std::array<Vector<double>, 4> corners_of(std::int32_t index, std::span<const Eigen::Vector3d> x) const {
        std::array<Vector<double>, 4> corners;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto& at = x[static_cast<std::size_t>(nodes(index / pack_width)[a][static_cast<std::size_t>(index % pack_width)])];
            corners[a] = {at.x(), at.y(), at.z()};
        }
        return corners;
    }

    [[nodiscard]] std::array<Vector<Pack>, 4> gather(std::int32_t pack, std::span<const Eigen::Vector3d> x) const {
        std::array<Vector<Pack>, 4> corners;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto [px, py, pz] = fabric::gather_vectors(x[0].data(), nodes(pack)[a]);
            corners[a] = {px, py, pz};
        }
        return corners;
    }

    void advance_pack(std::int32_t pack, std::int32_t at, std::span<const Eigen::Vector3d> x, double* forces, Events& events) {
        auto quad = quads_.pack_from(at);
        auto state = load(pack, quad);
        [[maybe_unused]] const Pack intact_f = state.intact_f, intact_w = state.intact_w;
        const auto result = internal_force<F, Pack>(constants_, step_, hourglass_, quad, gather(pack, x), state);
        for (int a = 0; a < 3; ++a) {
            const auto& f = result.corner[static_cast<std::size_t>(a)];
            f.x.store(forces + (a * 3 + 0) * pack_width);
            f.y.store(forces + (a * 3 + 1) * pack_width);
            f.z.store(forces + (a * 3 + 2) * pack_width);
        }
        if constexpr (F.failure)
            if (fabric::any((state.intact_f < intact_f) | (state.intact_w < intact_w))) {
                note_breaks(pack, quad, state, result.hourglass_energy, forces, events);
                return;
            }
        store(pack, state);
        result.hourglass_energy.store(hourglass_energy_.data() + static_cast<std::size_t>(pack) * pack_width);
    }

    /// Counts broken yarns; elements that erode by it give no force from this very step on, and the work of the step is corrected so.
    /// @param after state at the end of the step; what is stored is that at its start, and is replaced
    void note_breaks(std::int32_t pack, Quad<Pack> quad, const fabric::State<Pack>& after, const Pack& hourglass, double* forces,
                     Events& events) {
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
            // The hourglass potential is let go with the first yarn; the nodes felt it for half of the step, which changed it but little.
            events.lost_hourglass.push_back(last_hourglass);
            if (eroded) events.eroded.push_back(erode_lane(index, before, after, forces));
        }
    }

    Events::Erosion erode_lane(std::int32_t index, const fabric::State<Pack>& before, const fabric::State<Pack>& after, double* forces) {
        const int lane = index % pack_width;
        for (std::size_t i = 0; i < forces_per_pack / pack_width; ++i) forces[i * pack_width + static_cast<std::size_t>(lane)] = 0;
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

    static bool any_yarn_erodes(const scene::Fabric& fabric) { return fabric.failure && fabric.failure->erode == scene::Erode::any_yarn; }

    fabric::Constants constants_;
    fabric::Step step_;
    bool any_yarn_;
};

}  // namespace weavefront::shell
