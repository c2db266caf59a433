/// Clearance of a facet, and its nearest candidate.

#include "weavefront/contact/clearance_query.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

constexpr double thickness = 0.2;
constexpr int n = 4;  // facets along an edge, each 1 x 1

contact::PlyProperties ply_at(double z) { return {.z = z, .thickness = thickness, .areal_density = 0.2}; }

/// Flat plies. Facet 5 has all facets of the next ply as candidates.
struct FlatPlies : Plies {
    explicit FlatPlies(std::initializer_list<double> heights) {
        for (const double z : heights) add(n, ply_at(z), flat(n, z));
        for (std::int32_t f = n * n; f < static_cast<std::int32_t>(surface.facets.size()); ++f) lists.add(f);
        lists.end_list();
    }

    [[nodiscard]] double clearance(contact::Shortlist& shortlist, double accumulated, double worthwhile = 0,
                                   std::int32_t nearest = -1) const {
        const auto corners = contact::corners_of(facet().nodes, x);
        const contact::ContactPoints points(contact::quadrature(0, 0), corners, corners);
        return contact::clearance({facet().ply, points, lists.of(0), surface, distances(), x}, nearest,
                                  shortlist, accumulated, worthwhile);
    }
    [[nodiscard]] double clearance() const {
        contact::Shortlist none;
        return clearance(none, 0);
    }
    [[nodiscard]] contact::Nearest nearest() const {
        const auto corners = contact::corners_of(facet().nodes, x);
        const contact::ContactPoints points(contact::quadrature(0, 0), corners, corners);
        return contact::find_nearest({facet().ply, points, lists.of(0), surface, distances(), x},
                                     contact::centre_of(corners));
    }
    /// Moves all later plies.
    void shift(const Vec3& by) {
        for (std::size_t k = (n + 1) * (n + 1); k < x.size(); ++k) x[k] += by;
    }
    [[nodiscard]] contact::ContactDistances distances() const {
        return contact::ContactDistances(surface.plies);
    }
    [[nodiscard]] const contact::Facet& facet() const { return surface.facets[5]; }

    contact::FacetLists lists;
};

// The margin of the contact distance for rounding is 1e-4 of it.
constexpr double margin = 2e-4 * thickness;

TEST(Clearance, IsTheDistanceLessTheContactDistance) {
    for (const double z : {0.25, 0.4, 0.7}) {
        const double clear = FlatPlies({0, z}).clearance();
        EXPECT_LE(clear, z - thickness);
        EXPECT_GE(clear, z - thickness - margin);
    }
}

TEST(Clearance, IsAtMostThatOfFacetsThatAreNoCandidates) {
    const FlatPlies plies({0, 50});
    EXPECT_EQ(plies.clearance(), plies.distances().max_penetration() - plies.distances().most());
}

TEST(Clearance, IsZeroWhereItIsNotWorthwhile) {
    const FlatPlies plies({0, 0.3});
    contact::Shortlist none;
    EXPECT_GT(plies.clearance(none, 0, 0.09), 0);
    none = {};
    EXPECT_EQ(plies.clearance(none, 0, 0.11), 0);
}

TEST(Clearance, DoesNotCountErodedCandidates) {
    FlatPlies plies({0, 0.3});
    for (std::size_t f = n * n; f < plies.surface.facets.size(); ++f) plies.surface.alive[f] = 0;
    EXPECT_EQ(plies.clearance(), plies.distances().max_penetration() - plies.distances().most());
}

/// The next ply is shifted by half a facet. Two columns of it lie over facet 5; the others are 0.5 aside.
struct ShiftedPly : FlatPlies {
    ShiftedPly() : FlatPlies({0, 0.25}) { shift({0.5, 0, 0}); }
    const double of_others = Vec3(0.5, 0, 0.25).norm() - thickness;
};

TEST(Clearance, AShortlistHoldsUpToTheClearanceOfTheOtherCandidates) {
    const ShiftedPly plies;
    contact::Shortlist shortlist;
    static_cast<void>(plies.clearance(shortlist, 1.0));
    EXPECT_TRUE(shortlist.holds(5) && shortlist.holds(4));
    EXPECT_FALSE(shortlist.holds(6) || shortlist.holds(15));
    EXPECT_LE(static_cast<double>(shortlist.until), 1 + plies.of_others);
    EXPECT_NEAR(static_cast<double>(shortlist.until), 1 + plies.of_others, margin);
}

TEST(Clearance, CountsTheOtherCandidatesByWhatIsLeftOfTheShortlist) {
    ShiftedPly plies;
    contact::Shortlist shortlist;
    static_cast<void>(plies.clearance(shortlist, 1.0));
    plies.shift({0, 0, 5});
    const auto before = shortlist;
    EXPECT_NEAR(plies.clearance(shortlist, 1 + 0.75 * plies.of_others), 0.25 * plies.of_others, margin);
    EXPECT_EQ(shortlist.slots, before.slots);
    EXPECT_GT(plies.clearance(shortlist, 1 + 1.01 * plies.of_others), plies.of_others) << "renewed";
    EXPECT_EQ(shortlist.slots, 0U);
}

TEST(Clearance, MeasuresTheShortlistWhileItHolds) {
    ShiftedPly plies;
    contact::Shortlist shortlist;
    static_cast<void>(plies.clearance(shortlist, 1.0));
    plies.shift({0, 0, -0.02});
    EXPECT_NEAR(plies.clearance(shortlist, 1.02), 0.03, margin);
    EXPECT_NEAR(plies.clearance(shortlist, 1.02, 0, 16 + 5), 0.03, margin) << "with a nearest candidate";
}

TEST(FindNearest, ReturnsTheNearestCentreAndItsLead) {
    FlatPlies plies({0, 0.5});
    plies.shift({0.3, 0.1, 0});  // candidate 16 + 5 is 0.3, 0.1 away, its neighbour 16 + 4 -0.7, 0.1
    const auto nearest = plies.nearest();
    EXPECT_EQ(nearest.facet, n * n + 5);
    const double lead = (Vec3(0.7, 0.1, 0.5).norm() - Vec3(0.3, 0.1, 0.5).norm()) / 2;
    EXPECT_LE(nearest.lead, lead);
    EXPECT_NEAR(nearest.lead, lead, 2e-4 * lead);
    plies.surface.alive[n * n + 5] = 0;
    EXPECT_EQ(plies.nearest().facet, n * n + 4);
}

TEST(FindNearest, IsNotKnownWithCandidatesInSeveralPlies) {
    EXPECT_EQ(FlatPlies({0, 0.5, 1}).nearest().facet, -1);
}

TEST(NotAbove, IsTheNumberLessASmallPartOfIt) {
    std::mt19937_64 random(14);
    for (int pass = 0; pass < 1000; ++pass) {
        const double value = uniform(random, -1, 1) * std::pow(10, uniform(random, -6, 3));
        EXPECT_LE(static_cast<double>(contact::not_above(value)), value);
        EXPECT_NEAR(static_cast<double>(contact::not_above(value)), value, 0x1p-21 * std::abs(value));
    }
}

}  // namespace
}  // namespace weavefront::test
