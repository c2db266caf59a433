#include "weavefront/contact/contact_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::contact {

namespace {

double largest(double a, double b) { return a > b ? a : b; }

}  // namespace

ContactPoints::ContactPoints(const QuadratureRule& rule, const std::array<Vec3, 4>& corners,
                             const std::array<Vec3, 4>& spanned)
    : batches_(rule.size()), box_(Box::around(spanned)) {
    for (std::size_t k = 0; k < batches_; ++k) points_[k] = interpolate(corners, rule[k].N);
}

// The facet is x = c + xi t1 + eta t2 + xi eta t3. Let n = t1 x t2, E1 = t2 x n, E2 = n x t1 and q = n.n. Its
// points satisfy |n.(x - c)| <= |n.t3| and, with a = E1.(x - c)/q, |a| <= 1 + |E1.t3|/q; likewise b with E2.
// The excess of a point over these bounds is a distance along n and one across it. A closer bound for a
// warped facet follows from
//     F(x) = n.(x - c) - (n.t3) a b
// On the facet |F| is at most U = |n.t3| (|E1.t3|/q + |E2.t3|/q + |E1.t3||E2.t3|/q^2). A point with |F| = U +
// D is at least D over the largest gradient of F away. The square of that gradient is q (1 + s^2), where s^2
// <= 2 (n.t3)^2 (a^2 |t1|^2 + b^2 |t2|^2)/q^2, with |a| and |b| the larger ones of the point and of the
// facet.
double ContactPoints::min_distance(const std::array<Vec3, 4>& corners) const {
    const auto [middle, t1, t2, t3] = BilinearMap(corners);
    const Vec3 n = t1.cross(t2), E1 = t2.cross(n), E2 = n.cross(t1);
    const double q = n.squaredNorm(), square1 = t1.squaredNorm(), square2 = t2.squaredNorm();
    if (!(q > 0)) return min_distance(NodeBox(Box::around(corners)));
    const double inverse = 1 / q, inverse1 = 1 / square1, inverse2 = 1 / square2;
    const double twist = n.dot(t3), warp = std::abs(twist), skew1 = std::abs(E1.dot(t3)) * inverse,
                 skew2 = std::abs(E2.dot(t3)) * inverse;
    const double uneven = warp * (skew1 + skew2 + skew1 * skew2), steep = 2 * warp * warp * inverse * inverse;
    Lanes squares;
    std::fill_n(squares.of, batch_width, std::numeric_limits<double>::max());
    for (std::size_t k = 0; k < batches_; ++k)
        for (std::size_t i = 0; i < batch_width; ++i) {
            const double x = points_[k].x[i] - middle.x(), y = points_[k].y[i] - middle.y(),
                         z = points_[k].z[i] - middle.z();
            const double height = n.x() * x + n.y() * y + n.z() * z;
            const double a = (E1.x() * x + E1.y() * y + E1.z() * z) * inverse,
                         b = (E2.x() * x + E2.y() * y + E2.z() * z) * inverse;
            const double a_most = largest(std::abs(a), 1 + skew1), b_most = largest(std::abs(b), 1 + skew2);
            const double beyond1 = a_most - 1 - skew1, beyond2 = b_most - 1 - skew2;
            const double beside = largest(beyond1 * beyond1 * inverse2, beyond2 * beyond2 * inverse1) * q;
            const double above = largest(std::abs(height) - warp, 0),
                         level = largest(std::abs(height - twist * a * b) - uneven, 0);
            const double gentle = largest(1 - steep * (a_most * a_most * square1 + b_most * b_most * square2),
                                          0);  // <= 1/(1 + s^2)
            const double square = largest(above * above * inverse + beside, level * level * inverse * gentle);
            squares[i] = square < squares[i] ? square : squares[i];
        }
    return std::sqrt(Eigen::Map<const Eigen::Array<double, batch_width, 1>>(squares.of).minCoeff());
}

}  // namespace weavefront::contact
