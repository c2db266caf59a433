/// Forces that cannot be represented are reported, and do not get into the sums.

#include "weavefront/solver/assembly.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "small_scene.hpp"
#include "weavefront/shell/aligned_vector.hpp"

namespace weavefront::solver::test {
namespace {

constexpr double largest_force = 100;  // N; forces below 1024 times the next power of two are representable

/// Element forces of a group, and their sums at the nodes.
struct Forces {
    Forces()
        : simulation(scene_with({}), comm),
          assembly(largest_force, 1e-2),
          group(*simulation.model().groups[0]) {
        packs = (group.size() + shell::pack_width - 1) / shell::pack_width;
        values.resize(static_cast<std::size_t>(packs) * shell::forces_per_pack);
        std::ranges::fill(values, 1.0);
        sums.resize(simulation.model().nodes.x.size());
        assembly.start(sums);
    }

    /// A force component of an element's corners 1 to 3. @param index of the element in the group
    double& value(std::int32_t index, std::size_t corner, std::size_t direction) {
        const auto pack = static_cast<std::size_t>(index / shell::pack_width),
                   lane = static_cast<std::size_t>(index % shell::pack_width);
        return values[pack * shell::forces_per_pack + (corner * 3 + direction) * shell::pack_width + lane];
    }
    void add() { assembly.add_packs(group, 0, packs, values, sums); }
    /// Sums with all elements but one. @param index of the one in the group; -1: all
    std::vector<FixedVector> sums_without(std::int32_t index) {
        std::vector<FixedVector> expected(sums.size(), FixedVector{});
        const auto one = assembly.scale().from(1.0);
        for (std::int32_t e = 0; e < group.size(); ++e)
            for (std::size_t a = 0; a < 4 && e != index; ++a) {
                const auto& nodes = group.nodes(e / shell::pack_width);
                const auto node = nodes[a][static_cast<std::size_t>(e % shell::pack_width)];
                for (auto& part : expected[static_cast<std::size_t>(node)]) part += a < 3 ? one : -3 * one;
            }
        return expected;
    }

    parallel::Communicator comm{MPI_COMM_WORLD};
    Simulation simulation;
    Assembly assembly;
    const shell::ElementGroup& group;
    std::int32_t packs = 0;
    shell::AlignedVector<double> values;
    std::vector<FixedVector> sums;
};

constexpr double unrepresentable[]{std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(), 1025 * 128.0};

TEST(Assembly, AddsForcesThatFit) {
    Forces forces;
    forces.add();
    EXPECT_EQ(forces.assembly.faulty_element(), -1);
    EXPECT_EQ(forces.sums, forces.sums_without(-1));
}

TEST(Assembly, LeavesOutAnElementWithAFaultyForceAndNamesIt) {
    for (const double fault : unrepresentable)
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t direction = 0; direction < 3; ++direction) {
                Forces forces;
                const std::int32_t index = forces.group.size() / 2;
                forces.value(index, corner, direction) = fault;
                forces.add();
                ASSERT_EQ(forces.assembly.faulty_element(), forces.group.element(index)) << fault;
                ASSERT_EQ(forces.sums, forces.sums_without(index)) << fault;
            }
}

TEST(Assembly, NamesTheFirstOfSeveralFaultyElements) {
    Forces forces;
    for (const std::int32_t index : {4, 1, 7}) forces.value(index, 0, 0) = unrepresentable[0];
    forces.add();
    EXPECT_EQ(forces.assembly.faulty_element(), forces.group.element(1));
}

TEST(Assembly, ForgetsFaultsAtTheStartOfAStep) {
    Forces forces;
    forces.value(0, 0, 0) = unrepresentable[0];
    forces.add();
    FixedVector on_projectile{};
    contact::PairForce pair({0, 1, 2, 3}, contact::Master::projectile);
    pair.total.x() = unrepresentable[0];
    forces.assembly.add_pair(pair, forces.sums, &on_projectile);
    forces.assembly.start(forces.sums);
    EXPECT_EQ(forces.assembly.faulty_element(), -1);
    EXPECT_FALSE(forces.assembly.faulty_contact());
    EXPECT_EQ(forces.sums, std::vector<FixedVector>(forces.sums.size(), FixedVector{}));
}

TEST(Assembly, LeavesOutAPairWithAFaultyForce) {
    const std::vector<FixedVector> none(8, FixedVector{});
    for (const double fault : unrepresentable)
        for (int kind = 0; kind < 3; ++kind)
            for (Eigen::Index d = 0; d < 3; ++d) {
                Assembly assembly(largest_force, 1e-2);
                auto sums = none;
                FixedVector on_projectile{};
                contact::PairForce pair({0, 1, 2, 3}, std::array{4, 5, 6, 7});
                auto& force = kind == 0 ? pair.total : kind == 1 ? pair.on_slave[2] : pair.on_master[3];
                force[d] = fault;
                assembly.add_pair(pair, sums, &on_projectile);
                ASSERT_TRUE(assembly.faulty_contact()) << fault << ' ' << kind;
                ASSERT_EQ(sums, none) << fault << ' ' << kind;
            }
}

}  // namespace
}  // namespace weavefront::solver::test
