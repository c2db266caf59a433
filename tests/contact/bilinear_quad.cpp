/// The bilinear quad.

#include "weavefront/contact/bilinear_quad.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

const std::array<double, 4> corner_xi{-1, 1, 1, -1}, corner_eta{-1, -1, 1, 1};

TEST(BilinearQuad, EachShapeFunctionIsOneAtItsCornerAndZeroAtTheOthers) {
    contact::ShapeFunctions N{};
    for (std::size_t b = 0; b < 4; ++b) {
        contact::set_shape_functions(N, b, corner_xi[b], corner_eta[b]);
        for (std::size_t a = 0; a < 4; ++a) EXPECT_EQ(N[a][b], a == b ? 1 : 0) << a << ' ' << b;
    }
}

TEST(BilinearQuad, PolynomialFormIsTheInterpolation) {
    std::mt19937_64 random(13);
    for (int pass = 0; pass < 50; ++pass) {
        std::array<Vec3, 4> corners;
        for (auto& corner : corners)
            corner = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
        contact::Lanes xi, eta;
        for (std::size_t i = 0; i < contact::batch_width; ++i)
            xi[i] = uniform(random, -1, 1), eta[i] = uniform(random, -1, 1);
        const auto N = contact::shape_functions(xi, eta);
        const auto points = contact::interpolate(corners, N);
        const auto [c, t1, t2, t3] = contact::BilinearMap(corners);
        for (std::size_t i = 0; i < contact::batch_width; ++i) {
            const Vec3 point(points.x[i], points.y[i], points.z[i]);
            EXPECT_EQ(point, contact::at_point(corners, N, i)) << "the same bits";
            // a few roundings of numbers up to 1
            EXPECT_LT((c + xi[i] * t1 + eta[i] * t2 + xi[i] * eta[i] * t3 - point).norm(), 1e-15);
        }
    }
}

}  // namespace
}  // namespace weavefront::test
