#include "step_times.hpp"

#include <chrono>
#include <ctime>

#include "weavefront/solver/simulation.hpp"

namespace weavefront::app {

namespace {

using Clock = std::chrono::steady_clock;

double processor_seconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

StepTime time_step(solver::Simulation& simulation, bool alone) {
    StepTime step{.time = simulation.time()};
    const auto before = simulation.seconds();
    const auto searches = simulation.counts().searches;
    const auto start = Clock::now();
    const double processor = processor_seconds();
    simulation.advance_forces();
    simulation.integrate();
    const double used = processor_seconds() - processor,
                 wall = std::chrono::duration<double>(Clock::now() - start).count();
    step.seconds = alone ? used : wall;
    for (std::size_t p = 0; p < before.size(); ++p)
        step.phases[p] = (simulation.seconds()[p] - before[p]) * step.seconds / wall;
    step.searched = simulation.counts().searches > searches;
    return step;
}

}  // namespace

double StepTimes::mean() const {
    double sum = 0;
    for (const auto& step : steps) sum += step.seconds;
    return sum / static_cast<double>(steps.size());
}

double StepTimes::sum(solver::Phase phase) const {
    double sum = 0;
    for (const auto& step : steps) sum += step.phases[static_cast<std::size_t>(phase)];
    return sum;
}

void StepTimes::improve_by(const StepTimes& other) {
    for (std::size_t s = 0; s < steps.size(); ++s)
        if (other.steps[s].seconds < steps[s].seconds) steps[s] = other.steps[s];
}

StepTimes time_steps(const scene::Scene& scene, const parallel::Communicator& comm) {
    solver::Simulation simulation(scene, comm);
    StepTimes times{.elements = static_cast<std::int64_t>(simulation.model().slots.size()),
                    .nodes = simulation.model().nodes.count};
    while (simulation.time() < scene.time.end) times.steps.push_back(time_step(simulation, comm.size() == 1));
    return times;
}

}  // namespace weavefront::app
