#include "cpu_speed.hpp"

#include <algorithm>

#include "weavefront/parallel/failure.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

/// The paper's fabric in a scene that is always the same: a thousand elements, which stay in the processor's
/// own caches.
constexpr auto scene_text = R"(
title: reference step
fabrics:
  kevlar129:
    areal_density: 204 g/m^2
    density: 1440 kg/m^3
    yarn: {span: 0.909 mm, area: 6.48e-2 mm^2, width: 0.32 mm}
    thickness: 0.82 mm
    elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa, viscosity: 35 MPa s}
    failure: {static_strain: 3.3 %, hooke_strain: 2.7 %}
    lateral: {modulus: 7.4 GPa, shear_modulus: 2.5 GPa, locking_angle: 35 deg, transition: 3 deg}
    friction: 0.11
    transverse_shear: 2.5 GPa
target:
  size: [64 mm, 64 mm]
  plies: {count: 1, fabric: kevlar129, gap: 0}
  mesh: {center: 1 mm}
  symmetry: [x, y]
projectile: {shape: sphere, diameter: 6 mm, mass: 1 g, velocity: [0, 0, 100 m/s]}
contact: {projectile: {}}
time: {end: 10 us}
output: {interval: 0, history: 10 us}
)";
constexpr int runs = 10;

/// Processor time of an element-step of that scene on the calling rank, s. Processors that share power or
/// cores with others change their speed from minute to minute, and with it all of a step.
double measured_reference_time() {
    static const auto scene = scene::parse_scene(scene_text, "reference step");
    const parallel::Communicator self(MPI_COMM_SELF);
    double sum = 0;
    for (int run = 0; run < runs; ++run) {
        const auto times = time_steps(scene, self);
        sum += times.mean() / static_cast<double>(times.elements);
    }
    return sum / runs;
}

}  // namespace

RepeatedSteps repeat_steps(const scene::Scene& scene, const parallel::Communicator& comm,
                           const parallel::Communicator& all, int repetitions) {
    RepeatedSteps repeated;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        if (all.rank() == 0)
            repeated.reference_time = std::min(repeated.reference_time, measured_reference_time());
        parallel::meet(all);
        auto times = time_steps(scene, comm);
        if (repetition == 0)
            repeated.times = std::move(times);
        else
            repeated.times.improve_by(times);
    }
    return repeated;
}

}  // namespace weavefront::app
