#include <gtest/gtest.h>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

struct Case {
    std::string from;
    std::string to;
    std::string message;  ///< how the only message begins
};

class Refusal : public testing::TestWithParam<Case> {};

TEST_P(Refusal, IsOneMessage) {
    const auto messages = findings(example_with(GetParam().from, GetParam().to));
    ASSERT_EQ(messages.size(), 1U) << (messages.empty() ? "accepted" : messages[1]);
    EXPECT_TRUE(messages[0].starts_with(GetParam().message)) << messages[0];
}

const std::string fabric_keys =
    "formulation, areal_density, density, yarn, thickness, elastic, failure, lateral, friction, "
    "transverse_shear, hourglass, "
    "contact_thickness";

INSTANTIATE_TEST_SUITE_P(
    Keys, Refusal,
    testing::Values(
        Case{"    friction:", "    frictoin:",
             "s.yaml:12:5: fabrics.kevlar129.frictoin: found an unknown key, allowed " + fabric_keys +
                 ", did you mean 'friction'?"},
        Case{"    friction:", "    zzz:",
             "s.yaml:12:5: fabrics.kevlar129.zzz: found an unknown key, allowed " + fabric_keys},
        Case{"title:", "titel:",
             "s.yaml:1:1: titel: found an unknown key, allowed title, fabrics, target, projectile"},
        Case{
            "    friction: 0.11", "    density: 1 kg/m^3",
            "s.yaml:12:5: fabrics.kevlar129.density: found the key again, first at s.yaml:6:5, allowed once"},
        Case{"    thickness: 0.820 mm", "",
             "s.yaml:3:3: fabrics.kevlar129.thickness: found nothing, allowed a length of at least 0"},
        Case{"    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}", "",
             "s.yaml:3:3: fabrics.kevlar129.yarn: found nothing, allowed a map with keys span, area, width"},
        Case{"yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}", "yarn: 3 mm",
             "s.yaml:7:11: fabrics.kevlar129.yarn: found '3 mm', allowed a map with keys span, area, width"},
        Case{"title: Eight plies", "title: [Eight] #", "s.yaml:1:8: title: found a list, allowed text"}));

INSTANTIATE_TEST_SUITE_P(
    Fabric, Refusal,
    testing::Values(
        Case{"consistent  ", "consistnt",
             "s.yaml:4:18: fabrics.kevlar129.formulation: found 'consistnt', allowed consistent, paper, did "
             "you mean 'consistent'?"},
        Case{"204 g/m^2", "0 g/m^2",
             "s.yaml:5:20: fabrics.kevlar129.areal_density: found '0 g/m^2', allowed an areal density "
             "greater than 0"},
        Case{"0.820 mm", "-0.82 mm",
             "s.yaml:8:16: fabrics.kevlar129.thickness: found '-0.82 mm', allowed a length of at least 0"},
        Case{"width: 0.32 mm", "width: 0.909 mm",
             "s.yaml:7:55: fabrics.kevlar129.yarn.width: found '0.909 mm', allowed less than the span"},
        Case{"192 GPa", "96 GPa",
             "s.yaml:9:54: fabrics.kevlar129.elastic.hooke_modulus: found '96 GPa', allowed more than "
             "static_modulus"},
        Case{"3.3 %", "3.3",
             "s.yaml:10:30: fabrics.kevlar129.failure.static_strain: found '3.3', allowed a number greater "
             "than 0 and at most 100 %"},
        Case{"2.7 %", "-2.7 %",
             "s.yaml:10:51: fabrics.kevlar129.failure.hooke_strain: found '-2.7 %', allowed a number greater "
             "than 0"},
        Case{"both_yarns", "all",
             "s.yaml:10:65: fabrics.kevlar129.failure.erode: found 'all', allowed both_yarns, any_yarn"},
        Case{"35 deg", "45 deg",
             "s.yaml:11:72: fabrics.kevlar129.lateral.locking_angle: found '45 deg', allowed an angle "
             "greater than 0 deg and less"},
        Case{"35 deg", "-1 deg",
             "s.yaml:11:72: fabrics.kevlar129.lateral.locking_angle: found '-1 deg', allowed an angle "
             "greater than 0 deg and less"},
        Case{"3 deg", "0 deg",
             "s.yaml:11:92: fabrics.kevlar129.lateral.transition: found '0 deg', allowed an angle greater "
             "than 0"},
        Case{" 3 deg", " 35 deg",
             "s.yaml:11:92: fabrics.kevlar129.lateral.transition: found '35 deg', allowed less than the "
             "locking angle"},
        Case{"friction: 0.11", "friction: -1",
             "s.yaml:12:15: fabrics.kevlar129.friction: found '-1', allowed a number of at least 0"},
        Case{"friction: 0.11", "contact_thickness: 0",
             "s.yaml:12:24: fabrics.kevlar129.contact_thickness: found '0', allowed a length greater"}));

INSTANTIATE_TEST_SUITE_P(
    Controls, Refusal,
    testing::Values(
        Case{"spacing: 0.25 mm    ", "spacing: node   ",
             "s.yaml:22:12: contact.spacing: found 'node', not a number, allowed a length"},
        Case{"unloading: 10}", "unloading: 0.5}",
             "s.yaml:23:52: contact.projectile.unloading: found '0.5', allowed a number of at least 1"},
        Case{"damping: 0.2", "damping: 1.2",
             "s.yaml:24:60: contact.plies.damping: found '1.2', allowed a number from 0 to 1"},
        Case{"5.6e12 N/m^3", "5.6e12 Pa",
             "s.yaml:23:27: contact.projectile.stiffness: found '5.6e12 Pa', a modulus, allowed a stiffness "
             "per area"},
        Case{"  projectile: {stiffness", "  # {",
             "s.yaml:21:1: contact: found a map of keys, allowed a map with the key projectile"},
        Case{"safety: 0.9", "safety: 1.3",
             "s.yaml:25:29: time.safety: found '1.3', allowed a number greater than 0 and at most 1.2"},
        Case{"end: 200 us", "end: 0", "s.yaml:25:13: time.end: found '0', allowed a time greater than 0"},
        Case{"interval: 5 us", "interval: 5 ms",
             "s.yaml:26:20: output.interval: found '5 ms', allowed at most the end of the run"},
        Case{"interval: 5 us", "interval: 1e-9 us",
             "s.yaml:26:20: output.interval: found '1e-9 us', allowed 0 or at least a millionth"},
        Case{"history: 0.5 us", "history: 1 s",
             "s.yaml:26:75: output.history: found '1 s', allowed at most the end of the run"},
        Case{"history: 0.5 us", "history: 0",
             "s.yaml:26:75: output.history: found '0', allowed a time greater than 0"},
        Case{"stress, broken", "strss, broken",
             "s.yaml:26:49: output.fields.1: found 'strss', allowed displacement, velocity, strain, stress, "
             "braid_angle, crimp, broken, did you mean 'stress'?"},
        Case{"stress, broken", "stress, crmip",
             "s.yaml:26:57: output.fields.2: found 'crmip', allowed displacement, velocity, strain, stress, "
             "braid_angle, crimp, broken, "
             "did you mean 'crimp'?"},
        Case{"stress, broken", "stress, stress",
             "s.yaml:26:57: output.fields.2: found 'stress' again, allowed each name once"},
        Case{"[displacement, stress, broken]", "stress",
             "s.yaml:26:34: output.fields: found 'stress', allowed a list of displacement"}));

INSTANTIATE_TEST_SUITE_P(
    Later, Refusal,
    testing::Values(
        Case{"shape: cylinder", "shape: fsp",
             "s.yaml:20:21: projectile.shape: found 'fsp', not available in this version, allowed cylinder"},
        Case{"mass: 2.8 g", "mass: 2.8 g, angular_velocity: 1",
             "s.yaml:20:84: projectile.angular_velocity: not available in this version"},
        Case{"mass: 2.8 g", "mass: 2.8 g, rotation: free",
             "s.yaml:20:84: projectile.rotation: not available in this version"},
        Case{"unloading: 10}", "friction: 0.2}",
             "s.yaml:23:41: contact.projectile.friction: not available in this version"},
        Case{"  spacing: 0.25 mm ", "  friction: 0.2",
             "s.yaml:22:3: contact.friction: not available in this version"},
        Case{"  symmetry:", "  file: a.k\n  symmetry:",
             "s.yaml:18:3: target.file: not available in this version"},
        Case{"growth: 1.08", "type: radial", "s.yaml:17:36: target.mesh.type: not available in this version"},
        Case{"safety: 0.9", "subcycling: true",
             "s.yaml:25:21: time.subcycling: not available in this version"},
        Case{"interval: 5 us", "interval: 0, checkpoint: 1 us",
             "s.yaml:26:23: output.checkpoint: no key of a scene: options of weavefront run are "
             "--checkpoint-every, --walltime and --restart"},
        Case{"time:", "checkpoint: {}\ntime:",
             "s.yaml:25:1: checkpoint: no key of a scene: options of weavefront "
             "run are --checkpoint-every, --walltime and --restart"},
        Case{"time:", "restart: a.h5\ntime:", "s.yaml:25:1: restart: no key of a scene"}));

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

TEST(Refusals, MisspelledRequiredKeyIsMissingAndUnknown) {
    const auto messages = findings(example_with("    density:", "    densty:"));
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0],
              "s.yaml:3:3: fabrics.kevlar129.density: found nothing, allowed a density greater than 0, such "
              "as '1440 kg/m^3'");
    EXPECT_EQ(messages[1], "s.yaml:6:5: fabrics.kevlar129.densty: found an unknown key, allowed " +
                               fabric_keys + ", did you mean 'density'?");
}

TEST(Refusals, SyntaxErrorIsOneMessageWithItsPlace) {
    const auto messages = findings(example_with("{end: 200 us", "{end: 200 us]"));
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_TRUE(messages[0].starts_with("s.yaml:25:")) << messages[0];
    EXPECT_NE(messages[0].find(": not YAML: "), std::string::npos) << messages[0];
}

TEST(Refusals, WhatIsNoSceneIsRefused) {
    EXPECT_EQ(findings(""),
              std::vector<std::string>{
                  "s.yaml:1:1: found nothing, allowed a map of keys, beginning with title or fabrics"});
    EXPECT_EQ(findings("[1, 2]").size(), 1U);
    EXPECT_EQ(findings("? {a: 1}\n: 2\n"),
              std::vector<std::string>{"s.yaml:1:3: found a map of keys as a key, allowed a name"});
    EXPECT_TRUE(
        findings(example + "---\ntitle: x\n").at(0).ends_with("found a second YAML document, allowed one"));
    EXPECT_TRUE(findings("fabrics: &a {b: *a}").at(0).ends_with("found an alias inside its own anchor"));
}

}  // namespace
}  // namespace weavefront::scene::test
