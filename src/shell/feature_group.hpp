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
    static constexpr int state_fields = fabric::state_size<F>();

  public:
    FeatureGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements)
        : ElementGroup(fabric, elements, state_fields), constants_(fabric::constants_of(fabric)), any_yarn_(any_yarn_erodes(fabric)) {
        const auto initial = fabric::initial_state<F, Pack>(constants_);
        for (std::int32_t pack = 0; pack < packs_; ++pack) fabric::store_state<F, Pack>(initial, state_at(pack));
    }

    void set_time_step(double dt) override { step_ = fabric::step_of(constants_, F, dt); }

    void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x, std::span<double> forces,
                 Events& events) override {
        for (std::int32_t p = 0; p < count; ++p)
            advance_pack(first + p, x, forces.data() + static_cast<std::size_t>(p) * forces_per_pack, events);
    }

    [[nodiscard]] Condition condition(std::span<const Eigen::Vector3d> x) const override {
        Condition condition;
        for (std::int32_t pack = 0; pack < packs_; ++pack) {
            const auto quad = load_quad(pack);
            const auto state = fabric::load_state<F, Pack>(state_at(pack));
            const auto alive = quad.area > 0.0;
            const Pack rough =
                critical_frequency_squared(quad, fabric::stiffness_bound<F>(constants_, state), state, hourglass_, areal_density_);
            if (fabric::any(alive & (rough > condition.omega_squared))) raise(condition.omega_squared, pack, alive, rough);
            const auto inverted = alive & is_inverted(gather(pack, x));
            if (fabric::any(inverted))
                for (int lane = 0; lane < pack_width; ++lane)
                    if (inverted.get(lane)) condition.inverted.push_back(pack * pack_width + lane);
        }
        return condition;
    }

    [[nodiscard]] ElementEnergy energy(std::int32_t index) const override {
        const auto state = state_of(index);
        const double area = quad(index, 6);
        return {state.work * area, hourglass_energy(index), F.friction ? state.friction_work * area : 0.0};
    }

    [[nodiscard]] ElementOutput output(std::int32_t index, std::span<const Eigen::Vector3d> x) const override {
        const auto state = state_of(index);
        const auto yarns = fabric::yarn_state<F>(constants_, state);
        const auto k = kinematics_of(quad_of(index), corners_of(index, x));
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
                bound = std::min(bound, critical_frequency_squared(quad_of(index), fabric::tangent_bound<F>(constants_, state), hourglass_,
                                                                   areal_density_));
            known = std::max(known, bound);
        }
    }

    /// Only packed yarns couple so strongly that the exact tangent is far below its rough bound. The printed stresses derive from no
    /// energy and have no such tangent.
    [[nodiscard]] static bool sharper_bound_pays(const fabric::State<double>& state) {
        if constexpr (F.lateral && !F.paper()) return state.alpha > 0;
        return false;
    }

    double* state_at(std::int32_t pack) { return state_.data() + static_cast<std::size_t>(pack) * state_fields * pack_width; }
    [[nodiscard]] const double* state_at(std::int32_t pack) const {
        return state_.data() + static_cast<std::size_t>(pack) * state_fields * pack_width;
    }

    [[nodiscard]] fabric::State<double> state_of(std::int32_t index) const {
        std::array<double, state_fields> fields;
        for (int f = 0; f < state_fields; ++f) fields[static_cast<std::size_t>(f)] = state_[slot(index, f, state_fields)];
        return fabric::load_state<F, double>(fields.data());
    }

    [[nodiscard]] Quad<double> quad_of(std::int32_t index) const {
        return {quad(index, 0), quad(index, 1), quad(index, 2), quad(index, 3),
                quad(index, 4), quad(index, 5), quad(index, 6), quad(index, 7)};
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

    [[nodiscard]] Quad<Pack> load_quad(std::int32_t pack) const {
        const double* at = quads_.data() + static_cast<std::size_t>(pack) * quad_size * pack_width;
        const auto field = [at](int i) { return Pack::load(at + i * pack_width); };
        return {field(0), field(1), field(2), field(3), field(4), field(5), field(6), field(7)};
    }

    void advance_pack(std::int32_t pack, std::span<const Eigen::Vector3d> x, double* forces, Events& events) {
        auto state = fabric::load_state<F, Pack>(state_at(pack));
        [[maybe_unused]] const Pack intact_f = state.intact_f, intact_w = state.intact_w;
        const auto result = internal_force<F, Pack>(constants_, step_, hourglass_, load_quad(pack), gather(pack, x), state);
        for (int a = 0; a < 3; ++a) {
            const auto& f = result.corner[static_cast<std::size_t>(a)];
            f.x.store(forces + (a * 3 + 0) * pack_width);
            f.y.store(forces + (a * 3 + 1) * pack_width);
            f.z.store(forces + (a * 3 + 2) * pack_width);
        }
        if constexpr (F.failure)
            if (fabric::any((state.intact_f < intact_f) | (state.intact_w < intact_w))) {
                note_breaks(pack, state, result.hourglass_energy, forces, events);
                return;
            }
        fabric::store_state<F, Pack>(state, state_at(pack));
        result.hourglass_energy.store(hourglass_energy_.data() + static_cast<std::size_t>(pack) * pack_width);
    }

    /// Counts broken yarns; elements that erode by it give no force from this very step on, and the work of the step is corrected so.
    /// @param after state at the end of the step; what is stored is that at its start, and is replaced
    void note_breaks(std::int32_t pack, const fabric::State<Pack>& after, const Pack& hourglass, double* forces, Events& events) {
        const auto before = fabric::load_state<F, Pack>(state_at(pack));
        fabric::store_state<F, Pack>(after, state_at(pack));
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
            events.broken.push_back(elements_[at]);
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
        const double area = quad(index, 6);
        auto left = erode(index);
        left.work -= forward * area;
        return left;
    }

    static bool any_yarn_erodes(const scene::Fabric& fabric) { return fabric.failure && fabric.failure->erode == scene::Erode::any_yarn; }

    fabric::Constants constants_;
    fabric::Step step_;
    bool any_yarn_;
};

}  // namespace weavefront::shell
