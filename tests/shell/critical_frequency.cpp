/// The bound on the frequency of an element against the largest eigenvalue of its tangent.

#include <gtest/gtest.h>

#include "elements.hpp"
#include "weavefront/shell/tight_bound.hpp"
#include "weavefront/state/record.hpp"

namespace weavefront::test {
namespace {

constexpr std::size_t unknowns = 12;
using Vector = std::array<double, unknowns>;
using Matrix = std::array<Vector, unknowns>;

/// Largest eigenvalue by powers of the matrix; that of a yarn in tension is far above what compression can
/// make negative.
double largest_eigenvalue(const Matrix& K) {
    Vector v{};
    for (std::size_t i = 0; i < unknowns; ++i) v[i] = std::sin(1.0 + static_cast<double>(7 * i));
    double value = 0;
    for (int k = 0; k < 4000; ++k) {
        Vector w{};
        double length = 0, along = 0, before = 0;
        for (std::size_t i = 0; i < unknowns; ++i) {
            for (std::size_t j = 0; j < unknowns; ++j) w[i] += K[i][j] * v[j];
            length += w[i] * w[i], along += w[i] * v[i], before += v[i] * v[i];
        }
        value = along / before;
        for (std::size_t i = 0; i < unknowns; ++i) v[i] = w[i] / std::sqrt(length);
    }
    return value;
}

/// Forces after the path to time 1 and one more step to x.
Positions forces_at(const scene::Fabric& fabric, const Mesh& mesh, double angle, const Wander& wander,
                    const Positions& x) {
    Elements elements(fabric, mesh, angle, 1e-9);
    for (int i = 1; i <= 20; ++i) elements.nodal_forces(wander.at(i / 20.0));
    return elements.nodal_forces(x);
}

struct Frequencies {
    double bound;  ///< omega^2, 1/s2
    double sharp;  ///< the same with crossovers let go, without coupling
    double exact;
};

/// Of one element at the end of a path; the tangent by central differences. Friction and packing make it
/// unsymmetric.
Frequencies frequencies(const scene::Fabric& fabric, const Mesh& mesh, double angle, const Wander& wander) {
    Elements elements(fabric, mesh, angle, 1e-9);
    for (int i = 1; i <= 20; ++i) elements.nodal_forces(wander.at(i / 20.0));
    const auto x = wander.at(1);
    const double h = 1e-6 * element_size;
    Matrix K{};
    for (std::size_t j = 0; j < unknowns; ++j) {
        auto ahead = x, behind = x;
        ahead[j / 3][static_cast<Eigen::Index>(j % 3)] += h;
        behind[j / 3][static_cast<Eigen::Index>(j % 3)] -= h;
        const auto f_ahead = forces_at(fabric, mesh, angle, wander, ahead),
                   f_behind = forces_at(fabric, mesh, angle, wander, behind);
        for (std::size_t i = 0; i < unknowns; ++i)
            K[i][j] = (f_behind[i / 3] - f_ahead[i / 3])[static_cast<Eigen::Index>(i % 3)] / (2 * h);
    }
    const double area = shell::make_quad(corners_of(mesh, 0, mesh.X), angle).area,
                 nodal_mass = fabric.areal_density * area / 4;
    const auto held = elements.group->frequencies();
    if (fabric.formulation == scene::Formulation::paper)
        return {std::max(held.in_plane, held.out_of_plane), 0, largest_eigenvalue(K) / nodal_mass};
    // Only the first, which has no coupling, is tried.
    const shell::TighteningStart start{{held.in_plane * 1e-6},
                                       {4 * held.in_plane},
                                       held.out_of_plane,
                                       held.hourglass,
                                       Eigen::Vector3d::UnitZ()};
    shell::TightBounds tighter = start.least;
    shell::TightBound(*elements.group).raise(start, x, tighter);
    return {std::max(held.in_plane, held.out_of_plane), std::max(tighter[0], held.out_of_plane),
            largest_eigenvalue(K) / nodal_mass};
}

Mesh square() {
    std::mt19937_64 random(0);
    return one_element(0, random);
}

Frequencies at_rest(const scene::Fabric& fabric) {
    std::mt19937_64 random(0);
    return frequencies(fabric, square(), 0, Wander(square(), random, 0, 0, 0));
}

/// Of the difference quotients: h = 1e-6 of an element, so about 1e-6 of the stiffness by curvature and 1e-10
/// by rounding.
constexpr double differences = 1e-5;

/// It is told in steps of at most 2/512.
constexpr double step_of_the_sharp_bound = 4e-3;

TEST(CriticalFrequency, OfAStraightSquareIsClosedForm) {
    scene::Fabric fabric = open_trellis();
    fabric.thickness = 0;
    const auto [bound, sharp, exact] = at_rest(fabric);
    // each yarn by itself: 4 E1 S/s 2 (1/2a)^2 2/areal density
    const double closed =
        4 * membrane_stiffness(fabric) / (element_size * element_size * fabric.areal_density);
    EXPECT_NEAR(exact / closed, 1, differences);
    EXPECT_NEAR(bound / closed, 1, 1e-12);
    EXPECT_NEAR(sharp / closed, 1, step_of_the_sharp_bound);
    EXPECT_GE(sharp, closed);
}

TEST(CriticalFrequency, WastesLittleOfTheTimeStep) {
    for (const double thickness : {0.0, 0.41e-3, 0.82e-3}) {
        scene::Fabric fabric = open_trellis();
        fabric.thickness = thickness;
        const auto [bound, sharp, exact] = at_rest(fabric);
        EXPECT_GE(bound, exact * (1 - differences)) << thickness;
        EXPECT_GT(std::sqrt(exact / bound), 0.85) << thickness;
        EXPECT_GE(sharp, exact * (1 - differences)) << thickness;
        EXPECT_NEAR(sharp / exact, 1, step_of_the_sharp_bound + differences) << thickness;
    }
}

void expect_bound(const scene::Fabric& fabric, double shear) {
    std::mt19937_64 random(9);
    double least = 1e300;
    for (int n = 0; n < 40; ++n) {
        const auto mesh = one_element(n % 4 == 0 ? 0 : 0.2, random);
        const Wander wander(mesh, random, 0.1, shear, n % 2 == 0 ? 0.0 : 0.1);
        const auto [bound, sharp, exact] = frequencies(fabric, mesh, n % 8 == 0 ? 0 : 0.3, wander);
        ASSERT_GE(bound, exact * (1 - differences)) << n;
        if (fabric.formulation == scene::Formulation::consistent) {
            ASSERT_GE(sharp, exact * (1 - differences)) << n;
        }
        least = std::min(least, bound / exact);
    }
    EXPECT_LT(least, 3);  // and is not far from it where it is nearest
}

TEST(CriticalFrequency, BoundsTheOpenTrellis) { expect_bound(open_trellis(), 0.7); }

TEST(CriticalFrequency, BoundsStiffHourglassModes) {
    scene::Fabric fabric = open_trellis();
    fabric.hourglass = 1;
    fabric.transverse_shear *= 20;
    expect_bound(fabric, 0.7);
}

TEST(CriticalFrequency, BoundsViscousPackedAndRubbingYarns) {
    scene::Fabric fabric = kevlar129();
    fabric.failure.reset();
    expect_bound(fabric, 0.3);
    expect_bound(fabric, 1.2);
}

TEST(CriticalFrequency, BoundsStiffPacking) {
    scene::Fabric fabric = elastic_kevlar129();
    fabric.friction = 0;
    fabric.lateral->modulus *= 50;  // well above the yarns themselves
    fabric.lateral->shear_modulus *= 50;
    expect_bound(fabric, 1.2);
}

TEST(CriticalFrequency, BoundsTheFabricAsPrinted) {
    scene::Fabric fabric = kevlar129();
    fabric.formulation = scene::Formulation::paper;
    fabric.failure.reset();
    fabric.friction = 0;  // as printed it jumps with the sense of turning: no tangent
    expect_bound(fabric, 0.3);
}

/// Nine elements fill one pack and part of another; what fills its rest has the same nodes and must not look
/// different for not having been there when they were stretched.
TEST(CriticalFrequency, IsThatOfElementsRestoredElsewhere) {
    scene::Fabric fabric = kevlar129();
    fabric.failure.reset();
    std::mt19937_64 random(5);
    const auto mesh = grid(3, 0, random);
    Elements there(fabric, mesh, 0), here(fabric, mesh, 0);
    const auto stretched = [&](double strain) {
        auto x = mesh.X;
        for (auto& at : x) at.x() *= 1 + strain, at.y() *= 1 + 1.1 * strain;
        return x;
    };
    for (int i = 0; i <= 20; ++i) there.nodal_forces(stretched(0.005 * i));
    for (std::int32_t e = 0; e < there.group->size(); ++e) {
        std::vector<double> record;
        state::RecordWriter writer(record);
        there.group->state(writer, e);
        state::RecordReader reader(record);
        here.group->state(reader, e);
    }
    for (auto* elements : {&there, &here}) elements->nodal_forces(stretched(0.09));
    EXPECT_EQ(there.group->frequencies().in_plane, here.group->frequencies().in_plane);
    EXPECT_EQ(there.group->frequencies().out_of_plane, here.group->frequencies().out_of_plane);
}

}  // namespace
}  // namespace weavefront::test
