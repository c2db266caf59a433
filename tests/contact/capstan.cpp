/// A strip that slides over a round bar: the equation of Euler and Eytelwein.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "surfaces.hpp"
#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/rigid_pressure.hpp"

namespace weavefront::test {
namespace {

constexpr double R = 10e-3, width = 1e-3, tail = 8e-3;            // of the bar and of the strip, m
constexpr double k = 1e11, E = 1e4, low = 10;                     // Pa/m, N, N
constexpr double mass_per_length = 4e-3, dt = 1e-7, speed = 0.5;  // kg/m, s, m/s

/// A strip along the x-z plane over a bar along y. One end hangs down with the tension `low`, the other one
/// is pulled along x.
class Strip {
  public:
    Strip(int elements_on_bar, double mu)
        : length_(R * std::numbers::pi / 2 / elements_on_bar),
          tail_(static_cast<int>(std::lround(tail / length_))),
          lines_(static_cast<std::size_t>(elements_on_bar + 2 * tail_ + 1)),
          law_({.stiffness = k, .unloading = 1, .damping = 0.2}, mass_per_length / width),
          friction_({.static_coefficient = mu, .kinetic_coefficient = mu}, k) {
        for (int i = 0; i < static_cast<int>(lines_); ++i)
            for (const double y : {0.0, width}) x_.push_back(at_rest(i, y));
        v_.assign(x_.size(), Vec3::Zero());
        surface_.plies.push_back({.z = 0, .thickness = 0, .areal_density = mass_per_length / width});
        for (std::size_t i = 0; i + 1 < lines_; ++i) {
            const auto n = static_cast<std::int32_t>(2 * i);
            surface_.facets.push_back({static_cast<std::int64_t>(i), {n, n + 2, n + 3, n + 1}, 0});
            surface_.areas.one_ply.push_back(length_ * width);
        }
        surface_.owned = static_cast<std::int32_t>(surface_.facets.size());
        memories_.resize(surface_.facets.size());
        quadrature_.emplace(0.25e-3, surface_, x_);
    }

    /// Pulls for so many steps; returns the mean tension at the pulled end over that at the other one in the
    /// second half of them. It swings about the mean, as the strip hangs on the pulled end as on a spring.
    double pull(int steps) {
        double sum = 0;
        int counted = 0;
        for (int step = 0; step < steps; ++step) {
            const double grown = std::min(1.0, 4.0 * step / steps),
                         pulled = std::clamp(8.0 * step / steps - 2, 0.0, 1.0);
            Positions force(x_.size(), Vec3::Zero());
            add_tension(force);
            add_contact(force);
            for (std::size_t row = 0; row < 2; ++row) force[row].z() -= grown * low / 2;
            for (std::size_t n = 0; n < x_.size(); ++n) {
                v_[n] += dt / (mass_per_length * length_ / 2) * force[n];
                if (n + 2 >= x_.size()) v_[n] = {pulled * speed, 0, 0};
                x_[n] += dt * v_[n];
            }
            if (step >= steps / 2) sum += 2 * tension(x_.size() - 4, x_.size() - 2), ++counted;
        }
        return sum / counted / low;
    }

  private:
    [[nodiscard]] Vec3 at_rest(int line, double y) const {
        const double from_top = (line - tail_) * length_ - R * std::numbers::pi / 2;
        if (line < tail_) return {-R, y, (line - tail_) * length_};
        if (from_top > 0) return {from_top, y, R};
        return {R * std::sin(from_top / R), y, R * std::cos(from_top / R)};
    }
    /// Of one of the two edges, with a damper that rigid motion does not feel.
    [[nodiscard]] double tension(std::size_t from, std::size_t to) const {
        const Vec3 along = x_[to] - x_[from];
        const double damping = std::sqrt(E * mass_per_length) / 2;
        return E / 2 * (along.norm() / length_ - 1) + damping * along.normalized().dot(v_[to] - v_[from]);
    }
    void add_tension(Positions& force) const {
        for (std::size_t n = 0; n + 2 < x_.size(); ++n) {
            const Vec3 pull = tension(n, n + 2) * (x_[n + 2] - x_[n]).normalized();
            force[n] += pull, force[n + 2] -= pull;
        }
    }
    void add_contact(Positions& force) {
        contact::ContactForces forces;
        for (std::size_t f = 0; f < surface_.facets.size(); ++f) {
            const contact::RigidPair pair{.facet = surface_.facets[f],
                                          .area = length_ * width,
                                          .rule = quadrature_->rule(static_cast<std::int32_t>(f)),
                                          .law = law_,
                                          .thickness = 1,
                                          .body = contact::Master::frame,
                                          .away = Vec3::UnitZ(),
                                          .motion = {},
                                          .friction = &friction_};
            const auto depth = [](const Vec3& at, const Point&) -> std::optional<body::Depth> {
                const Vec3 outward(at.x(), 0, at.z());
                if (outward.norm() >= R) return std::nullopt;
                return body::Depth{R - outward.norm(), outward.normalized(), 0};
            };
            contact::press(
                pair, {x_, v_, dt}, 1, memories_[f], depth, [] { return contact::PlyNormals(); }, forces);
        }
        for (const auto* pairs : {&forces.pairs, &forces.friction})
            for (const auto& pair : *pairs)
                for (std::size_t a = 0; a < 4; ++a)
                    force[static_cast<std::size_t>(pair.slave[a])] += pair.on_slave[a];
    }

    struct Point {
        contact::Penetration penetration;
    };
    double length_;  // of an element, m
    int tail_;       // elements of each straight end
    std::size_t lines_;
    contact::PenaltyLaw law_;
    contact::CoulombLaw friction_;
    contact::Surface surface_;
    Positions x_, v_;
    std::vector<contact::RigidMemory<Point>> memories_;
    std::optional<contact::FacetQuadrature> quadrature_;
};

// The tension grows by exp(mu theta) along the angle theta of contact, here a right angle.
TEST(Capstan, GrowsTheTensionByTheExponentOfCoefficientAndAngle) {
    for (const double mu : {0.0, 0.2, 0.4}) {
        const double closed = std::exp(mu * std::numbers::pi / 2);
        // It swings by a tenth about its mean in some eight periods, of which up to a tenth of one is cut
        // off.
        EXPECT_NEAR(Strip(30, mu).pull(8000) / closed, 1, 0.01) << mu;
    }
}

}  // namespace
}  // namespace weavefront::test
