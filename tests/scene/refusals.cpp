#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

TEST(Refusals, AreReportedAtOnceInTheOrderOfTheFile) {
    std::string text = example_with("safety: 0.9", "safty: 0.9");
    text.replace(text.find("96 GPa"), 6, "96 mm");
    text.replace(text.find("204 g/m^2"), 9, "204");
    text += "titel: x\n";
    const auto messages = findings(text);
    ASSERT_EQ(messages.size(), 4U);
    EXPECT_TRUE(messages[0].starts_with(
        "s.yaml:5:20: fabrics.kevlar129.areal_density: found '204', a number without a unit"));
    EXPECT_TRUE(messages[1].starts_with(
        "s.yaml:9:31: fabrics.kevlar129.elastic.static_modulus: found '96 mm', a length, allowed a modulus"));
    EXPECT_TRUE(messages[2].starts_with(
        "s.yaml:25:21: time.safty: found an unknown key, allowed end, safety, stop, did you mean 'safety'?"));
    EXPECT_TRUE(messages[3].starts_with("s.yaml:27:1: titel: found an unknown key"));
}

}  // namespace
}  // namespace weavefront::scene::test
