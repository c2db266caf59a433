/// What a model stores once for all plies is what each of them has.

#include "weavefront/solver/model.hpp"

#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

const std::vector<std::string> five_plies{
    "fabrics.light={areal_density: 102 g/m^2, density: 1440 kg/m^3, yarn: {span: 0.909 mm, area: 3.24e-2 "
    "mm^2, width: 0.32 mm}, "
    "thickness: 0.2 mm, elastic: {static_modulus: 96 GPa, hooke_modulus: 192 GPa}}",
    "target.plies=[{fabric: light}, {fabric: kevlar129, spacing: 1 mm, angle: 45 deg}, {fabric: light, "
    "spacing: 1 mm, angle: 30 deg}, "
    "{fabric: kevlar129, spacing: 1 mm}, {fabric: kevlar129, spacing: 1 mm, angle: 45 deg}]"};

TEST(Model, EveryElementHasItsPlaceItsShapeAndItsPly) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const Simulation simulation(scene_with(five_plies), comm);
    const auto& model = simulation.model();
    const auto& panel = simulation.panel();
    ASSERT_EQ(static_cast<std::int32_t>(model.slots.size()), model.surface.owned);
    for (std::int32_t e = 0; e < model.surface.owned; ++e) {
        const auto index = static_cast<std::size_t>(e);
        const auto& facet = model.surface.facets[index];
        ASSERT_EQ(facet.id, model.global.element_ids[index]);
        ASSERT_EQ(facet.ply, facet.id / panel.columns());
        const auto slot = model.slots[index];
        const auto& group = *model.groups[static_cast<std::size_t>(slot.group)];
        ASSERT_EQ(group.element(slot.index), e);
        ASSERT_TRUE(group.alive(slot.index));
        const auto& nodes = group.nodes(slot.index / shell::pack_width);
        for (std::size_t a = 0; a < 4; ++a)
            ASSERT_EQ(nodes[a][static_cast<std::size_t>(slot.index % shell::pack_width)], facet.nodes[a]);
        const auto corners = contact::corners_of(facet.nodes, model.nodes.x);
        ASSERT_EQ(model.surface.areas[index], shell::make_quad(corners, 0).area);
    }
}

TEST(Model, TheInitialPositionsAreThoseAtTheStart) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const Simulation simulation(scene_with(five_plies), comm);
    const auto& nodes = simulation.model().nodes;
    ASSERT_EQ(nodes.initial.size(), static_cast<std::size_t>(nodes.count));
    for (std::size_t n = 0; n < nodes.initial.size(); ++n) ASSERT_EQ(nodes.initial[n], nodes.x[n]);
}

}  // namespace
}  // namespace weavefront::solver::test
