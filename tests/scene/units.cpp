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
    EXPECT_EQ(parse(example_with("edge_radius: 0.3 mm", "edge_radius: 0.0")).projectiles.front().edge_radius,
              0);
}

}  // namespace
}  // namespace weavefront::scene::test
