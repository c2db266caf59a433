#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "test_curves.hpp"
#include "weavefront/fabric/cell.hpp"

namespace weavefront::app {

namespace {

/// Rows lie this part of the time apart, so that what decays within few steps shows as well as what takes all
/// of them.
constexpr std::int64_t rows_a_time = 100;

template <fabric::Features F>
TestCurve strain(const fabric::Constants& c, const scene::YarnTest& test) {
    TestCurve curve{CsvTable(yarn_header), test.steps, 0};
    const double increment = test.strain / static_cast<double>(test.steps);
    const fabric::Step step = fabric::step_of(c, F, increment / test.rate);
    double sigma = 0;
    std::vector<std::array<double, 3>> rows{{0, 0, 0}};
    const auto begin = std::chrono::steady_clock::now();
    for (std::int64_t row = 0, last = 0; row < test.steps; row = last) {
        last = std::min(row + std::max<std::int64_t>(1, row / rows_a_time), test.steps);
        for (std::int64_t i = row; i < last; ++i) {
            const double before = c.fill.length * (1 + static_cast<double>(i) * increment);
            const double after = c.fill.length * (1 + static_cast<double>(i + 1) * increment);
            sigma = fabric::axial_law<F>(c.fill, step.fill, sigma, before, 1.0).stress(after);
        }
        const double reached = static_cast<double>(last) * increment;
        rows.push_back({reached / test.rate, reached, sigma});
    }
    curve.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const auto& row : rows) curve.table.add(row);
    return curve;
}

}  // namespace

TestCurve yarn_curve(const scene::Case& variant) {
    scene::Fabric fabric = variant.scene.fabrics.front();
    fabric.warp.reset();  // the curve is that of the fill
    fabric.failure.reset();
    const fabric::Constants constants = fabric::constants_of(fabric);
    fabric::Features features = fabric::features_of(fabric);
    // a yarn by itself is straight, touches nothing, and is followed beyond its failure
    features.crimp = features.lateral = features.friction = features.failure = false;
    return fabric::with_features(features,
                                 [&]<fabric::Features F>() { return strain<F>(constants, variant.yarn); });
}

}  // namespace weavefront::app
