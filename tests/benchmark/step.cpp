/// Takes steps of a scene, by the product's time loop or by the textbook's, and prints what they cost as
/// JSON: of all ranks, a step as long as on the rank on which it takes longest.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>

#include "allocations.hpp"
#include "textbook_step.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/solver/simulation.hpp"

// Not mangled and never inlined: Callgrind collects between its entry and its exit
// (--toggle-collect=measured_steps).
extern "C" [[gnu::noinline]] void measured_steps(const std::function<void()>& step,
                                                 std::span<double> seconds) {
    for (auto& of_step : seconds) {
        const auto start = std::chrono::steady_clock::now();
        step();
        of_step = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
}

namespace weavefront::benchmark {
namespace {

struct Options {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
    int warm_up = 20, steps = 200;
    double speed = 100;
    bool textbook = false, check = false;
};

/// What the measured steps took and left.
struct Cost {
    std::vector<double> seconds;  ///< of each step
    std::int64_t allocations = 0, elements = 0;
    std::int64_t bytes = 0;  ///< of the heap, at the end
    std::vector<Vec3> positions;
};

/// The first ply dishes towards the second, fastest in the middle: every element stretches, shears and turns,
/// and plies meet.
void set_in_motion(solver::Model& model, const parallel::Communicator& comm, double speed) {
    auto& nodes = model.nodes;
    double reach = 0;
    for (const auto& x : nodes.x) reach = std::max({reach, std::abs(x.x()), std::abs(x.y())});
    reach = comm.max(reach);
    for (std::size_t n = 0; n < nodes.x.size(); ++n) {
        const double across = std::cos(std::numbers::pi / 2 * nodes.x[n].x() / reach) *
                              std::cos(std::numbers::pi / 2 * nodes.x[n].y() / reach);
        const double sideways = std::sin(std::numbers::pi * nodes.x[n].y() / reach) / 4;
        if (nodes.x[n].z() == 0) nodes.v[n] = speed * Vec3(sideways, 0, across);
    }
}

template <class Stepper>
Cost cost_of(Stepper& stepper, const std::function<void()>& step, const parallel::Communicator& comm,
             const Options& options, std::size_t held_before) {
    set_in_motion(stepper.model(), comm, options.speed);
    for (int n = 0; n < options.warm_up; ++n) step();
    Cost cost;
    cost.seconds.resize(static_cast<std::size_t>(options.steps));
    const auto allocated = allocations();
    measured_steps(step, cost.seconds);
    cost.allocations = allocations() - allocated;
    cost.bytes = static_cast<std::int64_t>(bytes_held() - held_before);
    const auto& model = stepper.model();
    cost.elements = static_cast<std::int64_t>(model.slots.size());
    cost.positions.assign(model.nodes.x.begin(), model.nodes.x.begin() + model.nodes.count);
    return cost;
}

Cost measure(const scene::Scene& scene, const parallel::Communicator& comm, const Options& options,
             bool textbook) {
    const auto held = bytes_held();
    if (textbook) {
        TextbookStep stepper(scene, comm);
        return cost_of(
            stepper, [&stepper] { stepper.advance(); }, comm, options, held);
    }
    solver::Simulation simulation(scene, comm);
    const auto step = [&simulation] {
        simulation.advance_forces();
        simulation.integrate();
    };
    return cost_of(simulation, step, comm, options, held);
}

bool same_bits(const std::vector<Vec3>& one, const std::vector<Vec3>& other) {
    return one.size() == other.size() &&
           std::memcmp(one.data(), other.data(), one.size() * sizeof(Vec3)) == 0;
}

nlohmann::json report(const Cost& cost, const Options& options) {
    const double seconds = std::accumulate(cost.seconds.begin(), cost.seconds.end(), 0.0);
    return {{"elements", cost.elements},
            {"steps", options.steps},
            {"seconds", cost.seconds},
            {"nanoseconds", seconds * 1e9 / static_cast<double>(cost.elements * options.steps)},
            {"bytes", static_cast<double>(cost.bytes) / static_cast<double>(cost.elements)},
            {"allocations", cost.allocations}};
}

/// The product against the textbook on a scene with nothing optional in it. @return exit status
int check(const scene::Scene& scene, const parallel::Communicator& comm, const Options& options) {
    const auto product = measure(scene, comm, options, false), textbook = measure(scene, comm, options, true);
    const bool same = same_bits(product.positions, textbook.positions), free = product.allocations == 0;
    fmt::print("{} steps of {} elements: {} allocations, positions {}\n", options.steps, product.elements,
               product.allocations, same ? "of the same bits" : "differ");
    return same && free ? 0 : 1;
}

int run(const Options& options) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto scene =
        scene::parse_scene(scene::read_text(options.scene), options.scene.string(), options.overrides);
    if (options.check) return check(scene, comm, options);
    auto cost = measure(scene, comm, options, options.textbook);
    comm.max(cost.seconds);
    std::array sums{cost.elements, cost.bytes, cost.allocations};
    comm.sum(sums);
    std::tie(cost.elements, cost.bytes, cost.allocations) = std::tuple_cat(sums);
    if (comm.rank() == 0) fmt::print("{}\n", report(cost, options).dump());
    return 0;
}

}  // namespace
}  // namespace weavefront::benchmark

int main(int argc, char** argv) {
    CLI::App app{"Cost of the step"};
    weavefront::benchmark::Options options;
    app.add_option("SCENE", options.scene, "Scene file")->required();
    app.add_option("--set", options.overrides, "PATH=VALUE; may be given several times")
        ->allow_extra_args(false);
    app.add_option("--warm-up", options.warm_up, "Steps before the measured ones");
    app.add_option("--steps", options.steps, "Steps to measure");
    app.add_option("--speed", options.speed, "Of the middle of the first ply at the start, m/s");
    app.add_flag("--textbook", options.textbook, "The step without the solver's optional features");
    app.add_flag("--check", options.check, "Compare both: same bits, nothing allocated");
    CLI11_PARSE(app, argc, argv);
    return weavefront::benchmark::run(options);
}
