#include "weavefront/fabric/yarn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "chosen_fabric.hpp"
#include "commands.hpp"
#include "csv_table.hpp"
#include "output_file.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {
namespace {

struct Options {
    std::filesystem::path scene, out;
    std::string fabric;
    std::vector<double> rates;
};

/// Where the curve of a yarn ends that nothing breaks.
constexpr double unbroken_strain = 0.05;
constexpr int rows_per_rate = 400;

struct Sampling {
    double increment;  ///< strain of a step: a break is found at most so much late
    int steps;         ///< that no curve exceeds
};

/// eps = eps_a + eps_b, so a yarn breaks before both parts have reached their limits together, if nothing else.
Sampling sampling(const scene::Fabric& fabric) {
    if (!fabric.failure) return {unbroken_strain / 50000, 50000};
    const double smallest = std::min(fabric.failure->static_strain, fabric.failure->hooke_strain);
    const double largest = fabric.failure->static_strain + fabric.failure->hooke_strain;
    const double increment = 2e-5 * smallest;
    return {increment, static_cast<int>(std::ceil(largest / increment)) + 1};
}

/// Strains a yarn from rest at a constant rate and adds its curve to `table`.
template <fabric::Features F>
void strain_at(double rate, const fabric::Constants& c, const Sampling& sample, CsvTable& table) {
    const fabric::Step step = fabric::step_of(c, F, sample.increment / rate);
    const int stride = (sample.steps + rows_per_rate - 3) / (rows_per_rate - 2);
    double sigma = 0;
    table.add(std::array{rate, 0.0, 0.0, 0.0, 0.0});
    for (int i = 1; i <= sample.steps; ++i) {
        const double before = c.length * (1 + (i - 1) * sample.increment), length = c.length * (1 + i * sample.increment);
        sigma = fabric::axial_law<F>(c, step, sigma, before, 1.0).stress(length);
        const double eps = i * sample.increment;
        int failure = 0;
        if constexpr (F.failure) {
            const fabric::FailureIndex<double> index = fabric::failure_index(c, eps, sigma);
            if (std::max(index.primary, index.secondary) > 1) failure = index.primary > index.secondary ? 19 : 20;
        }
        if (i % stride == 0 || i == sample.steps || failure != 0) {
            table.add(std::array{rate, eps / rate, eps, sigma, static_cast<double>(failure)});
        }
        if (failure != 0) return;
    }
}

void require_rates(const std::vector<double>& rates) {
    std::vector<std::string> messages;
    for (const double rate : rates) {
        if (!(rate > 0) || !std::isfinite(rate))
            messages.push_back(fmt::format("--rates: found {}, allowed positive strain rates in 1/s", rate));
    }
    if (!messages.empty()) throw scene::InputError(messages);
}

void yarn(const Options& options) {
    require_rates(options.rates);
    const scene::Fabric fabric = chosen_fabric(options.scene, options.fabric);
    require_output_file("--out", options.out, {options.scene});
    const fabric::Constants constants = fabric::constants_of(fabric);
    const Sampling sample = sampling(fabric);
    // a yarn by itself is straight and touches nothing
    fabric::Features features = fabric::features_of(fabric);
    features.crimp = features.lateral = features.friction = false;
    CsvTable table("rate,time,strain,stress,failure");
    fabric::with_features(features, [&]<fabric::Features F>() {
        for (const double rate : options.rates) strain_at<F>(rate, constants, sample, table);
    });
    table.write(options.out);
}

}  // namespace

void add_yarn(CLI::App& app) {
    auto* command = app.add_subcommand("yarn", "Stress-strain curves of one yarn at constant strain rates, up to its failure");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "Scene file (YAML); only its fabrics are read")->required();
    command->add_option("--rates", options->rates, "Strain rates in 1/s, separated by commas")
        ->required()
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option("--out", options->out,
                     "CSV to write: rate,time,strain,stress,failure; failure is 0, 19 or 20, the equation of the paper that was met; "
                     "a fabric without failure is strained to 5 %")
        ->required();
    command->add_option("--fabric", options->fabric, "Name of the fabric, where the scene has several");
    command->callback([options] { yarn(*options); });
}

}  // namespace weavefront::app
