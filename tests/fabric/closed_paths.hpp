#pragma once
/// @file
/// Closed paths through stretches and angle, and the work along them.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "material_point.hpp"

namespace weavefront::test {

/// A random smooth closed path that begins and ends at rest.
class SmoothPath {
  public:
    SmoothPath(std::mt19937_64& random, double stretch, double turn) {
        std::uniform_real_distribution<double> one(-1, 1);
        for (auto& amplitude : f_) amplitude = stretch * one(random);
        for (auto& amplitude : w_) amplitude = stretch * one(random);
        for (auto& amplitude : theta_) amplitude = one(random);
        const double sum = std::abs(theta_[0]) + std::abs(theta_[1]) + std::abs(theta_[2]);
        for (auto& amplitude : theta_) amplitude *= turn / sum;  // never turns further than `turn`
        pull_ = stretch;
    }
    /// @param x 0 to 1
    [[nodiscard]] Kinematics at(double x) const {
        const double away = std::pow(std::sin(std::numbers::pi * x), 2);
        const auto wander = [x, away](const std::array<double, 3>& a) {
            const double turn = 2 * std::numbers::pi * x;
            return away * (a[0] + a[1] * std::sin(turn) + a[2] * std::cos(2 * turn));
        };
        return {.lambda_f = 1 + pull_ * away + wander(f_) / 3,
                .lambda_w = 1 + pull_ * away + wander(w_) / 3,
                .theta = 45 * degree + wander(theta_)};
    }

  private:
    std::array<double, 3> f_{}, w_{}, theta_{};
    double pull_ = 0;
};

/// Straight legs between corners, from rest through all of them back to rest.
class Polygon {
  public:
    explicit Polygon(std::vector<Kinematics> corners) : corners_(std::move(corners)) {
        corners_.insert(corners_.begin(), Kinematics{});
        corners_.push_back({});
    }
    /// Four random corners with stretches from `shortest` to `longest`, turned by up to `turn` either way.
    Polygon(std::mt19937_64& random, double shortest, double longest, double turn)
        : Polygon(four(random, shortest, longest, turn)) {}

    [[nodiscard]] int legs() const { return static_cast<int>(corners_.size()) - 1; }
    /// @param x 0 to 1
    [[nodiscard]] Kinematics at(double x) const {
        const double place = x * legs();
        const auto leg = std::min(static_cast<std::size_t>(place), corners_.size() - 2);
        const Kinematics &from = corners_[leg], &to = corners_[leg + 1];
        const double part = place - static_cast<double>(leg);
        return {.lambda_f = std::lerp(from.lambda_f, to.lambda_f, part),
                .lambda_w = std::lerp(from.lambda_w, to.lambda_w, part),
                .theta = std::lerp(from.theta, to.theta, part)};
    }

  private:
    static std::vector<Kinematics> four(std::mt19937_64& random, double shortest, double longest,
                                        double turn) {
        std::uniform_real_distribution<double> stretch(shortest, longest), angle(-turn, turn);
        std::vector<Kinematics> corners(4);
        for (auto& corner : corners) {
            corner.lambda_f = stretch(random);
            corner.lambda_w = stretch(random);
            corner.theta += angle(random);
        }
        return corners;
    }

    std::vector<Kinematics> corners_;
};

struct ClosedWork {
    double left = 0;  ///< work over the closed path, J/m2: below zero the cell gave energy
    double peak = 0;  ///< largest work on the way
    [[nodiscard]] double share() const { return left / peak; }
};

/// Walks a path `cycles` times with elastic yarns (or viscous ones, at 1 ns a step). @param steps of one
/// cycle
template <fabric::Features F, class Path>
ClosedWork walk(const scene::Fabric& fabric, const Path& path, int steps, int cycles = 1) {
    MaterialPoint<F> point(fabric, 1e-9);
    ClosedWork work;
    for (int cycle = 0; cycle < cycles; ++cycle)
        for (int i = 1; i <= steps; ++i) {
            point.advance(path.at(static_cast<double>(i) / steps));
            work.left = point.state.work + point.state.friction_work;
            work.peak = std::max(work.peak, work.left);
        }
    return work;
}

/// Paths that people have in mind: rectangles walked corner by corner.
inline Polygon stretch_shear_release_unshear() {
    return Polygon({{1.04, 1.04, 45 * degree}, {1.04, 1.04, 65 * degree}, {1, 1, 65 * degree}});
}
inline Polygon shear_stretch_unshear_release() {
    return Polygon({{1, 1, 65 * degree}, {1.04, 1.04, 65 * degree}, {1.04, 1.04, 45 * degree}});
}
/// Fill is pulled out by 10 %, warp shortens by 5 %, and back in the same order.
inline Polygon crimp_interchange() {
    return Polygon({{1.10, 1, 45 * degree}, {1.10, 0.95, 45 * degree}, {1, 0.95, 45 * degree}});
}
inline Polygon crimp_interchange_backwards() {
    return Polygon({{1, 0.95, 45 * degree}, {1.10, 0.95, 45 * degree}, {1.10, 1, 45 * degree}});
}
inline Polygon stretch_lock_release_unlock() {
    return Polygon({{1.02, 1.02, 45 * degree}, {1.02, 1.02, 85 * degree}, {1, 1, 85 * degree}});
}

}  // namespace weavefront::test
