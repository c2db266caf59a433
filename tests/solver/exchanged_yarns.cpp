#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "small_scene.hpp"

namespace weavefront::solver::test {

namespace {

/// Positions after an impact on unequal yarns. @param pairs of values of the two yarns, in this order
std::vector<Vec3> struck(const std::string& one, const std::string& other, const std::string& angle) {
    const auto pair = [&](const std::string& key, const std::string& of_one, const std::string& of_other) {
        return "fabrics.kevlar129." + key + "={" + one + ": " + of_one + ", " + other + ": " + of_other + "}";
    };
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(
        scene_with({"fabrics.kevlar129.thickness=", "fabrics.kevlar129.contact_thickness=0.2 mm",
                    pair("yarn.span", "0.909 mm", "0.8 mm"), pair("yarn.area", "6.48e-2 mm^2", "8e-2 mm^2"),
                    pair("yarn.width", "0.32 mm", "0.4 mm"), pair("crimp_height", "0.03 mm", "0.08 mm"),
                    pair("elastic.static_modulus", "96 GPa", "80 GPa"), "target.edges={x: fixed, y: fixed}",
                    "target.plies.angle=" + angle}),
        comm);
    advance(simulation, 200);
    const auto& model = simulation.model();
    return {model.nodes.x.begin(), model.nodes.x.begin() + model.nodes.count};
}

}  // namespace

TEST(ExchangedYarns, TurnedBy90DegreesAreTheSameFabric) {
    const auto plain = struck("fill", "warp", "0"), turned = struck("warp", "fill", "90 deg");
    ASSERT_EQ(plain.size(), turned.size());
    double largest = 0, moved = 0;
    for (std::size_t n = 0; n < plain.size(); ++n) {
        largest = std::max(largest, (plain[n] - turned[n]).norm());
        moved = std::max(moved, plain[n].z());
    }
    EXPECT_GT(moved, 1e-3);
    // Forces differ by their rounding, 1e-16 of them, over 200 steps.
    EXPECT_LT(largest, 1e-12 * moved);
}

}  // namespace weavefront::solver::test
