#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

constexpr int steps = 200;
constexpr double half_wave = std::numbers::pi / 24e-3;  // 1/m: nothing at the edges

/// A stretched and sheared ply that swings between its fixed edges, all of it turned about an axis in space,
/// some steps on. It stays in tension: a membrane under compression is unstable, and wrinkles grow from any
/// rounding.
std::vector<Vec3> evolved(const scene::Scene& scene, const parallel::Communicator& comm,
                          const Eigen::Matrix3d& turn, double& tolerance) {
    Simulation simulation(scene, comm);
    const auto belly = [](const Vec3& x) {
        return std::cos(half_wave * x.x()) * std::cos(half_wave * x.y());
    };
    set_motion(
        simulation,
        [&](const Vec3& x) -> Vec3 {
            return turn * Vec3(1.03 * x.x() + 0.05 * x.y(), 1.02 * x.y(), 1e-3 * belly(x));
        },
        [&](const Vec3& x) -> Vec3 {
            return turn * Vec3(Vec3(10, -5, 60) * (std::abs(belly(x)) > 1e-9 ? belly(x) : 0));
        });
    advance(simulation, steps);
    const auto& model = simulation.model();
    // Each step up to four elements round a nodal force: three corners by half a quantum each, the fourth by
    // three halves. Without any restoring force the errors of all steps would add up to F/m t^2/2; two such
    // runs are compared.
    const double lightest = 204e-3 * 2e-3 * 2e-3 / 4,
                 rounded = std::sqrt(3.0) * 6 * model.assembly.scale().quantum();
    tolerance = 2 * rounded / lightest * simulation.time() * simulation.time() / 2;
    return {model.nodes.x.begin(), model.nodes.x.begin() + model.nodes.count};
}

}  // namespace

TEST(RigidRotation, TurnsTheWholeEvolution) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const std::string formulation : {"consistent", "paper"}) {
        const auto scene = scene_with({"projectile=", "contact=", "target.edges={x: fixed, y: fixed}",
                                       "fabrics.kevlar129.formulation=" + formulation});
        double tolerance = 0;
        const auto plain = evolved(scene, comm, none, tolerance),
                   turned = evolved(scene, comm, turn, tolerance);
        double largest = 0;
        for (std::size_t n = 0; n < plain.size(); ++n)
            largest = std::max(largest, (turn * plain[n] - turned[n]).norm());
        EXPECT_LT(largest, tolerance) << formulation;
        EXPECT_LT(tolerance, 1e-7 * 24e-3);
        RecordProperty(formulation, std::to_string(largest / tolerance));
    }
}

}  // namespace weavefront::solver::test
