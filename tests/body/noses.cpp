/// Bodies of revolution against closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "scenes.hpp"

namespace weavefront::test {
namespace {

using body::make_shape;

const Vec3 along_axis(0, 0, 1), across_axis(0, 1, 0);

/// The shadow is summed over 2000 stripes of the outline of 720 x 90 points: its chords are pi^2/6 / 360^2
/// inside of circles, and a stripe is as exact.
constexpr double of_shadow = 3e-5;

struct Solid {
    double volume, centroid;  // from the nose, along -z
};

/// A nose and the cylinder behind it.
Solid with_shank(const Solid& nose, double nose_length) {
    const double shank = pi * R * R * (L - nose_length);
    return {nose.volume + shank,
            (nose.volume * nose.centroid + shank * (L + nose_length) / 2) / (nose.volume + shank)};
}

void expect_mass(const scene::Projectile& projectile, const Solid& solid) {
    const auto found = make_shape(projectile)->mass_properties();
    EXPECT_NEAR(found.volume / solid.volume, 1, 1e-12);
    EXPECT_NEAR(-found.centroid.z() / solid.centroid, 1, 1e-12);
    EXPECT_EQ(found.centroid.x(), 0);
}

/// Shadows along and across the axis, and bounds.
void expect_outline(const scene::Projectile& projectile, double across) {
    const auto shape = make_shape(projectile);
    EXPECT_NEAR(shape->presented_area(along_axis) / (pi * R * R), 1, 1e-15);
    EXPECT_NEAR(shape->presented_area(across_axis) / across, 1, of_shadow);
    EXPECT_NEAR(shape->radius(), R, 1e-12 * R);
    EXPECT_NEAR(shape->bounds().low.z(), -L, 1e-12 * L);
    EXPECT_NEAR(shape->bounds().high.z(), 0, 1e-12 * L);
}

/// Depth and normal of a point that comes in along the normal.
void expect_depth(const scene::Projectile& projectile, const Vec3& surface, const Vec3& normal) {
    const auto shape = make_shape(projectile);
    for (const double depth : {0.01e-3, 0.3e-3}) {
        body::Face face = 0;
        EXPECT_FALSE(shape->depth(surface + 2 * offset * normal, offset, face));
        const auto found = shape->depth(surface + (offset - depth) * normal, offset, face);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->depth, depth, 1e-15);
        EXPECT_NEAR((found->normal - normal).norm(), 0, 1e-12);
    }
}

TEST(Hemisphere, HasTheMeasuresOfTheTextbook) {
    expect_mass(hemisphere(), with_shank({2 * pi / 3 * R * R * R, 5 * R / 8}, R));
    expect_outline(hemisphere(), pi * R * R / 2 + 2 * R * (L - R));
    expect_depth(hemisphere(), Vec3(0.6 * R, 0, -0.2 * R), Vec3(0.6, 0, 0.8));
    expect_depth(hemisphere(), Vec3(0, -R, -2 * R), Vec3(0, -1, 0));
    expect_depth(hemisphere(), Vec3(0, 0.3 * R, -L), Vec3(0, 0, -1));
}

TEST(Hemisphere, ItsInertiaIsThatOfAHalfSphere) {
    // about the axis 2/5 m R2, across it through the centre of the sphere the same
    auto projectile = hemisphere();
    projectile.length = R;
    const auto found = make_shape(projectile)->mass_properties();
    const double about_centre = 0.4 * R * R, offset_squared = std::pow(3 * R / 8, 2);
    EXPECT_NEAR(found.inertia(2, 2) / about_centre, 1, 1e-13);
    EXPECT_NEAR(found.inertia(0, 0) / (about_centre - offset_squared), 1, 1e-12);
}

TEST(Cone, HasTheMeasuresOfTheTextbook) {
    const double nose = 12e-3, side = std::hypot(R, nose);
    expect_mass(cone(nose), with_shank({pi / 3 * R * R * nose, 0.75 * nose}, nose));
    expect_outline(cone(nose), R * nose + 2 * R * (L - nose));
    expect_depth(cone(nose), Vec3(R / 2, 0, -nose / 2), Vec3(nose / side, 0, R / side));
}

TEST(Cone, ARoundedTipIsASphereThatTouchesTheSide) {
    const double nose = 12e-3, tip = 1e-3, side = std::hypot(R, nose), sine = R / side,
                 cut = tip / sine - tip;
    expect_depth(cone(nose, tip), Vec3::Zero(), Vec3(0, 0, 1));
    expect_depth(cone(nose, tip), Vec3(R / 2, 0, cut - nose / 2), Vec3(nose / side, 0, sine));
    // the sharp tip is cut by a cone less a segment of the sphere
    const double r = tip * nose / side, high = tip * (1 / sine - sine), segment = tip * (1 - sine);
    const double lost = pi / 3 * r * r * high - pi / 3 * segment * segment * (3 * tip - segment);
    auto shorter = cone(nose, tip);
    shorter.length = L - cut;
    EXPECT_NEAR(
        make_shape(cone(nose))->mass_properties().volume - make_shape(shorter)->mass_properties().volume,
        lost, 1e-12 * pi * R * R * L);
}

TEST(TruncatedCone, HasTheMeasuresOfTheTextbook) {
    const double nose = 6e-3, tip = 2e-3, drop = R - tip, side = std::hypot(drop, nose),
                 squares = tip * tip + tip * R + R * R;
    const Solid frustum{pi / 3 * nose * squares,
                        nose * (1 - (tip * tip * 3 + 2 * tip * R + R * R) / 4 / squares)};
    expect_mass(truncated_cone(nose, 2 * tip), with_shank(frustum, nose));
    expect_outline(truncated_cone(nose, 2 * tip), (tip + R) * nose + 2 * R * (L - nose));
    expect_depth(truncated_cone(nose, 2 * tip), Vec3(tip / 2, 0, 0), Vec3(0, 0, 1));
    expect_depth(truncated_cone(nose, 2 * tip), Vec3((tip + R) / 2, 0, -nose / 2),
                 Vec3(nose / side, 0, drop / side));
}

TEST(Ogive, HasTheMeasuresOfATangentOgive) {
    const double crh = 3, arc = crh * 2 * R, inset = arc - R, nose = 2 * R * std::sqrt(crh - 0.25),
                 half = std::asin(nose / arc);
    // volume of the revolved arc r = sqrt(arc2 - x2) - inset from the shoulder
    const double volume =
        pi * (arc * arc * nose - nose * nose * nose / 3 -
              inset * (nose * std::sqrt(arc * arc - nose * nose) + arc * arc * half) + inset * inset * nose);
    EXPECT_NEAR(make_shape(ogive(crh))->mass_properties().volume / (volume + pi * R * R * (L - nose)), 1,
                1e-12);
    const double segment = arc * arc * half - nose * inset;  // of the circle, both sides of the axis
    expect_outline(ogive(crh), segment + 2 * R * (L - nose));
    const double angle = pi / 2 - half / 3;  // from the axis
    const Vec3 normal(std::sin(angle), 0, std::cos(angle));
    expect_depth(ogive(crh), Vec3(-inset, 0, -nose) + arc * normal, normal);
}

TEST(Ogive, OfHalfACaliberIsAHemisphere) {
    for (const double tip : {0.0, R}) {
        const auto round = make_shape(hemisphere())->mass_properties(),
                   found = make_shape(ogive(0.5, tip))->mass_properties();
        EXPECT_NEAR(found.volume / round.volume, 1, 1e-13);
        EXPECT_NEAR(found.inertia(0, 0) / round.inertia(0, 0), 1, 1e-13);
    }
}

TEST(Ogive, ARoundedTipTouchesTheArc) {
    const double tip = 1e-3;
    const auto shape = make_shape(ogive(2, tip));
    EXPECT_EQ(shape->bounds().high.z(), 0);
    expect_depth(ogive(2, tip), Vec3::Zero(), Vec3(0, 0, 1));
    const double apart = 4 * R - tip, contact = std::asin(3 * R / apart);
    const Vec3 normal(std::sin(contact), 0, std::cos(contact));
    expect_depth(ogive(2, tip), Vec3(0, 0, -tip) + tip * normal, normal);
}

TEST(Profile, HasTheMeasuresOfItsCones) {
    const auto found = make_shape(cup())->mass_properties();
    const double r = 3e-3, hollow = pi / 3 * r * r * 4e-3, frustum = pi / 3 * 4e-3 * (R * R + R * r + r * r);
    EXPECT_NEAR(found.volume / (pi * R * R * 14e-3 - hollow + frustum + pi * r * r * (L - 14e-3)), 1, 1e-13);
    EXPECT_EQ(make_shape(cup())->bounds().high.z(), 4e-3);  // its rim is ahead of the reference point
    EXPECT_EQ(make_shape(cup())->radius(), R);
    expect_depth(cup(), Vec3(1.5e-3, 0, 2e-3), Vec3(-0.8, 0, 0.6));
}

}  // namespace
}  // namespace weavefront::test
