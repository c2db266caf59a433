#pragma once
/// @file
/// The state of a material point (or of eight) and how it is stored.

#include <array>
#include <cstddef>

#include "weavefront/fabric/constants.hpp"
#include "weavefront/simd/real.hpp"

namespace weavefront::fabric {

using namespace simd;

/// State of the cell at the end of a step. A kernel touches only the fields that its features need.
template <class Real>
struct State {
    Real lambda_f = 1.0, lambda_w = 1.0;  ///< stretches of the yarn spans
    Real cos_2theta = 0.0;                ///< cosine of the angle between the yarns
    Real phi = 0.0;                       ///< braid angle theta - 45 deg, rad
    Real h_f = 0.0;                       ///< crossover height of the fill, m; h_w = t/2 - h_f
    Real sigma_f = 0.0, sigma_w = 0.0;    ///< axial yarn stresses, Pa
    Real intact_f = 1.0, intact_w = 1.0;  ///< 1, or 0 once the yarn is broken
    Real weakness_f = 1.0,
         weakness_w = 1.0;  ///< failure strains of the fabric over those of the point; constant

    Real alpha = 0.0;                         ///< lateral contact factor
    Real p_f = 0.0, p_w = 0.0;                ///< packing forces across fill and warp (consistent), N/m
    Real q = 0.0;                             ///< packing moment on the angle 2 theta (consistent), N/m
    Real sigma_22_f = 0.0, sigma_12_f = 0.0;  ///< lateral and shear stress in the fill's axes (paper), Pa
    Real sigma_22_w = 0.0, sigma_12_w = 0.0;  ///< in the warp's axes (paper), Pa

    Real friction_moment = 0.0;   ///< M*, elastically stuck or slipping (consistent), N m
    Real friction_limit = 0.0;    ///< M of the last step (consistent), N m
    Real friction_stretch = 0.0;  ///< force of the friction stresses on ln lambda of each yarn (paper), N/m
    Real friction_turn = 0.0;     ///< force of the friction stresses on theta (paper), N/m

    Real N_f = 0.0, N_w = 0.0;  ///< forces conjugate to lambda, without friction, N/m
    Real m = 0.0;               ///< force conjugate to theta, without friction, N/m
    Real work = 0.0;            ///< stress work per reference area, without friction, J/m2
    Real friction_work = 0.0;   ///< work of friction per reference area, J/m2
};

/// Fields that are stored together.
enum class Fields {
    all,
    changing,  ///< in every state that is not at rest
    packing,   ///< nothing but zeros as long as no yarns pack (consistent)
    damage     ///< nothing but ones as long as no yarn is broken
};

/// Calls `visit` with the name and the value of each field of `state` that F needs, in the order in which
/// they are stored.
template <Features F, Fields which = Fields::all, class AnyState, class Visit>
WEAVEFRONT_INLINE constexpr void for_each_field(AnyState& state, Visit visit) {
    constexpr bool all = which == Fields::all;
    if constexpr (all || which == Fields::changing) {
        visit("lambda_f", state.lambda_f), visit("lambda_w", state.lambda_w);
        visit("N_f", state.N_f), visit("N_w", state.N_w), visit("work", state.work);
        if constexpr (F.follows_angle()) visit("cos_2theta", state.cos_2theta), visit("phi", state.phi);
        if constexpr (F.crimp) visit("h_f", state.h_f);
        if constexpr (F.viscous) visit("sigma_f", state.sigma_f), visit("sigma_w", state.sigma_w);
        if constexpr (F.paper()) visit("m", state.m);
        if constexpr (F.paper() && F.lateral) {
            visit("alpha", state.alpha);
            visit("sigma_22_f", state.sigma_22_f), visit("sigma_12_f", state.sigma_12_f);
            visit("sigma_22_w", state.sigma_22_w), visit("sigma_12_w", state.sigma_12_w);
        }
        if constexpr (F.friction) visit("friction_work", state.friction_work);
        if constexpr (F.friction && !F.paper()) {
            visit("friction_moment", state.friction_moment), visit("friction_limit", state.friction_limit);
        }
        if constexpr (F.friction && F.paper()) {
            visit("friction_stretch", state.friction_stretch), visit("friction_turn", state.friction_turn);
        }
    }
    if constexpr ((all || which == Fields::packing) && F.lateral && !F.paper()) {
        visit("alpha", state.alpha), visit("p_f", state.p_f), visit("p_w", state.p_w);
        visit("q", state.q), visit("m", state.m);
    }
    if constexpr ((all || which == Fields::damage) && F.failure)
        visit("intact_f", state.intact_f), visit("intact_w", state.intact_w);
}

/// Number of Reals that the stored fields of F take.
template <Features F, Fields which = Fields::all>
[[nodiscard]] constexpr int state_size() {
    int size = 0;
    State<double> state;
    for_each_field<F, which>(state, [&size](const char*, double&) { ++size; });
    return size;
}

/// Names of these fields, in the order in which they are stored.
template <Features F, Fields which = Fields::all>
[[nodiscard]] std::array<const char*, static_cast<std::size_t>(state_size<F, which>())> field_names() {
    std::array<const char*, static_cast<std::size_t>(state_size<F, which>())> names{};
    State<double> state;
    std::size_t next = 0;
    for_each_field<F, which>(state, [&](const char* name, double&) { names[next++] = name; });
    return names;
}

/// Reads fields into a state.
/// @param from state_size<F, which>() fields of width<Real> lanes: field i of lane l at [i width + l];
/// 64-byte aligned for a pack
template <Features F, class Real, Fields which = Fields::all>
WEAVEFRONT_INLINE void load_fields(State<Real>& state, const double* from) {
    for_each_field<F, which>(
        state, [&from](const char*, Real& field) __attribute__((always_inline)) {
            field = RealTraits<Real>::load(from);
            from += width<Real>;
        });
}

/// The state with all its fields, as load_fields reads them.
template <Features F, class Real>
[[nodiscard]] WEAVEFRONT_INLINE State<Real> load_state(const double* from) {
    State<Real> state;
    load_fields<F, Real>(state, from);
    return state;
}

/// Writes fields of a state, laid out as load_fields reads them.
template <Features F, class Real, Fields which = Fields::all>
WEAVEFRONT_INLINE void store_state(const State<Real>& state, double* to) {
    for_each_field<F, which>(
        state, [&to](const char*, const Real& field) __attribute__((always_inline)) {
            RealTraits<Real>::store(field, to);
            to += width<Real>;
        });
}

}  // namespace weavefront::fabric
