#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

constexpr double length = 40e-3;  // of the strip, m

/// Speed of longitudinal waves in a strip of straight yarns, from its first standing wave.
double wave_speed(const parallel::Communicator& comm, const std::string& element,
                  const std::string& viscosity) {
    const auto scene =
        scene_with({"projectile=", "contact=", "target.size=[40 mm, 8 mm]", "target.mesh.center=" + element,
                    "fabrics.kevlar129.thickness=0", "fabrics.kevlar129.elastic.viscosity=" + viscosity});
    Simulation simulation(scene, comm);
    constexpr double k = std::numbers::pi / length, amplitude = 1e-3;  // 1/m, m/s: strains of 1e-7
    const auto mode = [](const Vec3& x) { return std::sin(k * x.x()); };
    set_motion(
        simulation, [](const Vec3& x) { return x; },
        [&](const Vec3& x) { return Vec3(amplitude * mode(x), 0, 0); });
    const auto& nodes = simulation.model().nodes;
    const auto part = [&] {
        return sum_over_nodes(simulation, comm, 0.0, [&](std::size_t n) {
            return nodes.mass[n] * nodes.v[n].x() * mode(nodes.initial[n]);
        });
    };
    // Of a harmonic motion with equal steps, (v(t - dt) + v(t + dt))/(2 v(t)) = cos(omega dt).
    advance(simulation, 1);
    const double first = part();
    advance(simulation, 1);
    const double second = part();
    advance(simulation, 1);
    const double third = part();
    return std::acos((first + third) / (2 * second)) / simulation.time_step() / k;
}

}  // namespace

// The error of the mesh and of the step is (k h)^2/24 (1 - C^2) at a Courant number C <= 0.9: below 2e-3 of
// the speed at 10 elements, and a quarter of that at 20.
TEST(LongitudinalWave, RunsAtTheSpeedOfTheYarnsToSecondOrder) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const double per_modulus = 6.48e-8 / 0.909e-3 / 0.204;  // S/(s t_e rho)
    // 1e6 MPa s: relaxes within seconds, the wave takes microseconds.
    for (const auto& [viscosity, modulus] : {std::pair{"0", 96e9}, std::pair{"1e6 MPa s", 192e9}}) {
        const double exact = std::sqrt(modulus * per_modulus);
        const double coarse = wave_speed(comm, "4 mm", viscosity) / exact - 1,
                     fine = wave_speed(comm, "2 mm", viscosity) / exact - 1;
        EXPECT_LT(std::abs(coarse), 2e-3) << modulus;
        EXPECT_NEAR(coarse / fine, 4, 0.1) << modulus;
    }
}

}  // namespace weavefront::solver::test
