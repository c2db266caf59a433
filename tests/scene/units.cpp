#include <gtest/gtest.h>

#include <numbers>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

double end_time(const std::string& text) {
    return parse(example_with("end: 200 us", "end: " + text), {"output.interval=0"}).time.end;
}

double span(const std::string& text) {
    return parse(example_with("span: 0.909 mm", "span: " + text)).fabrics[0].yarn.span;
}

TEST(Units, SameQuantityInAnyPowerOfTenIsTheSameDouble) {
    for (const std::string text : {"0.909 mm", "909 um", "909000 nm", "909e3 nm", "0.0909 cm", "9.09e-4 m",
                                   "0.000000909 km", "+0.909mm"}) {
        EXPECT_EQ(span(text), 0.000909) << text;
    }
    for (const std::string text :
         {"204 g/m^2", "0.204 kg/m^2", "0.0204 g/cm^2", "204 g m-2", "0.204 mg/mm^2"}) {
        EXPECT_EQ(parse(example_with("204 g/m^2", text)).fabrics[0].areal_density, 0.204) << text;
    }
    for (const std::string text : {"1440 kg/m^3", "1.44 g/cm^3", "1.44 kg/l"}) {
        EXPECT_EQ(parse(example_with("1440 kg/m^3", text)).fabrics[0].density, 1440) << text;
    }
    for (const std::string text : {"35 MPa s", "0.035 GPa s", "35e6 Pa s", "35e6 N s/m^2"}) {
        EXPECT_EQ(parse(example_with("35 MPa s", text)).fabrics[0].elastic.viscosity, 35e6) << text;
    }
    for (const std::string text : {"5.6e12 N/m^3", "5600 N/mm^3", "5.6 GPa/mm", "5.6E+12 Pa/m"}) {
        EXPECT_EQ(parse(example_with("5.6e12 N/m^3", text)).contact.projectile->stiffness, 5.6e12) << text;
    }
    for (const std::string text : {"3.3 %", "0.033", "3.3e-2", "3.3%"}) {
        EXPECT_EQ(parse(example_with("3.3 %", text)).fabrics[0].failure->static_strain, 0.033) << text;
    }
}

TEST(Units, TimesAndRates) {
    EXPECT_EQ(end_time("0.5 min"), 30);
    EXPECT_EQ(end_time("2 h"), 7200);
    EXPECT_EQ(end_time("3 ms"), 0.003);
    EXPECT_EQ(parse(example + "damping: 100 1/s\n").damping, 100);
    EXPECT_EQ(parse(example + "damping: 0.1 1/ms\n").damping, 100);
    EXPECT_EQ(parse(example + "damping: 0.1 kHz\n").damping, 100);
}

TEST(Units, Angles) {
    const auto locking = [](const std::string& text) {
        return parse(example_with("35 deg", text)).fabrics[0].lateral->locking_angle;
    };
    EXPECT_EQ(locking("30 deg"), locking("30 degrees"));
    EXPECT_EQ(locking("30 deg"), locking("30°"));
    EXPECT_DOUBLE_EQ(locking("30 deg"), std::numbers::pi / 6);
    EXPECT_EQ(locking("0.5 rad"), 0.5);
}

TEST(Units, BareZeroNeedsNoUnit) {
    EXPECT_EQ(parse(example_with("thickness: 0.820 mm", "thickness: 0")).fabrics[0].thickness, 0);
    EXPECT_EQ(parse(example_with("edge_radius: 0.3 mm", "edge_radius: 0.0")).projectile->edge_radius, 0);
}

TEST(Units, WhatIsNoQuantityIsRefused) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"0.82", "'0.82', a number without a unit"},
        {"0.82 kg", "'0.82 kg', a mass"},
        {"0.82 GPa", "'0.82 GPa', a modulus"},
        {"0.82 A", "'0.82 A', a quantity in A"},
        {"0.82 deg", "'0.82 deg', an angle"},
        {"0.82 furlongs_per", "'0.82 furlongs_per', 'furlongs_per' is not a unit"},
        {"0.82 1 mm", "'0.82 1 mm', '1 mm' is not a unit"},
        {"\"0,82 mm\"", "'0,82 mm', ',82 mm' is not a unit"},
        {"0.82 m @ 5", "'0.82 m @ 5', 'm @ 5' is not a scale from zero"},
        {"thick", "'thick', not a number"},
        {".nan", "'.nan', not a number"},
        {"nan mm", "'nan mm', not a finite number"},
        {"inf mm", "'inf mm', not a finite number"},
        {"1e999 mm", "'1e999 mm', beyond the range of numbers"},
        {"1e308 km", "'1e308 km', beyond the range of numbers"},
        {"[1 mm]", "a list"},
        {"{a: 1}", "a map of keys"},
        {"~", "nothing"},
        {"-1 mm", "'-1 mm'"},
    };
    for (const auto& [text, found] : cases) {
        const auto messages = findings(example_with("0.820 mm", text));
        ASSERT_EQ(messages.size(), 1U) << text;
        EXPECT_EQ(messages[0], "s.yaml:8:16: fabrics.kevlar129.thickness: found " + found +
                                   ", allowed a length of at least 0, such as '0.9 mm'");
    }
}

TEST(Units, WhatTradersWriteIsToldAsUdunitsWritesIt) {
    const auto told = [](const std::string& mine, const std::string& text) {
        const auto messages = findings(example_with(mine, text));
        const auto& message = messages.at(0);
        const auto question = message.find("did you mean '");
        return question == std::string::npos ? "nothing" : message.substr(question);
    };
    EXPECT_EQ(told("204 g/m^2", "6 oz/yd^2"), "did you mean '6 avoirdupois_ounce/yd^2'?");
    EXPECT_EQ(told("204 g/m^2", "204 gsm"), "did you mean '204 g/m^2'?");
    EXPECT_EQ(told("[0, 0, 428 m/s]", "[0, 0, 876 fps]"), "did you mean '876 ft/s'?");
    EXPECT_EQ(told("[0, 0, 428 m/s]", "[0, 0, 597 mph]"), "did you mean '597 mile/hour'?");
    EXPECT_EQ(told("[0, 0, 428 m/s]", "[0, 0, 267 oz]"), "nothing");  // no velocity by any name
}

TEST(Units, AnglesAreNoNumbersAndNumbersNoAngles) {
    EXPECT_TRUE(findings(example_with("friction: 0.11", "friction: 0.11 deg"))[0].starts_with(
        "s.yaml:12:15: fabrics.kevlar129.friction: found '0.11 deg', an angle, allowed a number of at least "
        "0"));
    EXPECT_TRUE(findings(example_with("35 deg", "0.6"))[0].starts_with(
        "s.yaml:11:72: fabrics.kevlar129.lateral.locking_angle: found '0.6', a number without a unit, "
        "allowed an angle"));
}

}  // namespace
}  // namespace weavefront::scene::test
