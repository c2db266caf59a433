#include "study_tests.hpp"

namespace weavefront::scene {
namespace {

constexpr std::int64_t most_steps = 100'000'000'000;
constexpr Range part{0, false, 1, " greater than 0 and at most 1"};

YarnTest read_yarn(Section& section) {
    return {.rate = section.quantity("rate", rate, positive),
            .strain = section.quantity("strain", ratio, part),
            .steps = section.count("steps", most_steps)};
}

CellTest read_cell(Section& section, const std::filesystem::path& folder) {
    CellTest test;
    test.path = (folder / section.text("path", {}, "the path of a table of deformations")).lexically_normal();
    if (section.has("refinement")) test.refinement = section.count("refinement", most_steps);
    test.crimp_tolerance = section.quantity("crimp_tolerance", ratio, part, test.crimp_tolerance);
    return test;
}

}  // namespace

Tests read_tests(Section& root, Compute compute, const std::filesystem::path& folder) {
    Tests tests;
    if (compute == Compute::yarn) tests.yarn = root.required("yarn", read_yarn);
    if (compute == Compute::cell)
        tests.cell = root.required("cell", [&](Section& section) { return read_cell(section, folder); });
    return tests;
}

}  // namespace weavefront::scene
