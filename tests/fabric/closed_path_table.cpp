/// Prints closed_path.md: what closed paths leave, in both formulations.

#include <fmt/format.h>

#include <limits>
#include <string>

#include "closed_paths.hpp"

namespace weavefront::test {
namespace {

constexpr int per_leg = 8000;

constexpr fabric::Features with(scene::Formulation formulation, bool lateral = false, bool friction = false) {
    return {.formulation = formulation, .crimp = true, .lateral = lateral, .friction = friction};
}

scene::Fabric of_thickness(double thickness) {
    scene::Fabric fabric = elastic_kevlar129();
    fabric.thickness = thickness;
    return fabric;
}

std::string percent(double value) {
    if (std::abs(value) < 5e-8) return "0";
    return std::abs(value) < 0.1 ? fmt::format("{:+.2g} %", value * 100)
                                 : fmt::format("{:+.0f} %", value * 100);
}

template <bool lateral = false, bool friction = false>
void print_path(const std::string& name, const Polygon& path, int cycles = 1) {
    const auto fabric = elastic_kevlar129();
    const int steps = per_leg * path.legs();
    const double peak = walk<with(consistent, lateral, friction)>(fabric, path, steps).peak;
    fmt::print("| {} | {} | {} |\n", name,
               percent(walk<with(consistent, lateral, friction)>(fabric, path, steps, cycles).left / peak),
               percent(walk<with(paper, lateral, friction)>(fabric, path, steps, cycles).left / peak));
}

/// The least and the most that random polygons leave.
struct Range {
    double least = std::numeric_limits<double>::max(), most = -least;
    void include(double value) { least = std::min(least, value), most = std::max(most, value); }
    [[nodiscard]] double largest() const { return std::max(-least, most); }
};

/// @tparam F what to walk with; @tparam ours what its largest work is taken from
template <fabric::Features F, fabric::Features ours>
Range left_by_random_paths(const scene::Fabric& fabric, double shortest, int paths, int steps_a_leg) {
    std::mt19937_64 random(13);
    Range range;
    for (int n = 0; n < paths; ++n) {
        const Polygon path(random, shortest, 1.08, 43 * degree);
        const int steps = steps_a_leg * path.legs();
        const auto reference = walk<ours>(fabric, path, steps);
        range.include((F == ours ? reference : walk<F>(fabric, path, steps)).left / reference.peak);
    }
    return range;
}

void print_order() {
    double last = 0;
    for (int steps = 50; steps <= 800; steps *= 2) {
        const double largest =
            left_by_random_paths<with(consistent), with(consistent)>(elastic_kevlar129(), 0.97, 1000, steps)
                .largest();
        fmt::print("| {} | {:.2e} | {} |\n", steps, largest,
                   last > 0 ? fmt::format("{:.3f}", std::log2(last / largest)) : "");
        last = largest;
    }
}

template <bool lateral, bool friction>
void print_random(const std::string& name, double thickness = 0.82e-3, double shortest = 0.97) {
    constexpr auto consistently = with(consistent, lateral, friction),
                   as_printed = with(paper, lateral, friction);
    const auto ours =
        left_by_random_paths<consistently, consistently>(of_thickness(thickness), shortest, 10000, 200);
    const auto printed =
        left_by_random_paths<as_printed, consistently>(of_thickness(thickness), shortest, 10000, 200);
    fmt::print("| {} | {} | {} | {} | {} |\n", name, percent(ours.least), percent(ours.most),
               percent(printed.least), percent(printed.most));
}

void print_page() {
    fmt::print(R"(# Energy over closed paths

Made by `closed_path_table` (`build/release/tests/fabric/closed_path_table > tests/fabric/closed_path.md`). Do not edit.

Kevlar 129 without viscosity (t = 0.82 mm unless stated), one material point from rest back to rest. Below zero the cell has **given** energy that nobody put in;
above, it has taken some.

## Elastic yarns, open trellis: order of what is left

The largest |work left| over the largest work on the way, of 1000 random paths: four corners, stretches 0.97 to 1.08, turns up to 43 deg either way.
Consistent formulation; `fabric` asserts the order.

| steps a leg | left | order |
|---|---|---|
)");
    print_order();
    fmt::print(R"(
## Paths walked corner by corner

Work left over the largest work that the consistent formulation needs in the first cycle; {} steps a leg.

| path | consistent | paper |
|---|---|---|
)",
               per_leg);
    print_path("elastic: stretch both 4 %, turn by 20 deg, release, turn back",
               stretch_shear_release_unshear());
    print_path("elastic: the same backwards", shear_stretch_unshear_release());
    print_path(
        "elastic: crimp interchange, fill pulled out by 10 %, warp shortened by 5 %, fill back, warp back",
        crimp_interchange());
    print_path("elastic: the same backwards", crimp_interchange_backwards());
    print_path<true>("packing: stretch both 2 %, turn by 40 deg, release, turn back",
                     stretch_lock_release_unlock());
    print_path<true>("packing: the same 10 times", stretch_lock_release_unlock(), 10);
    print_path<false, true>("friction: stretch both 4 %, turn by 20 deg, release, turn back",
                            stretch_shear_release_unshear());
    print_path<false, true>("friction: the same backwards", shear_stretch_unshear_release());
    fmt::print(R"(
## 10^4 random paths

The least and the most that a path leaves, over the largest work of the consistent formulation, with 200 steps a leg. What is below
zero in the consistent formulation is the trapezoidal rule's error: `fabric` asserts, path by path at t = 0.82 mm, that it is not more than the difference
to half the steps.

| | consistent, least | most | paper, least | most |
|---|---|---|---|---|
)");
    print_random<false, false>("elastic, open trellis");
    print_random<true, false>("packing");
    print_random<false, true>("friction");
    print_random<true, true>("packing and friction");
    print_random<false, false>("elastic, t = 0.2 mm, in tension (stretches 1 to 1.08)", 0.2e-3, 1);
    print_random<false, false>("elastic, t = 0.2 mm, compressed (0.97 to 1.08)", 0.2e-3);
    fmt::print(R"(
Yarns of little crimp buckle when their bars are compressed by more than about $(t/(2s))^2$: the crossover then has two stable heights, and where
one of them ceases to exist it snaps to the other. What the snap sets free is taken. In a yarn in tension the height is unique.
)");
}

}  // namespace
}  // namespace weavefront::test

int main() { weavefront::test::print_page(); }
