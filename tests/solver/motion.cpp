/// Nodes moved eight at a time: the bits of one at a time.

#include "weavefront/solver/motion.hpp"

#include <gtest/gtest.h>

#include <random>

namespace weavefront::test {
namespace {

constexpr double step = 1.3e-7, dt = 1.1e-7;

solver::Nodes random_nodes(std::int32_t count, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    solver::Nodes nodes;
    nodes.count = count;
    for (std::int32_t n = 0; n < count + 2; ++n) {  // and two ghosts
        nodes.x.push_back(vector());
        nodes.v.push_back(100 * vector());
        nodes.mass.push_back(1e-7 * (1 + std::abs(normal(random))));
        const auto force = [&] { return static_cast<std::int64_t>(random()) >> random() % 64; };
        nodes.force.push_back({force(), force(), force()});
    }
    return nodes;
}

TEST(Motion, MovesEveryNodeAsIfAlone) {
    const parallel::FixedPoint scale(3000);
    std::mt19937_64 random(8);
    for (std::int32_t count = 0; count < 40; ++count) {
        auto nodes = random_nodes(count, random);
        auto expected = nodes;
        for (std::size_t n = 0; n < nodes.x.size(); ++n)
            for (std::size_t d = 0; d < 3; ++d) {
                const auto i = static_cast<Eigen::Index>(d);
                expected.v[n][i] = nodes.v[n][i] + step * (scale.to(nodes.force[n][d]) / nodes.mass[n]);
                expected.x[n][i] = nodes.x[n][i] + dt * expected.v[n][i];
            }
        solver::move_freely(nodes, scale, step, dt);
        EXPECT_EQ(nodes.v, expected.v) << count;
        EXPECT_EQ(nodes.x, expected.x) << count;
    }
}

TEST(Motion, GivesTheKineticEnergyOfEachNode) {
    const parallel::FixedPoint scale(3000);
    std::mt19937_64 random(9);
    const auto nodes = random_nodes(3 * solver::energies_at_once, random);
    for (std::size_t first = 0; first < 2 * solver::energies_at_once; ++first) {
        const auto energies = solver::kinetic_energies(nodes, scale, first, step, dt);
        for (std::size_t i = 0; i < energies.size(); ++i) {
            const auto n = first + i;
            const Vec3 force(scale.to(nodes.force[n][0]), scale.to(nodes.force[n][1]),
                             scale.to(nodes.force[n][2])),
                &v = nodes.v[n];
            const Vec3 next = v + step * (force / nodes.mass[n]), acceleration = (next - v) / step;
            EXPECT_EQ(energies[i], nodes.mass[n] * v.dot(v + dt * acceleration) / 2) << n;
        }
    }
}

}  // namespace
}  // namespace weavefront::test
