#include <array>
#include <chrono>
#include <limits>
#include <vector>

#include "deformation_path.hpp"
#include "test_curves.hpp"
#include "weavefront/fabric/cell.hpp"

namespace weavefront::app {

namespace {

using Seconds = std::chrono::duration<double>;

/// The crimp equilibrium to any tolerance, with its evaluations counted.
struct CountedSearch {
    double part;  ///< of t/2
    int* evaluations;
    [[nodiscard]] double tolerance() const { return part; }
    void count(int evaluated) const { *evaluations += evaluated; }
};

Deformation between(const Deformation& a, const Deformation& b, double share) {
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    return {mix(a.time, b.time), mix(a.F11, b.F11), mix(a.F12, b.F12), mix(a.F21, b.F21), mix(a.F22, b.F22)};
}

std::vector<Deformation> refined(const std::vector<Deformation>& rows, std::int64_t refinement) {
    std::vector<Deformation> steps{rows.front()};
    for (std::size_t i = 1; i < rows.size(); ++i)
        for (std::int64_t k = 1; k <= refinement; ++k)
            steps.push_back(
                between(rows[i - 1], rows[i], static_cast<double>(k) / static_cast<double>(refinement)));
    return steps;
}

/// One pass through the path; `note(i, state, response, evaluations)` after each step.
template <fabric::Features F, class Note>
void pass(const fabric::Constants& c, const std::vector<Deformation>& steps, double tolerance, Note note) {
    fabric::State<double> state = fabric::initial_state<F, double>(c);
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const Deformation& d = steps[i];
        const fabric::Step step = fabric::step_of(c, F, d.time - steps[i - 1].time);
        const Kinematics k = kinematics(d);
        int evaluations = 0;
        const CountedSearch search{tolerance, &evaluations};
        const auto response =
            fabric::advance<F>(c, step, state, k.lambda_f, k.lambda_w, k.cos_2theta, search);
        note(i, state, response, evaluations);
    }
}

/// The shortest of the passes that a fifth of a second has room for, at least two: what a pass takes when
/// nothing disturbs it.
template <fabric::Features F>
double shortest_pass(const fabric::Constants& c, const std::vector<Deformation>& steps, double tolerance) {
    double shortest = std::numeric_limits<double>::max(), sum = 0;
    [[maybe_unused]] volatile double kept = 0;  // so that no pass is left out as useless
    for (int passes = 0; passes < 2 || sum < 0.2; ++passes) {
        const auto begin = std::chrono::steady_clock::now();
        pass<F>(c, steps, tolerance,
                [&](std::size_t, const auto&, const auto& response, int) { kept = response.T_xx; });
        const double seconds = Seconds(std::chrono::steady_clock::now() - begin).count();
        shortest = std::min(shortest, seconds);
        sum += seconds;
    }
    return shortest;
}

template <fabric::Features F>
TestCurve deform(const fabric::Constants& c, const std::vector<Deformation>& steps,
                 const scene::CellTest& test) {
    TestCurve curve{CsvTable(cell_header), static_cast<std::int64_t>(steps.size()) - 1, 0};
    const fabric::State<double> start = fabric::initial_state<F, double>(c);
    curve.table.add(std::array{steps.front().time, start.h_f, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    double evaluations = 0;
    pass<F>(c, steps, test.crimp_tolerance,
            [&](std::size_t i, const auto& state, const auto& response, int evaluated) {
                evaluations += evaluated;
                if (i % static_cast<std::size_t>(test.refinement) != 0) return;
                const fabric::YarnState<double> yarns = fabric::yarn_state<F>(c, state);
                const double thickness = c.effective_thickness;
                curve.table.add(std::array{steps[i].time, state.h_f, yarns.sigma_f, yarns.sigma_w,
                                           response.T_xx / thickness, response.T_yy / thickness,
                                           response.T_xy / thickness, evaluations / static_cast<double>(i)});
            });
    curve.seconds = shortest_pass<F>(c, steps, test.crimp_tolerance);
    return curve;
}

}  // namespace

TestCurve cell_curve(const scene::Case& variant) {
    const scene::Fabric& fabric = variant.scene.fabrics.front();
    const std::vector<Deformation> steps =
        refined(read_deformation_path(variant.cell.path), variant.cell.refinement);
    const fabric::Constants constants = fabric::constants_of(fabric);
    return fabric::with_features(fabric::features_of(fabric), [&]<fabric::Features F>() {
        return deform<F>(constants, steps, variant.cell);
    });
}

}  // namespace weavefront::app
