#pragma once
/// @file
/// The element group of one set of features.

#include <cmath>
#include <utility>

#include "weavefront/fabric/cell.hpp"
#include "weavefront/fabric/pack.hpp"
#include "weavefront/fabric/stiffness.hpp"
#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/element_group.hpp"
#include "weavefront/shell/internal_force.hpp"
#include "weavefront/shell/inversion.hpp"
#include "weavefront/shell/membrane_form.hpp"

namespace weavefront::shell {

template <fabric::Features F>
class FeatureGroup final : public ElementGroup {
    using Pack = fabric::Pack;
    using Fields = fabric::Fields;
    static constexpr StateSizes sizes{
        fabric::state_size<F, Fields::changing>(), fabric::state_size<F, Fields::packing>(),
        F.failure ? alive_field + 1 + fabric::state_size<F, Fields::damage>() : 0};

  public:
    FeatureGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements)
        : ElementGroup(fabric, elements, sizes, names()),
          constants_(fabric::constants_of(fabric)),
          coupling_at_rest_(fabric::coupling_at_rest(constants_)),
          any_yarn_(any_yarn_erodes(fabric)) {
        const auto initial = fabric::initial_state<F, Pack>(constants_);
        for (std::int32_t pack = 0; pack < packs_; ++pack) store(pack, initial);
    }

    void set_time_step(double dt) override { step_ = fabric::step_of(constants_, F, dt); }

    void advance(std::int32_t first, std::int32_t count, std::span<const Eigen::Vector3d> x,
                 std::span<double> forces, Events& events) override {
        if (first == 0) has_straightened_ = false;
        for_packs(first, count, [&](std::int32_t pack, std::int32_t at) {
            advance_pack(pack, at, x,
                         forces.data() + static_cast<std::size_t>(pack - first) * forces_per_pack, events);
            if constexpr (F.crimp && !F.paper())
                if (trigger_.slack < std::numeric_limits<double>::infinity()) note_straightening(pack, at);
        });
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

    [[nodiscard]] bool is_crimped() const override { return F.crimp && !F.paper(); }
    [[nodiscard]] bool is_packed() const override { return F.lateral && !F.paper() && packing_.any(); }

    [[nodiscard]] double slack_frequency(const NullLagrangian& term, double smallest_area) const override {
        double highest = 0;
        if constexpr (F.crimp && !F.paper())
            for_packs(0, packs_, [&](std::int32_t pack, std::int32_t at) {
                highest = std::max(
                    highest, largest_lane(slack_form(pack, at, term, smallest_area).largest_eigenvalue()));
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

    [[nodiscard]] IntactYarns intact_yarns(std::int32_t index) const override {
        fabric::State<double> state;
        if constexpr (sizes.damage > 0) fill_from<Fields::damage>(damage_, alive_field + 1, index, state);
        return {state.intact_f != 0, state.intact_w != 0};
    }

    [[nodiscard]] ElementEnergy energy(std::int32_t index) const override {
        const auto state = state_of(index);
        const double size = area(index);
        return {state.work * size, hourglass_energy(index), F.friction ? state.friction_work * size : 0.0};
    }

    [[nodiscard]] ElementCondition condition(std::int32_t index,
                                             std::span<const Eigen::Vector3d> x) const override {
        return {is_inverted(corners_of(index, x)), F.lateral ? state_of(index).alpha : 0.0,
                braid_angle(index, x)};
    }

    [[nodiscard]] ElementOutput output(std::int32_t index,
                                       std::span<const Eigen::Vector3d> x) const override {
        const auto state = state_of(index);
        const auto yarns = fabric::yarn_state<F>(constants_, state);
        return {yarns.eps_f,         yarns.eps_w,           yarns.sigma_f,
                yarns.sigma_w,       braid_angle(index, x), F.crimp ? state.h_f : 0.0,
                state.intact_f == 0, state.intact_w == 0};
    }

  private:
    void tighten_uniform(const TighteningStart& start, std::span<const Eigen::Vector3d> x,
                         TightBounds& bounds) const override {
        if constexpr (F.paper()) {  // the printed stresses derive from no energy and have no such tangent
            bounds.fill(start.limit);
        } else {
            for_packs(0, packs_, [&](std::int32_t pack, std::int32_t at) {
                if (std::ranges::any_of(bounds, [&](double bound) { return bound < start.limit; }))
                    tighten(pack, at, start, gather(pack, x), bounds);
            });
        }
    }

    WEAVEFRONT_INLINE static void raise(Pack& highest, const fabric::Mask& alive, const Pack& bound) {
        highest = select(alive & (bound > highest), bound, highest);
    }

    static double largest_lane(const Pack& values) {
        double largest = values.get(0);
        for (int lane = 1; lane < pack_width; ++lane) largest = std::max(largest, values.get(lane));
        return largest;
    }

    /// Fill and warp stretched together while the yarns are slack and the crossover is free: the form (a, o;
    /// o, b) of omega^2 with a = fill/fill_unit, b = warp/warp_unit, o^2 = coupling_squared/(fill_unit
    /// warp_unit). With k = 4 S Ka/(2 L), per bar of slope beta and crossover height h, a = k B_f.B_f cos^2
    /// beta_f h_w^2/(h_f^2 + h_w^2), so b, and what couples them is k cos beta_f cos beta_w h_f h_w/(h_f^2 +
    /// h_w^2) - 4 c, all over the areal density.
    struct SlackForm {
        fabric::Mask alive;
        Pack fill, fill_unit, warp, warp_unit, coupling_squared;

        [[nodiscard]] WEAVEFRONT_INLINE fabric::Mask above(double omega_squared) const {
            const Pack f = omega_squared * fill_unit - fill, w = omega_squared * warp_unit - warp;
            return alive & !((f > 0.0) & (w > 0.0) & (f * w > coupling_squared));
        }
        [[nodiscard]] Pack largest_eigenvalue() const {
            const Pack a = fill / fill_unit, b = warp / warp_unit, half = 0.5 * (a - b);
            return select(
                alive,
                Pack(0.5 * (a + b) + sqrt(Pack(half * half + coupling_squared / (fill_unit * warp_unit)))),
                Pack(0.0));
        }
    };

    [[nodiscard]] WEAVEFRONT_INLINE SlackForm slack_form(std::int32_t pack, std::int32_t at,
                                                         const NullLagrangian& term,
                                                         double smallest_area) const {
        auto quad = quads_.pack_from(at);
        const auto state = load(pack, quad);
        const auto alive = quad.area > 0.0;
        const auto G = term.mass == 0 ? gradient_products(quad)
                                      : redistributed_products(term.mass, quad, alive, smallest_area);
        const double bar = constants_.instant_modulus * constants_.area * constants_.inverse_length;
        const double c = 2 * term.coupling * coupling_at_rest_ / bar;
        Pack k = 2 * bar / areal_density_;
        if constexpr (F.failure) k = k * (state.intact_f * state.intact_w);
        const Pack a_f = (0.5 * constants_.span) * state.lambda_f,
                   a_w = (0.5 * constants_.span) * state.lambda_w;
        const Pack h_f = state.h_f, h_w = 0.5 * constants_.thickness - h_f;
        const Pack aa_f = a_f * a_f, aa_w = a_w * a_w, hh_f = h_f * h_f, hh_w = h_w * h_w, sum = hh_f + hh_w;
        const Pack LL_f = aa_f + hh_f, LL_w = aa_w + hh_w;
        // the mean of the squares for the product of the lengths, which differ by little
        const Pack coupling = (a_f * a_w) * (h_f * h_w) - (0.5 * c) * (sum * (LL_f + LL_w));
        const Pack k_f = k * G[0], k_w = k * G[2];
        return {alive,      k_f * (aa_f * hh_w),
                sum * LL_f, k_w * (aa_w * hh_f),
                sum * LL_w, (k_f * k_w) * (coupling * coupling)};
    }

    void note_straightening(std::int32_t pack, std::int32_t at) {
        if (has_straightened_) return;
        has_straightened_ =
            fabric::any(slack_form(pack, at, trigger_.term, trigger_.smallest_area).above(trigger_.slack));
    }

    /// A pack on the way to its tighter bounds.
    struct Tightened {
        fabric::Mask alive;
        MembraneForm<Pack> form;
        Pack c;       ///< coupling as seen in the element's plane, N/m
        Pack tilted;  ///< square of what the coupling makes of the element's tilt, between motion in the
                      ///< plane and out of it, 1/s4
        double out_of_plane;

        /// Whether omega_squared is no bound.
        [[nodiscard]] WEAVEFRONT_INLINE fabric::Mask above(double omega_squared) const {
            const Pack rest = omega_squared - out_of_plane;
            const auto is_tilted = tilted > 0.0;
            const Pack in_plane = omega_squared - select(is_tilted, Pack(tilted / rest), Pack(0.0));
            return alive & ((is_tilted & (rest <= 0.0)) | exceeds(form, in_plane, c));
        }

        /// The bound of a lane by its eigenvalue; a little below, so that `above` decides.
        [[nodiscard]] double bound(int lane) const {
            const auto get = [&](const Pack& value) { return value.get(lane); };
            const MembraneForm<double> of_lane{get(form.ff11), get(form.ff12), get(form.ff22), get(form.fw11),
                                               get(form.fw12), get(form.fw21), get(form.fw22), get(form.ww11),
                                               get(form.ww12), get(form.ww22), get(form.area)};
            const double in_plane = largest_eigenvalue(of_lane, get(c)), half = (in_plane - out_of_plane) / 2;
            const double both = get(tilted) > 0
                                    ? (in_plane + out_of_plane) / 2 + std::sqrt(half * half + get(tilted))
                                    : in_plane;
            return in_steps(both * (1 - 1e-12));
        }
    };

    void tighten(std::int32_t pack, std::int32_t at, const TighteningStart& start,
                 const std::array<Vector<Pack>, 4>& x, TightBounds& bounds) const {
        auto quad = quads_.pack_from(at);
        const auto state = load(pack, quad);
        const auto alive = quad.area > 0.0;
        const auto tangent = fabric::tangent_bound<F>(constants_, state);
        const auto k = kinematics_of(quad, x);
        const auto normal = cross(k.g_f, k.g_w);
        const Pack tiny = std::numeric_limits<double>::min(),
                   length = sqrt(fabric::max(dot(normal, normal), tiny));
        const Pack inverse = 1.0 / fabric::max(Pack(state.lambda_f * state.lambda_w), tiny);
        const Pack cosine = dot(k.g_f, k.g_w) * inverse, sine = length * inverse;
        const Pack lean =
            (normal.x * start.axis.x() + normal.y * start.axis.y() + normal.z * start.axis.z()) / length;
        const auto even = membrane_form(tangent, cosine, sine, gradient_products(quad), areal_density_);
        for (std::size_t i = 0; i < null_lagrangians.size(); ++i) {
            if (bounds[i] >= start.limit) continue;
            const double c = null_lagrangians[i].coupling * coupling_at_rest_, m = null_lagrangians[i].mass;
            Tightened tightened{.alive = alive,
                                .form = even,
                                .c = c * lean,
                                .tilted = 0.0,
                                .out_of_plane = start.out_of_plane};
            if (c > 0) {
                const Pack area = c * even.area;
                tightened.tilted = area * area * fabric::max(Pack(1.0 - lean * lean), Pack(0.0));
            }
            if (m != 0)
                tightened.form = membrane_form(tangent, cosine, sine,
                                               redistributed_products(m, quad, alive, start.smallest_area),
                                               areal_density_);
            raise(bounds[i], tightened, start.limit);
        }
    }

    /// Gradient products with redistributed mass. A corner of the panel has no neighbour to give it mass: its
    /// part there stays a quarter, which is allowed for at one corner of every element.
    [[nodiscard]] static std::array<Pack, 3> redistributed_products(double mass, const Quad<Pack>& quad,
                                                                    const fabric::Mask& alive,
                                                                    double smallest_area) {
        const Pack moved = std::abs(mass) * smallest_area / select(alive, quad.area, Pack(smallest_area));
        const Pack richer = 0.5 + 0.5 / (1.0 + moved), poorer = 1.0 / (1.0 - moved);
        return mass > 0 ? gradient_products(quad, richer, poorer) : gradient_products(quad, poorer, richer);
    }

    /// Raises `known` to the first step that bounds the pack: one step after the other, or, where these are
    /// many, by eigenvalues.
    static void raise(double& known, const Tightened& tightened, double limit) {
        constexpr int single_steps = 16;
        int steps = 0;
        for (auto above = tightened.above(known); fabric::any(above); above = tightened.above(known)) {
            double higher = in_steps(known * (1 + 1e-9));
            for (int lane = 0; lane < pack_width && steps >= single_steps; ++lane) {
                const double bound = above.get(lane) ? tightened.bound(lane) : 0.0;
                higher = bound < limit ? std::max(higher, bound) : limit;  // also where it is not a number
            }
            ++steps;
            known = std::min(higher, limit);
            if (known == limit) return;
        }
    }

    /// Calls with each pack and with the place of its geometry.
    template <class Call>
    void for_packs(std::int32_t first, std::int32_t count, Call call) const {
        auto at = first * pack_width % quads_.repeat_length();
        for (auto pack = first; pack < first + count; ++pack) {
            call(pack, at);
            at += pack_width;
            if (at >= quads_.repeat_length()) at %= quads_.repeat_length();
        }
    }

    [[nodiscard]] std::size_t at(std::int32_t pack) const {
        return static_cast<std::size_t>(pack) * sizes.changing * pack_width;
    }

    /// The state of a pack; what is eroded loses area and shape of `quad`.
    [[nodiscard]] WEAVEFRONT_INLINE fabric::State<Pack> load(std::int32_t pack, Quad<Pack>& quad) const {
        fabric::State<Pack> state;
        fabric::load_fields<F, Pack, Fields::changing>(state, state_.data() + at(pack));
        if constexpr (sizes.packing > 0)
            if (const double* packing = packing_.find(pack))
                fabric::load_fields<F, Pack, Fields::packing>(state, packing);
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
    static void fill_from(const PackBlocks& blocks, int field, std::int32_t index,
                          fabric::State<double>& state) {
        fabric::for_each_field<F, which>(state, [&](const char*, double& value) {
            value = blocks.get(index / pack_width, field++, index % pack_width);
        });
    }

    [[nodiscard]] std::array<Vector<double>, 4> corners_of(std::int32_t index,
                                                           std::span<const Eigen::Vector3d> x) const {
        std::array<Vector<double>, 4> corners;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto& at = x[static_cast<std::size_t>(
                nodes(index / pack_width)[a][static_cast<std::size_t>(index % pack_width)])];
            corners[a] = {at.x(), at.y(), at.z()};
        }
        return corners;
    }

    [[nodiscard]] double braid_angle(std::int32_t index, std::span<const Eigen::Vector3d> x) const {
        const auto k = kinematics_of(whole_quad(index), corners_of(index, x));
        const double cos_2theta = dot(k.g_f, k.g_w) / std::sqrt(dot(k.g_f, k.g_f) * dot(k.g_w, k.g_w));
        return std::acos(std::clamp(cos_2theta, -1.0, 1.0)) / 2;
    }

    void advance_pack(std::int32_t pack, std::int32_t at, std::span<const Eigen::Vector3d> x, double* forces,
                      Events& events) {
        auto quad = quads_.pack_from(at);
        auto state = load(pack, quad);
        [[maybe_unused]] const Pack intact_f = state.intact_f, intact_w = state.intact_w;
        const auto result =
            internal_force<F, Pack>(constants_, step_, hourglass_, quad, gather(pack, x), state);
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

    /// Counts broken yarns; elements that erode by it give no force from this very step on, and the work of
    /// the step is corrected so.
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

    static bool any_yarn_erodes(const scene::Fabric& fabric) {
        return fabric.failure && fabric.failure->erode == scene::Erode::any_yarn;
    }

    fabric::Constants constants_;
    fabric::Step step_;
    double coupling_at_rest_;  ///< N/m
    bool any_yarn_;
};

}  // namespace weavefront::shell
