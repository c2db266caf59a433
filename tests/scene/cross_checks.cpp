#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

TEST(CrossChecks, AFrameHasBarsWhereEdgesRestOnIt) {
    const std::string rests = "target.edges={x: fixed, y: frame}";
    const auto framed = parse(example, {rests, "target.frame={opening: {y: 180 mm}}"});
    ASSERT_TRUE(framed.target->frame);
    EXPECT_FALSE(framed.target->frame->half_opening[0]);
    EXPECT_DOUBLE_EQ(framed.target->frame->half_opening[1].value(), 90e-3);
    EXPECT_EQ(framed.target->frame->edge_radius, 1e-3);
    EXPECT_EQ(framed.contact.frame.stiffness, 5.6e12);
    EXPECT_EQ(parse(framed.resolved, {}).hash, framed.hash);
}

TEST(CrossChecks, SymmetricEdgesAndNamesAreAccepted) {
    EXPECT_EQ(parse(example, {"target.edges={x: clamped, y: pinned}"}).target->edges,
              (std::array{Edge::fixed, Edge::fixed}));
    EXPECT_EQ(parse(example, {"target.edges={x: sliding, y: free}"}).target->edges,
              (std::array{Edge::sliding, Edge::free}));
    EXPECT_TRUE(findings(example, {"target.plies.angle=90 deg"}).empty());
    EXPECT_TRUE(findings(example, {"target.symmetry=[]", "target.plies.angle=45 deg"}).empty());
}

// A projectile that may start where the default puts it, and no lower.
TEST(CrossChecks, TouchingIsOutside) {
    EXPECT_TRUE(findings(example, {"projectile.position=[0, 0, -0.0708334 mm]"}).empty());
}

}  // namespace
}  // namespace weavefront::scene::test
