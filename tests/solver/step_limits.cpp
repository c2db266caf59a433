/// The time step that `check` tells is that with which a run begins, and what sets it is told apart.

#include "weavefront/solver/step_limits.hpp"

#include <gtest/gtest.h>

#include "small_scene.hpp"

namespace weavefront::solver::test {
namespace {

struct Case {
    std::vector<std::string> overrides;
    StepLimit limit;
};

const std::vector<std::string> framed{"target.edges.x=frame", "target.frame={opening: {x: 12 mm}}",
                                      "projectile=", "contact.projectile="};

std::vector<Case> cases() {
    auto soft = framed;
    soft.emplace_back("contact.frame.stiffness=1e9 N/m^3");
    return {{{"projectile=", "contact="}, StepLimit::elements},
            {{"contact.projectile.stiffness=1e9 N/m^3"}, StepLimit::elements},
            {{}, StepLimit::projectile},
            {{"target.plies.count=3"}, StepLimit::plies},
            {{"target.plies.count=3", "contact.projectile.stiffness=1e16 N/m^3"}, StepLimit::projectile},
            {framed, StepLimit::frame},
            {soft, StepLimit::elements}};
}

TEST(StepLimits, AreThoseOfTheFirstStepOfARun) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    for (const auto& [overrides, limit] : cases()) {
        const auto scene = scene_with(overrides);
        const Simulation simulation(scene, comm);
        const auto limits = step_limits(scene, simulation.panel());
        EXPECT_EQ(limits.time_step, simulation.time_step()) << testing::PrintToString(overrides);
        EXPECT_EQ(limits.limit, limit) << testing::PrintToString(overrides);
        EXPECT_GE(limits.of_elements, limits.time_step);
    }
}

// Without contact it is the step of the elements.
TEST(StepLimits, OfElementsAreThoseWithoutContact) {
    const auto scene = scene_with({"target.plies.count=3"});
    const auto bare = scene_with({"target.plies.count=3", "projectile=", "contact="});
    EXPECT_EQ(step_limits(scene, mesh::make_panel(scene)).of_elements,
              step_limits(bare, mesh::make_panel(bare)).time_step);
}

}  // namespace
}  // namespace weavefront::solver::test
