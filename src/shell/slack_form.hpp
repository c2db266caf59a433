#pragma once
/// @file
/// Stiffness of slack yarns by their stretches and their crossover alone: cheap enough for every step.

#include "weavefront/shell/critical_frequency.hpp"
#include "weavefront/shell/element_group.hpp"

namespace weavefront::shell {

/// Fill and warp stretched together while the yarns are slack and the crossover is free.
///
/// omega^2 is the larger eigenvalue of (p, o; o, q). Let beta be the slope of a bar, h its crossover height
/// and k = 4 S Ka/(2 L) B_f.B_f over the areal density.
///
/// p = k cos^2 beta_f h_w^2/(h_f^2 + h_w^2), and q alike with fill and warp exchanged.
///
/// o = k cos beta_f cos beta_w h_f h_w/(h_f^2 + h_w^2) - 4 c sqrt(det G)/rho, with a coupling c.
///
/// The form is stored without divisions: p = fill/fill_unit, q = warp/warp_unit and
/// o^2 = coupling_squared/(fill_unit warp_unit).
struct SlackForm {
    using Pack = simd::Pack;

    simd::Mask alive;
    Pack fill, fill_unit, warp, warp_unit, coupling_squared;

    /// Whether an alive element is above a bound, 1/s2.
    [[nodiscard]] WEAVEFRONT_INLINE simd::Mask above(double omega_squared) const {
        const Pack f = omega_squared * fill_unit - fill, w = omega_squared * warp_unit - warp;
        return alive & !((f > 0.0) & (w > 0.0) & (f * w > coupling_squared));
    }

    /// omega^2, 1/s2; 0 of eroded elements.
    [[nodiscard]] Pack largest_eigenvalue() const {
        const Pack p = fill / fill_unit, q = warp / warp_unit, half = 0.5 * (p - q);
        return select(
            alive, Pack(0.5 * (p + q) + sqrt(Pack(half * half + coupling_squared / (fill_unit * warp_unit)))),
            Pack(0.0));
    }
};

/// The slack forms of a group of crimped yarns.
class SlackYarns {
    using Pack = simd::Pack;

  public:
    /// @param coupling one of `couplings`
    SlackYarns(const ElementGroup& group, double coupling)
        : group_(group),
          lambda_f_(group.place_of("lambda_f")),
          lambda_w_(group.place_of("lambda_w")),
          h_f_(group.place_of("h_f")) {
        const auto& constants = group.constants();
        const double bar =
            constants.fill.instant_modulus * constants.fill.area * constants.fill.inverse_length;
        stiffness_ = 2 * bar / group.areal_density();
        half_coupling_ = 0.5 * (2 * coupling * fabric::coupling_at_rest(constants) / bar);
        half_span_ = 0.5 * constants.fill.span;
        half_thickness_ = 0.5 * constants.thickness;
    }

    /// Whether the yarns of a group are crimped; the others are straight from the start.
    [[nodiscard]] static bool any_in(const ElementGroup& group) { return group.place_of("h_f") >= 0; }

    /// @param at place of the pack's geometry
    [[nodiscard]] WEAVEFRONT_INLINE SlackForm form(std::int32_t pack, std::int32_t at) const {
        const auto quad = group_.quads().pack_from(at);
        Pack k = stiffness_, area = quad.area;
        if (const double* damage = group_.damage(pack)) {
            area = area * Pack::load(damage);
            k = k * (Pack::load(damage + pack_width) * Pack::load(damage + 2 * pack_width));
        }
        const double* fields = group_.changing_fields(pack);
        const auto field = [&](int place) __attribute__((always_inline)) {
            return Pack::load(fields + place * pack_width);
        };
        const Pack a_f = half_span_ * field(lambda_f_), a_w = half_span_ * field(lambda_w_);
        const Pack h_f = field(h_f_), h_w = half_thickness_ - h_f;
        const Pack aa_f = a_f * a_f, aa_w = a_w * a_w, hh_f = h_f * h_f, hh_w = h_w * h_w, sum = hh_f + hh_w;
        const Pack LL_f = aa_f + hh_f, LL_w = aa_w + hh_w;
        // the mean of the squares for the product of the lengths, which differ by little
        const Pack coupling = (a_f * a_w) * (h_f * h_w) - half_coupling_ * (sum * (LL_f + LL_w));
        const auto G = gradient_products(quad);
        const Pack k_f = k * G[0], k_w = k * G[2];
        return {area > 0.0,          k_f * (aa_f * hh_w), sum * LL_f,
                k_w * (aa_w * hh_f), sum * LL_w,          (k_f * k_w) * (coupling * coupling)};
    }

  private:
    const ElementGroup& group_;
    int lambda_f_, lambda_w_, h_f_;      ///< places of the fields
    double stiffness_;                   ///< 4 S Ka/(2 L) over the areal density, m2/s2
    double half_coupling_;               ///< over S Ka/L
    double half_span_, half_thickness_;  ///< m
};

}  // namespace weavefront::shell
