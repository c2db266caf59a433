/// The exact words of messages: they name what was found in the unit that the scene uses, and nothing that
/// only follows from another fault.

#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

using Texts = std::vector<std::string>;

TEST(Wording, BoundsInMessagesAreAcceptedWhenTypedIn) {
    for (const std::string bound : {"-0.0708334 mm", "-0.00278872 in", "-7.08334e-05 m"})
        EXPECT_EQ(findings(example, {"projectile.position=[0, 0, " + bound + "]"}), Texts{}) << bound;
    for (const std::string bound : {"141.667 um", "0.141667 mm"})
        EXPECT_EQ(findings(example, {"target.plies.spacing=" + bound}), Texts{}) << bound;
}

TEST(Wording, MessageUnitsAreThoseThatTheSceneUsesFirst) {
    const auto units = parse(example).units;
    EXPECT_EQ(units.length.name, "mm");
    EXPECT_EQ(units.length.si, 1e-3);
    EXPECT_EQ(units.time.name, "us");
    EXPECT_EQ(parse(example, {"fabrics.kevlar129.yarn.span=0.0358 in"}).units.length.name, "in");
    EXPECT_EQ(text_of(0.0254, parse(example, {"fabrics.kevlar129.yarn.span=0.0358 in"}).units.length),
              "1 in");
}

TEST(Wording, TheFirstQuantityOfAKindIsNotChangedByAnotherScene) {
    // Units are kept by the scene, not by the program.
    EXPECT_EQ(parse(example, {"fabrics.kevlar129.yarn.span=0.0358 in"}).units.length.name, "in");
    EXPECT_EQ(parse(example).units.length.name, "mm");
}

}  // namespace
}  // namespace weavefront::scene::test
