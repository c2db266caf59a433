#include "weavefront/fabric/yarn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "chosen_fabric.hpp"
#include "commands.hpp"
#include "csv_table.hpp"
#include "launcher.hpp"
#include "list_option.hpp"
#include "output_file.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {
namespace {

/// Where the curve of a yarn ends that nothing breaks.
constexpr double unbroken_strain = 0.05;
constexpr int rows_per_rate = 400, least_rows = 100;

struct Sampling {
    double increment;    ///< strain of a step: a break is found at most so much late
    std::int64_t steps;  ///< that no curve exceeds
};

// A curve of so many steps takes some seconds.
constexpr double most_steps = 1e8;

/// eps = eps_a + eps_b, so a yarn breaks before both parts have reached their limits together, if nothing
/// else.
Sampling sampling(const scene::Fabric& fabric) {
    if (!fabric.failure) return {unbroken_strain / 50000, 50000};
    const double smallest = std::min(fabric.failure->static_strain, fabric.failure->hooke_strain);
    const double largest = fabric.failure->static_strain + fabric.failure->hooke_strain;
    const double increment = 2e-5 * smallest, steps = std::ceil(largest / increment) + 1;
    if (!(steps <= most_steps))
        throw scene::InputError({fmt::format(
            "fabric {}: found failure strains (static_strain, hooke_strain) of {:.4g} and {:.4g}, which take "
            "{:.3g} steps to "
            "tell apart, allowed {:.3g}",
            fabric.name, fabric.failure->static_strain, fabric.failure->hooke_strain, steps, most_steps)});
    return {increment, static_cast<std::int64_t>(steps)};
}

struct Point {
    std::int64_t step;
    double strain, stress;
    int failure;  ///< 0, 19 or 20
};

/// Strains a yarn from rest at a constant rate up to its failure, or to the last step. @param note is given
/// each point
template <fabric::Features F, class Note>
void follow(double rate, const fabric::Constants& c, const Sampling& sample, Note note) {
    const fabric::Step step = fabric::step_of(c, F, sample.increment / rate);
    double sigma = 0;
    for (std::int64_t i = 1; i <= sample.steps; ++i) {
        const double eps = static_cast<double>(i) * sample.increment;
        const double before = c.fill.length * (1 + static_cast<double>(i - 1) * sample.increment),
                     length = c.fill.length * (1 + eps);
        sigma = fabric::axial_law<F>(c.fill, step.fill, sigma, before, 1.0).stress(length);
        int failure = 0;
        if constexpr (F.failure) {
            const fabric::FailureIndex<double> index = fabric::failure_index(c.fill, eps, sigma);
            if (std::max(index.primary, index.secondary) > 1)
                failure = index.primary > index.secondary ? 19 : 20;
        }
        note(Point{i, eps, sigma, failure});
        if (failure != 0) return;
    }
}

/// Adds the curve of a yarn to `table`: some hundred rows, the last one that of its failure.
template <fabric::Features F>
void strain_at(double rate, const fabric::Constants& c, const Sampling& sample, CsvTable& table) {
    std::int64_t last = 0;
    follow<F>(rate, c, sample, [&](const Point& point) { last = point.step; });
    const std::int64_t usual = (sample.steps + rows_per_rate - 3) / (rows_per_rate - 2);
    const std::int64_t stride = std::clamp<std::int64_t>(
        last / least_rows, 1, usual);  // a yarn may break far below what none exceeds
    const std::string cause = fmt::format("--rates {}", rate);
    table.add(std::array{rate, 0.0, 0.0, 0.0, 0.0});
    follow<F>(rate, c, sample, [&](const Point& point) {
        if (point.step % stride == 0 || point.step == last)
            table.add(std::array{rate, point.strain / rate, point.strain, point.stress,
                                 static_cast<double>(point.failure)},
                      cause);
    });
}

/// The fabric with both yarns as its fill or its warp. @param yarn `fill` or `warp`
scene::Fabric with_equal_yarns(scene::Fabric fabric, const std::string& yarn) {
    if (yarn != "fill" && yarn != "warp")
        throw scene::InputError(
            {fmt::format("--yarn: found '{}', allowed fill or warp", scene::printable(yarn))});
    if (fabric.warp && yarn == "warp") {
        const auto& warp = *fabric.warp;
        fabric.yarn = warp.yarn;
        fabric.elastic = warp.elastic;
        if (fabric.failure) {
            fabric.failure->static_strain = warp.strength.static_strain;
            fabric.failure->hooke_strain = warp.strength.hooke_strain;
        }
    }
    fabric.warp.reset();
    if (fabric.failure) fabric.failure->scatter.reset();  // the curve of a yarn of the mean strength
    return fabric;
}

std::vector<double> read_rates(const std::string& list) {
    std::vector<double> rates;
    scene::MessageList faults;
    for (const std::string& text : items_of(list)) {
        const auto rate = scene::finite_number(text);
        if (!rate || !(*rate > 0))
            faults.add(
                fmt::format("--rates: found '{}', allowed positive strain rates in 1/s, such as 1,10,100",
                            scene::printable(text)));
        rates.push_back(rate.value_or(0));
    }
    faults.raise();
    return rates;
}

}  // namespace

void yarn(const YarnOptions& options) {
    if (!is_first_process()) return;
    const std::vector<double> rates = read_rates(options.rates);
    const scene::Fabric fabric =
        with_equal_yarns(chosen_fabric(options.scene, options.overrides, options.fabric), options.yarn);
    require_output_file("--out", options.out, {options.scene});
    const fabric::Constants constants = fabric::constants_of(fabric);
    const Sampling sample = sampling(fabric);
    // a yarn by itself is straight and touches nothing
    fabric::Features features = fabric::features_of(fabric);
    features.crimp = features.lateral = features.friction = false;
    CsvTable table("rate,time,strain,stress,failure");
    fabric::with_features(features, [&]<fabric::Features F>() {
        for (const double rate : rates) strain_at<F>(rate, constants, sample, table);
    });
    table.write(options.out);
}

}  // namespace weavefront::app
