/// Reference geometry: gradients, hourglass vector, inversion.

#include "weavefront/shell/quad.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "elements.hpp"
#include "weavefront/shell/inversion.hpp"

namespace weavefront::test {
namespace {

std::array<shell::Vector<double>, 4> vectors(const Corners& x) {
    const auto v = [&](std::size_t a) { return shell::Vector<double>{x[a].x(), x[a].y(), x[a].z()}; };
    return {v(0), v(1), v(2), v(3)};
}

shell::Kinematics<double> kinematics(const shell::Quad<double>& quad, const Corners& x) {
    return shell::kinematics_of(quad, vectors(x));
}

bool is_inverted(const Corners& x) { return shell::is_inverted(vectors(x)); }

TEST(Quad, SeesLinearFieldsExactlyAndNoHourglassInThem) {
    std::mt19937_64 random(1);
    for (int n = 0; n < 100; ++n) {
        const auto mesh = one_element(0.25, random);
        const double angle = random_vector(random, 3).x();
        const auto quad = shell::make_quad(corners_of(mesh, 0, mesh.X), angle);
        Eigen::Matrix<double, 3, 2> F;
        F.col(0) = random_vector(random, 1);
        F.col(1) = random_vector(random, 1);
        Corners x;
        for (std::size_t a = 0; a < 4; ++a) x[a] = F * mesh.X[a].head<2>() + Eigen::Vector3d(1, 2, 3);
        const auto k = kinematics(quad, x);
        const Eigen::Vector3d fill = F * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
                              warp = F * Eigen::Vector2d(-std::sin(angle), std::cos(angle));
        // positions of the size of 4 m are rounded; gradients are of the size of 1/element_size
        const double rounding = 20 * 4 * 2.3e-16 / element_size;
        EXPECT_LT((Eigen::Vector3d(k.g_f.x, k.g_f.y, k.g_f.z) - fill).norm(), rounding);
        EXPECT_LT((Eigen::Vector3d(k.g_w.x, k.g_w.y, k.g_w.z) - warp).norm(), rounding);
        EXPECT_LT(Eigen::Vector3d(k.q.x, k.q.y, k.q.z).norm(), rounding * element_size);
    }
}

TEST(Quad, OfARectangleIsClosedForm) {
    const double a = 2e-3, b = 0.7e-3;
    const auto quad = shell::make_quad({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(a, 0, 0),
                                        Eigen::Vector3d(a, b, 0), Eigen::Vector3d(0, b, 0)},
                                       0);
    EXPECT_DOUBLE_EQ(quad.area, a * b);
    EXPECT_NEAR(quad.shape, (b / a + a / b) * 4 / 3, 1e-14);
    EXPECT_EQ(quad.e1, 0);
    EXPECT_EQ(quad.e2, 0);
    EXPECT_DOUBLE_EQ(quad.Bf1, -0.5 / a);
    EXPECT_DOUBLE_EQ(quad.Bw2, -0.5 / b);
}

TEST(Quad, MustBeConvex) {
    const auto at = [](double x, double y) { return Eigen::Vector3d(x, y, 0); };
    EXPECT_THROW(shell::make_quad({at(0, 0), at(1, 0), at(0.1, 0.1), at(0, 1)}, 0), std::invalid_argument);
    EXPECT_THROW(shell::make_quad({at(0, 0), at(0, 1), at(1, 1), at(1, 0)}, 0),
                 std::invalid_argument);  // clockwise
}

TEST(Inversion, IsCrossingItselfNotTurningOrDenting) {
    const auto at = [](double x, double y) { return Eigen::Vector3d(x, y, 0); };
    const Corners flat{at(0, 0), at(1, 0), at(1, 1), at(0, 1)},
        dented{at(0, 0), at(1, 0), at(0.4, 0.4), at(0, 1)},
        crossed{at(0, 0), at(1, 0), at(-0.2, 0.9), at(1.1, 1)},
        across{at(0, 0), at(-0.3, 0.6), at(1, 1), at(0, 1)};
    std::mt19937_64 random(2);
    for (int n = 0; n < 20; ++n) {
        const Eigen::Matrix3d R = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
        const auto turned = [&](Corners x) {
            for (auto& corner : x) corner = R * corner;
            return x;
        };
        EXPECT_FALSE(is_inverted(turned(flat)));
        EXPECT_FALSE(is_inverted(turned(dented)));
        EXPECT_TRUE(is_inverted(turned(crossed)));
        EXPECT_TRUE(is_inverted(turned(across)));
    }
    EXPECT_TRUE(is_inverted({at(0, 0), at(1, 0), at(0, 1), at(1, 1)}));  // no mean normal
}

/// Grid lines of graded meshes are sums; what rounding leaves of e would make of a parallelogram something
/// else.
TEST(Quad, ARectangleOfAGradedMeshIsAParallelogram) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> size(1e-4, 1e-3), growth(1, 1.3);
    for (int n = 0; n < 300; ++n) {
        double x = 0, X = size(random), step = X;
        const double factor = growth(random);
        for (int column = 0; column < 20; ++column) {
            const auto quad =
                shell::make_quad({Eigen::Vector3d(x, x, 0), {X, x, 0}, {X, X, 0}, {x, X, 0}}, 0.3);
            ASSERT_EQ(quad.e1, 0) << n;
            ASSERT_EQ(quad.e2, 0) << n;
            step *= factor;
            x = X;
            X += step;
        }
    }
}

}  // namespace
}  // namespace weavefront::test
