#include "weavefront/shell/quad.hpp"

#include <cmath>
#include <stdexcept>

#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::shell {

namespace {

constexpr std::array<double, 4> corner_xi{-1, 1, 1, -1}, corner_eta{-1, -1, 1, 1};

/// Gradient of (xi eta) and the Jacobian at a point of the parent square.
std::pair<Eigen::Vector2d, double> hourglass_gradient(const std::array<Eigen::Vector3d, 4>& corners,
                                                      double xi, double eta) {
    Eigen::Vector2d x_xi = Eigen::Vector2d::Zero(), x_eta = Eigen::Vector2d::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
        x_xi += corner_xi[a] * (1 + eta * corner_eta[a]) / 4 * corners[a].head<2>();
        x_eta += corner_eta[a] * (1 + xi * corner_xi[a]) / 4 * corners[a].head<2>();
    }
    const double jacobian = x_xi.x() * x_eta.y() - x_xi.y() * x_eta.x();
    const Eigen::Vector2d gradient{(eta * x_eta.y() - xi * x_xi.y()) / jacobian,
                                   (xi * x_xi.x() - eta * x_eta.x()) / jacobian};
    return {gradient, jacobian};
}

double integrated_shape(const std::array<Eigen::Vector3d, 4>& corners) {
    const double gauss = 1 / std::sqrt(3.0);
    double sum = 0;
    for (const double xi : {-gauss, gauss})
        for (const double eta : {-gauss, gauss}) {
            const auto [gradient, jacobian] = hourglass_gradient(corners, xi, eta);
            if (jacobian <= 0) throw std::invalid_argument("a quadrilateral is not convex");
            sum += gradient.squaredNorm() * jacobian;
        }
    return sum;
}

}  // namespace

Quad<double> make_quad(const std::array<Eigen::Vector3d, 4>& corners, double angle) {
    const Eigen::Vector3d d13 = corners[0] - corners[2], d24 = corners[1] - corners[3];
    const double area = (d13.x() * d24.y() - d13.y() * d24.x()) / 2;
    const Eigen::Vector2d b1{d24.y() / (2 * area), -d24.x() / (2 * area)},
        b2{-d13.y() / (2 * area), d13.x() / (2 * area)};
    const Eigen::Vector2d fill{scene::cosine(angle), scene::sine(angle)}, warp{-fill.y(), fill.x()};
    const Eigen::Vector2d hX = (corners[0] - corners[1] + corners[2] - corners[3]).head<2>();
    // A parallelogram of a graded mesh shall be one to the bit.
    const auto exact = [](double e) { return std::abs(e) < 1e-12 ? 0.0 : e; };
    return {b1.dot(fill),      b2.dot(fill),      b1.dot(warp), b2.dot(warp),
            exact(b1.dot(hX)), exact(b2.dot(hX)), area,         integrated_shape(corners)};
}

}  // namespace weavefront::shell
