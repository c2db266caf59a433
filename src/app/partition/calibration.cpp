#include "calibration.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <span>

#include "cpu_speed.hpp"
#include "spread_ranks.hpp"
#include "weavefront/mesh/panel.hpp"
#include "weavefront/parallel/exchange.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/partition/forecast.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/nodes.hpp"

namespace weavefront::app {

namespace {

using Clock = std::chrono::steady_clock;
using partition::Machine;
using solver::Phase;

[[noreturn]] void refuse(const std::string& what) { throw scene::InputError({"--calibrate: " + what}); }

/// What contact has to do in the steps of a run.
struct ContactLoad {
    double pressed = 0;           ///< elements that are pressed together, as much as they are
    std::vector<double> in_zone;  ///< elements within the zone at the start of each step
};

ContactLoad contact_load(const scene::Scene& scene, const StepTimes& times) {
    const auto panel = mesh::make_panel(scene);
    const partition::ContactZone zone(scene);
    auto distances = zone.distances(panel);
    std::ranges::sort(distances);
    const auto plies = static_cast<double>(panel.plies.size());
    ContactLoad load;
    for (const double distance : distances) load.pressed += plies * zone.press_weight(distance);
    for (const auto& step : times.steps) {
        const auto columns = std::ranges::lower_bound(distances, zone.radius(step.time)) - distances.begin();
        load.in_zone.push_back(static_cast<double>(columns) * plies);
    }
    return load;
}

/// Means over some steps of the time of contact, s, and of the elements in the zone.
struct Means {
    double contact = 0, in_zone = 0;
};

Means means_of(const StepTimes& times, std::span<const double> in_zone, std::size_t first, std::size_t end) {
    Means means;
    for (std::size_t s = first; s < end; ++s) {
        means.in_zone += in_zone[s] / static_cast<double>(end - first);
        means.contact += times.steps[s].contact() / static_cast<double>(end - first);
    }
    return means;
}

/// Least squares of contact, less what watching takes, over the pressed elements and over those in the zone
/// with a weight that declines linearly over the run.
void fit_touch(const scene::Scene& scene, const StepTimes& times, const ContactLoad& load, Machine& machine) {
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Vec3 with_contact = Vec3::Zero(), sums = Vec3::Zero();
    double contact = 0;
    for (std::size_t s = 0; s < times.steps.size(); ++s) {
        const auto& step = times.steps[s];
        const Vec3 counts(load.pressed, load.in_zone[s], -load.in_zone[s] * step.time / scene.time.end);
        const double y = step.contact() - machine.watch * static_cast<double>(times.elements);
        products += counts * counts.transpose();
        with_contact += y * counts;
        sums += counts;
        contact += y;
    }
    const Vec3 fit = products.ldlt().solve(with_contact);
    machine.press = std::max(0.0, fit[0]);
    machine.decay = fit[1] > 0 ? std::clamp(fit[2] / fit[1], 0.0, 1.0) : 0;
    // Right in the mean over the run also where a bound was met.
    machine.touch = std::max(0.0, (contact - machine.press * sums[0]) / (sums[1] + machine.decay * sums[2]));
}

/// Over the first hundredth of the run plies are but watched.
void fit_contact(const scene::Scene& scene, const StepTimes& times, Machine& machine) {
    const auto load = contact_load(scene, times);
    const auto steps = load.in_zone.size();
    // The first step allocates.
    const auto early = means_of(times, load.in_zone, 1, 2 + steps / 100),
               whole = means_of(times, load.in_zone, 0, steps);
    const auto elements = static_cast<double>(times.elements);
    if (!(whole.in_zone - early.in_zone > 0.05 * elements))
        refuse(
            fmt::format("contact reaches {:.2g} % of the elements in the mean over the run, allowed are at "
                        "least 5 %: a later time.end",
                        100 * whole.in_zone / elements));
    // The zone is small at first: a few rounds settle what is watched and what touches.
    for (int round = 0; round < 5; ++round) {
        machine.watch = std::max(0.0, (early.contact - machine.touch * early.in_zone) / elements);
        fit_touch(scene, times, load, machine);
    }
}

void fit_steps(const scene::Scene& scene, const StepTimes& times, Machine& machine) {
    const auto steps = static_cast<double>(times.steps.size()),
               elements = static_cast<double>(times.elements);
    const auto searches = static_cast<double>(std::ranges::count(times.steps, true, &StepTime::searched));
    if (times.steps.size() < 100)
        refuse(fmt::format("the run has {} steps, allowed are at least 100", times.steps.size()));
    if (searches == 0) refuse("nothing had to be looked for anew up to time.end; allowed is a longer run");
    fit_contact(scene, times, machine);
    machine.element = times.sum(Phase::elements) / (steps * elements);
    machine.search = times.sum(Phase::search) / (searches * elements);
    machine.searches_per_step = 1;
    machine.searches_per_step = searches / steps / partition::renewals(scene, machine);
    const double rest = times.mean() * steps - times.sum(Phase::elements) - times.sum(Phase::contact) -
                        times.sum(Phase::search);
    machine.node = rest / (steps * static_cast<double>(times.nodes));
}

/// Least time of one call over batches of calls that all ranks begin together, the most of the ranks, s.
/// @note Collective
template <class Call>
double least_time(const parallel::Communicator& comm, Call call) {
    constexpr int batches = 200, calls = 20;
    double least = std::numeric_limits<double>::max();
    for (int batch = 0; batch < batches; ++batch) {
        parallel::check(MPI_Barrier(comm.get()));
        const auto start = Clock::now();
        for (int i = 0; i < calls; ++i) call();
        least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count() / calls);
    }
    return comm.max(least);
}

/// Time of an exchange with the rank half of all ranks away, in both directions at once. @param nodes shared
double exchange_time(const parallel::Communicator& comm, std::int32_t nodes) {
    const int half = comm.size() / 2, other = comm.rank() < half ? comm.rank() + half : comm.rank() - half;
    std::vector<parallel::Neighbour> neighbours;
    std::vector<std::int32_t> all(static_cast<std::size_t>(nodes));
    std::iota(all.begin(), all.end(), 0);
    if (comm.rank() < 2 * half) neighbours.emplace_back(other, all);
    parallel::SharedMemoryExchange shared_memory(comm);
    parallel::Exchange<solver::FixedVector> exchange(std::move(neighbours));
    exchange.use(comm, shared_memory);
    std::vector<solver::FixedVector> values(static_cast<std::size_t>(nodes));
    return least_time(comm, [&] { exchange.sum(comm, values); });
}

void time_messages(const parallel::Communicator& comm, Machine& machine) {
    constexpr std::int32_t many = 4000;  // about what a rank of some ten thousand elements exchanges
    machine.latency = exchange_time(comm, 1);
    machine.bandwidth =
        many * sizeof(solver::FixedVector) / std::max(exchange_time(comm, many) - machine.latency, 1e-9);
    std::array<std::int64_t, 6> values{};
    machine.reduction = least_time(comm, [&] { comm.sum(values); }) / std::ceil(std::log2(comm.size()));
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

}  // namespace

void require_calibration(const scene::Scene& scene, int ranks) {
    if (ranks < 2)
        refuse(
            "found 1 rank, allowed are 2 or more: mpirun -n N weavefront partition SCENE --calibrate FILE");
    if (scene.projectiles.empty() || !scene.contact.plies || scene.target->plies.size() < 2)
        refuse("allowed is a scene with a projectile and contact between plies");
}

Machine calibrate(const scene::Scene& scene, const parallel::Communicator& comm, int repetitions) {
    const parallel::Communicator self(MPI_COMM_SELF);
    Machine machine{.name = fmt::format("{}, {} ranks", processor(), comm.size()), .ranks = comm.size()};
    RepeatedSteps alone;
    compute_apart(comm, comm.rank() == 0, [&] { alone = repeat_steps(scene, self, self, repetitions); });
    const auto together = repeat_steps(scene, self, comm, repetitions);
    const double slowest = comm.max(together.times.mean());
    parallel::meet(comm);
    time_messages(comm, machine);
    const auto fault = parallel::failure_on_root(comm, [&] {
        machine.reference_time = alone.reference_time;
        machine.crowding =
            std::max(1.0, slowest / together.reference_time / (alone.times.mean() / alone.reference_time));
        fit_steps(scene, alone.times, machine);
    });
    if (!fault.empty()) throw scene::InputError({fault});
    return machine;
}

}  // namespace weavefront::app
