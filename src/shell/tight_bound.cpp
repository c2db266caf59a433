#include "weavefront/shell/tight_bound.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "largest_lane.hpp"
#include "slack_form.hpp"
#include "weavefront/shell/membrane_form.hpp"

namespace weavefront::shell {

namespace {

using simd::Pack;

// One code for all fabrics: what a fabric does not ask for is at rest in its state, and adds nothing.
constexpr fabric::Features any_fabric{.formulation = scene::Formulation::consistent,
                                      .crimp = true,
                                      .viscous = true,
                                      .lateral = true,
                                      .friction = true,
                                      .failure = true};

/// A pack on the way to its tight bound for one coupling.
struct CoupledPack {
    simd::Mask alive;
    MembraneForm<Pack> form;
    Pack c;                       ///< part of the coupling in the element's plane, N/m
    Pack mixed_coupling_squared;  ///< square of the rest, which couples motion in the plane and out of it,
                                  ///< 1/s4; 0: not inclined
    double out_of_plane;          ///< 1/s2

    /// Whether omega_squared is no bound. Motion out of the plane is eliminated: it takes its part
    /// `mixed_coupling_squared`/rest from omega_squared.
    [[nodiscard]] WEAVEFRONT_INLINE simd::Mask above(double omega_squared) const {
        const Pack rest = omega_squared - out_of_plane;
        const auto is_inclined = mixed_coupling_squared > 0.0;
        const Pack in_plane =
            omega_squared - select(is_inclined, Pack(mixed_coupling_squared / rest), Pack(0.0));
        return alive & ((is_inclined & (rest <= 0.0)) | exceeds(form, in_plane, c));
    }

    /// The bound of a lane by its eigenvalue; a little below, so that `above` decides.
    [[nodiscard]] double bound(int lane) const {
        const auto get = [&](const Pack& value) { return value.get(lane); };
        const MembraneForm<double> of_lane{get(form.ff11), get(form.ff12), get(form.ff22), get(form.fw11),
                                           get(form.fw12), get(form.fw21), get(form.fw22), get(form.ww11),
                                           get(form.ww12), get(form.ww22), get(form.area)};
        const double in_plane = largest_eigenvalue(of_lane, get(c)), half = (in_plane - out_of_plane) / 2;
        const double both =
            get(mixed_coupling_squared) > 0
                ? (in_plane + out_of_plane) / 2 + std::sqrt(half * half + get(mixed_coupling_squared))
                : in_plane;
        return rounded_up(both * (1 - 1e-12));
    }
};

/// Raises `known` to the first step that bounds the pack: one step after the other, or, where the steps are
/// many, by eigenvalues.
void raise_to(double& known, const CoupledPack& pack, double limit) {
    constexpr int single_steps = 16;
    int steps = 0;
    for (auto above = pack.above(known); simd::any(above); above = pack.above(known)) {
        double higher = rounded_up(known * (1 + 1e-9));
        for (int lane = 0; lane < pack_width && steps >= single_steps; ++lane) {
            const double bound = above.get(lane) ? pack.bound(lane) : 0.0;
            higher = bound < limit ? std::max(higher, bound) : limit;  // also where it is not a number
        }
        ++steps;
        known = std::min(higher, limit);
        if (known == limit) return;
    }
}

/// Detects slack yarns that straighten, and the first packed yarns. It stays with its group, so that no step
/// takes memory.
class StiffeningMonitor final : public ElementGroup::Monitor {
  public:
    explicit StiffeningMonitor(const ElementGroup& group) : group_(group) {}

    /// @param trigger to look for from now on; none: nothing
    void set(const std::optional<StiffeningTrigger>& trigger) {
        trigger_ = trigger;
        yarns_.reset();
        has_straightened_ = false;
        // Yarns that are straight from the start do not straighten.
        if (trigger && SlackYarns::any_in(group_)) yarns_.emplace(group_, trigger->coupling_factor);
    }

    void check(std::int32_t first, std::int32_t count) override {
        if (first == 0) has_straightened_ = false;
        if (!yarns_) return;
        group_.for_packs(first, count, [&](std::int32_t pack, std::int32_t at) {
            if (!has_straightened_)
                has_straightened_ = simd::any(yarns_->form(pack, at).above(trigger_->slack_frequency));
        });
    }

    [[nodiscard]] bool has_stiffened() const override {
        return has_straightened_ || (trigger_ && trigger_->awaits_first_packing && group_.any_packed());
    }

  private:
    const ElementGroup& group_;
    std::optional<StiffeningTrigger> trigger_;
    std::optional<SlackYarns> yarns_;
    bool has_straightened_ = false;
};

}  // namespace

TightBound::TightBound(const ElementGroup& group)
    : group_(group), coupling_at_rest_(fabric::coupling_at_rest(group.constants())) {}

void TightBound::raise(const TighteningStart& start, std::span<const Eigen::Vector3d> x,
                       TightBounds& bounds) const {
    TightBounds uniform = start.least;  // without hourglass modes
    group_.for_packs(0, group_.packs(), [&](std::int32_t pack, std::int32_t at) {
        if (!std::ranges::equal(uniform, start.limits, std::greater_equal()))
            raise(pack, at, start, group_.corners(pack, x), uniform);
    });
    for (std::size_t i = 0; i < couplings.size(); ++i)
        bounds[i] = std::max(bounds[i], with_hourglass(group_.parallelograms(), uniform[i], start.hourglass));
}

void TightBound::raise(std::int32_t pack, std::int32_t at, const TighteningStart& start,
                       const std::array<Vector<Pack>, 4>& x, TightBounds& bounds) const {
    const auto quad = group_.quads().pack_from(at);
    const auto* damage = group_.damage(pack);
    const auto alive = damage ? Pack(quad.area * Pack::load(damage)) > 0.0 : quad.area > 0.0;
    const auto state = group_.pack_state(pack);
    const auto tangent = fabric::tangent_bound<any_fabric>(group_.constants(), state);
    const auto k = kinematics_of(quad, x);
    const auto normal = cross(k.g_f, k.g_w);
    const Pack tiny = std::numeric_limits<double>::min(), length = sqrt(simd::max(dot(normal, normal), tiny));
    const Pack inverse = 1.0 / simd::max(Pack(state.lambda_f * state.lambda_w), tiny);
    const Pack cosine = dot(k.g_f, k.g_w) * inverse, sine = length * inverse;
    const Pack cosine_to_axis =
        (normal.x * start.axis.x() + normal.y * start.axis.y() + normal.z * start.axis.z()) / length;
    const auto form = membrane_form(tangent, cosine, sine, gradient_products(quad), group_.areal_density());
    for (std::size_t i = 0; i < couplings.size(); ++i) {
        if (bounds[i] >= start.limits[i]) continue;
        const double c = couplings[i] * coupling_at_rest_;
        CoupledPack coupled{.alive = alive,
                            .form = form,
                            .c = c * cosine_to_axis,
                            .mixed_coupling_squared = 0.0,
                            .out_of_plane = start.out_of_plane};
        if (c > 0) {
            const Pack coupling = c * form.area;  // 1/s2
            coupled.mixed_coupling_squared =
                coupling * coupling * simd::max(Pack(1.0 - cosine_to_axis * cosine_to_axis), Pack(0.0));
        }
        raise_to(bounds[i], coupled, start.limits[i]);
    }
}

double TightBound::slack_frequency(double coupling_factor) const {
    double highest = 0;
    if (!SlackYarns::any_in(group_)) return highest;
    const SlackYarns yarns(group_, coupling_factor);
    group_.for_packs(0, group_.packs(), [&](std::int32_t pack, std::int32_t at) {
        highest = std::max(highest, largest_lane(yarns.form(pack, at).largest_eigenvalue()));
    });
    return highest;
}

void monitor_stiffening(ElementGroup& group, const std::optional<StiffeningTrigger>& trigger) {
    if (!group.monitor()) group.set_monitor(std::make_unique<StiffeningMonitor>(group));
    dynamic_cast<StiffeningMonitor&>(*group.monitor()).set(trigger);
}

}  // namespace weavefront::shell
