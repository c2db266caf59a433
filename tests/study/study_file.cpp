#include <gtest/gtest.h>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {
namespace {

const std::string scene_text = R"(fabrics:
  a:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.9 mm, area: 0.06 mm^2, width: 0.3 mm}
    thickness: 0.8 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa}
target:
  size: [100 mm, 100 mm]
  plies: {count: 1, fabric: a}
  mesh: {center: 1 mm, edge: 3 mm}
time: {end: 60 us}
output: {interval: 5 us, history: 1 us}
)";

const std::string study_text = R"(title: a study
scene: base.yaml
set: {time.end: 20 us}
variants:
  - {target.mesh.center: [2 mm, 500 um]}
  - speed:
      slow: {time.end: 40 us, damping: 3 1/s}
      fast: {fabrics.a.elastic.viscosity: }
order: target.mesh.center
reference: {variant: {target.mesh.center: 0.5 mm}}
quantities: [outcome, {history: column, norm: max}]
tolerance: {column_max: 2 %}
)";

Vocabulary vocabulary(Compute) { return {{"outcome"}, {"column"}, {"field"}, {"form"}}; }

Study parse(const std::string& text) { return parse_study(text, "folder/s.yaml", vocabulary); }

std::vector<std::string> findings(const std::string& text) {
    try {
        const Study study = parse(text);
        parse_cases(study, scene_text, variants_of(study));
    } catch (const InputError& error) {
        return error.messages();
    }
    return {};
}

/// Each finding begins as expected, in this order.
void expect_findings(const std::string& text, const std::vector<std::string>& beginnings) {
    const std::vector<std::string> found = findings(text);
    ASSERT_EQ(found.size(), beginnings.size()) << testing::PrintToString(found);
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i].substr(0, beginnings[i].size()), beginnings[i]);
}

std::string study_with(const std::string& from, const std::string& to) {
    std::string text = study_text;
    return text.replace(text.find(from), from.size(), to);
}

TEST(StudyFile, PathsInItAreRelativeToIt) { EXPECT_EQ(parse(study_text).scene, "folder/base.yaml"); }

TEST(StudyFile, VariantsAreTheProductOfTheAxesInOrder) {
    const std::vector<Variant> variants = variants_of(parse(study_text));
    std::vector<std::string> names;
    for (const Variant& variant : variants) names.push_back(variant.name);
    EXPECT_EQ(names, (std::vector<std::string>{"center=2mm,speed=slow", "center=2mm,speed=fast",
                                               "center=500um,speed=slow", "center=500um,speed=fast"}));
    EXPECT_DOUBLE_EQ(*variants[2].values[0], 0.5e-3);
    EXPECT_FALSE(variants[2].values[1]);
}

TEST(StudyFile, NamesOfVariantsKeepTheirUnits) {
    const std::vector<Variant> variants = variants_of(parse(study_with("slow: {", "5 %: {")));
    EXPECT_EQ(variants[0].name, "center=2mm,speed=5percent");
}

TEST(StudyFile, NamesOfVariantsStayInTheFolderOfTheStudy) {
    const std::vector<Variant> variants = variants_of(parse(study_with("- speed:", "- \"../a b/speed\":")));
    EXPECT_EQ(variants[0].name.find('/'), std::string::npos) << variants[0].name;
    EXPECT_EQ(variants[0].name.find(".."), std::string::npos) << variants[0].name;
}

TEST(StudyFile, EachVariantHasItsOwnScene) {
    const Study study = parse(study_text);
    const std::vector<Case> cases = parse_cases(study, scene_text, variants_of(study));
    EXPECT_DOUBLE_EQ(cases[0].scene.target->mesh.center, 2e-3);
    EXPECT_DOUBLE_EQ(cases[0].scene.time.end, 40e-6);  // an axis has the last word
    EXPECT_DOUBLE_EQ(cases[1].scene.time.end, 20e-6);
    EXPECT_DOUBLE_EQ(cases[0].scene.damping, 3);
    EXPECT_NE(cases[0].hash, cases[2].hash);
}

TEST(StudyFile, TheReferenceChangesWhatItNamesAndKeepsTheRest) {
    const Study study = parse(study_text);
    const std::vector<Variant> variants = variants_of(study);
    const Case fine = parse_case(study, scene_text, reference_of(study, variants[0]));
    EXPECT_DOUBLE_EQ(fine.scene.target->mesh.center, 0.5e-3);
    EXPECT_DOUBLE_EQ(fine.scene.damping, 3);
    // 500 um and 0.5 mm are one scene.
    EXPECT_EQ(fine.hash, parse_case(study, scene_text, variants[2]).hash);
}

TEST(StudyFile, TolerancesBelongToQuantities) {
    const Study study = parse(study_text);
    EXPECT_FALSE(study.quantities[0].tolerance);
    EXPECT_DOUBLE_EQ(*study.quantities[1].tolerance, 0.02);
}

TEST(StudyFile, AllFaultsAreReportedAtOnceWithTheirPlaces) {
    std::string text = study_text;
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"title", "titel"},
             {"order: target.mesh.center", "order: target.mesh.centre"},
             {"outcome,", "outcom,"},
             {"norm: max", "norm: min"},
             {"column_max: 2 %", "column_min: 2 kg"}})
        text.replace(text.find(from), from.size(), to);
    expect_findings(
        text, {"folder/s.yaml:1:1: titel: found an unknown key",
               "folder/s.yaml:9:8: order: found 'target.mesh.centre', allowed target.mesh.center",
               "folder/s.yaml:11:14: quantities.0: found 'outcom', allowed outcome, did you mean 'outcome'?",
               "folder/s.yaml:11:46: quantities.1.norm: found 'min', allowed l1, l2, max",
               "folder/s.yaml:12:13: tolerance: found 'column_min'",
               "folder/s.yaml:12:25: tolerance.column_min: found '2 kg', a mass"});
}

TEST(StudyFile, AMistypedAxisIsReportedRatherThanTheOrderThatNamesItRightly) {
    expect_findings(study_with("target.mesh.center: [", "target.mesh.centre: ["),
                    {"folder/s.yaml:5:27: target.mesh.centre: found an unknown key, allowed center, edge, "
                     "growth, did you mean 'center'?",
                     "folder/s.yaml:5:33: target.mesh.centre: found an unknown key, allowed "});
    expect_findings(study_with("order: target.mesh.center", "order: target.mesh"),
                    {"folder/s.yaml:9:8: order: found 'target.mesh', allowed target.mesh.center, speed"});
}

TEST(StudyFile, AMistypedQuantityIsNoFaultOfItsTolerance) {
    std::string text = study_with("column_max: 2 %", "outcome: 2 %");
    text.replace(text.find("[outcome"), 8, "[outcmoe");
    expect_findings(
        text,
        {"folder/s.yaml:11:14: quantities.0: found 'outcmoe', allowed outcome, did you mean 'outcome'?"});
    expect_findings(study_with("column_max: 2 %", "column_l1: 2 %"),
                    {"folder/s.yaml:12:13: tolerance: found 'column_l1', allowed "});
}

TEST(StudyFile, EmptyListsAreCalledSo) {
    expect_findings(
        study_with("[2 mm, 500 um]", "[]"),
        {"folder/s.yaml:5:26: variants.0.target.mesh.center: found an empty list, allowed a list of values"});
    expect_findings(study_with("[outcome, {history: column, norm: max}]\ntolerance: {column_max: 2 %}", "[]"),
                    {"folder/s.yaml:11:13: quantities: found an empty list, allowed a list"});
}

TEST(StudyFile, FaultsOfVariantsAreReportedBeforeAnythingIsComputedAtTheirPlacesInTheStudy) {
    std::string text = study_with("500 um", "500 kg");
    text.replace(text.find("damping"), 7, "dampnig");
    expect_findings(text,
                    {"folder/s.yaml:7:40: dampnig: found an unknown key",
                     "folder/s.yaml:5:33: target.mesh.center: found '500 kg', a mass, allowed a length"});
}

TEST(StudyFile, ReferencesAreOfOneKind) {
    expect_findings(study_with("reference: {variant: {target.mesh.center: 0.5 mm}}",
                               "reference: {closed_form: form, file: x.csv}"),
                    {"folder/s.yaml:10:1: reference: found the keys closed_form, file, allowed one of the "
                     "keys variant, closed_form, file"});
}

Variant reference(const std::string& given) {
    const Study study = parse(study_with("{variant: {target.mesh.center: 0.5 mm}}", given));
    return reference_of(study, variants_of(study)[1]);  // 2 mm, fast
}

TEST(References, MayBeAnAxisAndItsLabel) {
    const Variant slow = reference("{variant: {speed: slow, target.mesh.center: 0.5 mm}}");
    EXPECT_EQ(slow.name, "reference,center=0.5mm,speed=slow");
    const Case input = parse_case(parse(study_text), scene_text, slow);
    EXPECT_DOUBLE_EQ(input.scene.time.end, 40e-6);
    EXPECT_DOUBLE_EQ(input.scene.damping, 3);
    EXPECT_DOUBLE_EQ(input.scene.target->mesh.center, 0.5e-3);
}

TEST(References, MayBeANameOfAVariantOrALabelOfOneAxis) {
    EXPECT_EQ(reference("{variant: slow}").name, "reference,center=2mm,speed=slow");
    EXPECT_EQ(reference("{variant: 500 um}").name, "reference,center=500um,speed=fast");
    EXPECT_EQ(reference("{variant: \"center=500um,speed=slow\"}").name, "reference,center=500um,speed=slow");
}

// The settings of the choice that a reference replaces do not stay: damping belongs to slow alone.
TEST(References, ReplaceTheChoiceOfTheVariant) {
    const Study study = parse(study_with("{variant: {target.mesh.center: 0.5 mm}}", "{variant: fast}"));
    const Case input =
        parse_case(study, scene_text, reference_of(study, variants_of(study)[0]));  // of 2 mm, slow
    EXPECT_DOUBLE_EQ(input.scene.damping, 0);
    EXPECT_DOUBLE_EQ(input.scene.time.end, 20e-6);
}

TEST(References, AtFaultAreToldWithWhatTheStudyHas) {
    const auto one = [](const std::string& given) {
        const auto all = findings(study_with("{variant: {target.mesh.center: 0.5 mm}}", given));
        return all.size() == 1 ? all[0] : testing::PrintToString(all);
    };
    EXPECT_EQ(one("{variant: {sped: slow}}"),
              "folder/s.yaml:10:23: reference.variant: found 'sped', allowed an axis (target.mesh.center, "
              "speed) or a path of the scene, such as "
              "target.mesh.center, did you mean 'speed'?");
    EXPECT_EQ(one("{variant: {speed: slwo}}"),
              "folder/s.yaml:10:30: reference.variant.speed: found 'slwo', allowed one of slow, fast, did "
              "you mean 'slow'?");
    EXPECT_EQ(one("{variant: slwo}"),
              "folder/s.yaml:10:22: reference.variant: found 'slwo', allowed a label that one axis alone has "
              "(2 mm, 500 um, slow, fast), "
              "the name "
              "of a variant, such as 'center=2mm,speed=slow', or a map, such as {time.end: 80 us}, did you "
              "mean 'slow'?");
    EXPECT_EQ(
        one("slow"),
        "folder/s.yaml:10:12: reference: found 'slow', allowed a map with keys variant, closed_form, file");
    EXPECT_EQ(one("{varaint: slow}"),
              "folder/s.yaml:10:13: reference.varaint: found an unknown key, allowed variant, closed_form, "
              "file, did you mean 'variant'?");
}

TEST(StudyFile, ListsInQuotesAreToldSo) {
    const std::string hint = " in quotes, which make it a text (did you mean it without them?), allowed ";
    expect_findings(
        study_with("[outcome, {history: column, norm: max}]\ntolerance: {column_max: 2 %}", "\"[outcome]\""),
        {"folder/s.yaml:11:13: quantities: found '[outcome]'" + hint + "a list"});
    expect_findings(study_with("[2 mm, 500 um]", "'[2 mm, 500 um]'"),
                    {"folder/s.yaml:5:26: variants.0.target.mesh.center: found '[2 mm, 500 um]'" + hint +
                     "a list of values"});
}

TEST(StudyFile, MessagesAreOneLineInWhichAllCanBeSeen) {
    expect_findings(
        study_with("- {target.mesh.center: [2 mm, 500 um]}", "- {\"a\\nb\u00a0\": 2}"),
        {"folder/s.yaml:5:15: variants.0.a<U+000A>b<U+00A0>: found '2', allowed a list of values",
         "folder/s.yaml:9:8: order: found 'target.mesh.center', allowed a<U+000A>b<U+00A0>, speed"});
}

TEST(StudyFile, MergeKeysServeItsSettings) {
    const Study study = parse(study_with("slow: {time.end: 40 us, damping: 3 1/s}",
                                         "slow: &slow {time.end: 40 us, damping: 3 1/s}"));
    const Study merged = parse(
        study_with("slow: {time.end: 40 us, damping: 3 1/s}\n      fast: {fabrics.a.elastic.viscosity: }",
                   "slow: &slow {time.end: 40 us, damping: 3 1/s}\n      fast: {<<: *slow, damping: 4 1/s}"));
    const Case fast = parse_case(merged, scene_text, variants_of(merged)[1]);
    EXPECT_DOUBLE_EQ(fast.scene.time.end, 40e-6);
    EXPECT_DOUBLE_EQ(fast.scene.damping, 4);
    EXPECT_EQ(variants_of(study).size(), 4U);
}

// 10^5 variants took a minute and 10^10 all memory before they were found to be too many.
TEST(Bounds, VariantsAreCountedBeforeTheyAreMade) {
    std::string axes;
    for (int axis = 0; axis < 10; ++axis)
        axes += "  - {a" + std::to_string(axis) + ".b: [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}\n";
    const std::string all = study_text.substr(study_text.find("  - {target"),
                                              study_text.find("order:") - study_text.find("  - {target"));
    EXPECT_EQ(findings(study_with(all, axes)),
              std::vector<std::string>{
                  "folder/s.yaml:5:3: variants: found 10000000000 variants, allowed at most 10000"});
}

TEST(Bounds, NamesOfFoldersFitIntoFileSystems) {
    const std::string label(300, 'x');
    const std::vector<Variant> variants =
        variants_of(parse(study_with("slow: {", label + "1: {time.end: 1 us}\n      " + label + "2: {")));
    EXPECT_LE(variants[0].name.size(), 200U);
    EXPECT_NE(variants[0].name, variants[1].name);
}

}  // namespace
}  // namespace weavefront::scene
