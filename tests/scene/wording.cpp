/// The exact words of messages: they name what was found in the unit that the scene uses, and nothing that
/// only follows from another fault.

#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

using Texts = std::vector<std::string>;

struct Case {
    std::vector<std::string> overrides;
    std::string message;  ///< after the last override
};

class Wording : public testing::TestWithParam<Case> {};

TEST_P(Wording, IsExact) {
    EXPECT_EQ(findings(example, GetParam().overrides),
              Texts{"--set " + GetParam().overrides.back() + ": " + GetParam().message});
}

INSTANTIATE_TEST_SUITE_P(
    Examples, Wording,
    testing::Values(
        // The example is inside the range.
        Case{{"target.mesh.growth=-1.1"},
             "target.mesh.growth: found '-1.1', allowed a number of at least 1, such as '1.5 or 150 %'"},
        Case{{"contact.projectile.unloading=0.5"},
             "contact.projectile.unloading: found '0.5', allowed a number of at least 1, such as '1.5 or 150 "
             "%'"},
        // Bounds have the unit of the value that they are for.
        Case{{"projectile.position=[0, 0, 1 in]"},
             "projectile.position.2: found '1 in', allowed at most -0.00278872 in: the nose starts in front "
             "of the first ply"},
        Case{{"projectile.position=[0, 0, 1e-5 m]"},
             "projectile.position.2: found '1e-5 m', allowed at most -7.08334e-05 m: the nose starts in "
             "front of the first ply"},
        Case{{"target.symmetry=[]", "projectile.position=[20 cm, 0, -1 mm]"},
             "projectile.position.0: found '20 cm', allowed from -10.16 cm to 10.16 cm: over the target"},
        Case{{"target.plies.spacing=100 um"},
             "target.plies.spacing: found '100 um', allowed at least 141.667 um, the mean contact thickness "
             "of the two plies"},
        Case{{"contact.spacing=10 mm", "target.mesh.edge=1 m", "target.mesh.center=1 m"},
             "target.mesh.center: found '1 m', allowed at most 0.1016 m, half of the target"},
        // Lists and maps in quotes.
        Case{{"projectile.velocity=\"[0, 0, 428 m/s]\""},
             "projectile.velocity: found '[0, 0, 428 m/s]' in quotes, which make it a text (did you mean it "
             "without them?), allowed a list "
             "of 3, "
             "each a velocity, such as '428 m/s'"},
        Case{{"target.symmetry='[x, y]'"},
             "target.symmetry: found '[x, y]' in quotes, which make it a text (did you mean it without "
             "them?), allowed a list of x, y"},
        Case{{"contact='{projectile: {}}'"},
             "contact: found '{projectile: {}}' in quotes, which make it a text (did you mean it without "
             "them?), allowed a map with keys "
             "spacing, "
             "projectile, plies, frame"}));

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

TEST(Wording, MissingFabricsAreOneFault) {
    std::string text = example;
    text.erase(text.find("fabrics:"), text.find("target:") - text.find("fabrics:"));
    EXPECT_EQ(findings(text), Texts{"s.yaml:1:1: fabrics: found nothing, allowed a map of names to fabrics"});
    EXPECT_EQ(findings(example, {"fabrics=3"}),
              Texts{"--set fabrics=3: fabrics: found '3', allowed a map of names to fabrics"});
}

TEST(Wording, TheFirstQuantityOfAKindIsNotChangedByAnotherScene) {
    // Units are kept by the scene, not by the program.
    EXPECT_EQ(parse(example, {"fabrics.kevlar129.yarn.span=0.0358 in"}).units.length.name, "in");
    EXPECT_EQ(parse(example).units.length.name, "mm");
}

}  // namespace
}  // namespace weavefront::scene::test
