/// Where and why the guard has stopped, from states that are brought about on purpose.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "small_scene.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::solver::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Writes a value into every field of a name of an element's state.
struct FieldWriter {
    static constexpr bool reads = true;
    std::string wanted;
    double written;

    void operator()(const char* name, double& value) const {
        if (wanted == name) value = written;
    }
};

/// Sets a field of the element of a global id, on the rank that has it.
void set_field(Simulation& simulation, std::int64_t element, const std::string& name, double value) {
    auto& model = simulation.model();
    const auto& ids = model.global.element_ids;
    const auto at = std::ranges::lower_bound(ids, element);
    if (at == ids.end() || *at != element) return;
    const auto slot = model.slots[static_cast<std::size_t>(at - ids.begin())];
    FieldWriter writer{name, value};
    model.groups[static_cast<std::size_t>(slot.group)]->state(writer, slot.index);
}

/// Gives the nodes within half a millimetre of a point, on all ranks that know them, a velocity and a shift.
void disturb(Simulation& simulation, const Vec3& at, const Vec3& velocity, const Vec3& shift = Vec3::Zero()) {
    auto& nodes = simulation.model().nodes;
    for (std::size_t n = 0; n < nodes.x.size(); ++n)
        if ((nodes.x[n] - at).norm() < 0.5e-3) nodes.v[n] += velocity, nodes.x[n] += shift;
}

/// The diagnosis, which must be that of rank 0.
std::string told(const Simulation& simulation, Fault fault, const parallel::Communicator& comm) {
    auto text = simulation.diagnosis(fault);
    EXPECT_EQ(text, comm.broadcast(text)) << "not that of rank 0";
    return text;
}

/// The message of the guard after at most so many steps; empty: it does not stop.
std::string stop(Simulation& simulation, const parallel::Communicator& comm, int steps) {
    try {
        for (int n = 0; n < steps; ++n) {
            simulation.advance_forces();
            require_balance(simulation.record_balance(), 0.05, simulation.steps());
            simulation.integrate();
        }
    } catch (const GuardStop& guard) {
        return std::string(guard.what()) + "; " + told(simulation, guard.fault(), comm);
    }
    return {};
}

// Two plies of 12 x 12 elements of 2 mm.
const std::vector<std::string> quiet{"projectile=", "contact=", "target.plies.count=2"};
constexpr std::int64_t columns = 144;

}  // namespace

TEST(Diagnosis, NamesTheElementWhoseStateIsNotFinite) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(quiet), comm);
    advance(simulation, 2);
    constexpr std::int64_t element = columns + 17;  // column 5 of row 1
    set_field(simulation, element, "work", nan);
    const auto message = stop(simulation, comm, 1);
    EXPECT_EQ(message.find("an energy is not finite at t = "), 0) << message;
    EXPECT_NE(
        message.find("step 2; it is worst in element 161 (ply 2, at x = -1 mm, y = -9 mm): its state or "
                     "that of its nodes is not finite; try "),
        message.npos)
        << message;
}

TEST(Diagnosis, NamesTheElementOfAVelocityThatIsNotFinite) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(quiet), comm);
    advance(simulation, 2);
    disturb(simulation, {12e-3, 12e-3, 0}, {0, nan, 0});
    const auto message = stop(simulation, comm, 2);
    EXPECT_NE(message.find("element 143 (ply 1, at x = 11 mm, y = 11 mm): its state or that of its nodes is "
                           "not finite; try "),
              message.npos)
        << message;
}

// Above its bound the step makes energy: straight elastic yarns, on a mesh whose highest mode attains the
// bound.
TEST(Diagnosis, BlamesATimeStepAboveItsBound) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(
        scene_with({"time.safety=1.2", "fabrics.kevlar129.thickness=0", "fabrics.kevlar129.friction=0",
                    "fabrics.kevlar129.elastic.viscosity=0", "fabrics.kevlar129.lateral=",
                    "contact.projectile={stiffness: 1e11 N/m^3, unloading: 1}", "contact.plies="}),
        comm);
    const auto message = stop(simulation, comm, 400);
    EXPECT_NE(message.find("; it is worst in element "), message.npos) << message;
    EXPECT_NE(message.find("the time step of "), message.npos) << message;
    EXPECT_NE(message.find(" times its bound; try"), message.npos) << message;
    EXPECT_NE(message.find("; try time.safety of at most 1"), message.npos) << message;
}

// A corner crosses the opposite edge of its element and is the fastest node there is.
TEST(Diagnosis, BlamesAFoldedElement) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(quiet), comm);
    simulation.advance_forces();
    disturb(simulation, {12e-3, 12e-3, 0}, {0, 0, 100}, {-3e-3, -1.5e-3, 0});
    const auto text = told(simulation, Fault::energy_sum, comm);
    EXPECT_EQ(
        text.find("it is worst in element 143 (ply 1, at x = 11 mm, y = 11 mm): it is folded over itself"), 0)
        << text;
    EXPECT_NE(text.find("; try a finer target.mesh or a smaller time.safety"), text.npos) << text;
    EXPECT_EQ(text.find("locked"), text.npos) << text;
}

// All of the target is sheared by more than the locking angle allows.
TEST(Diagnosis, BlamesLockedYarns) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    for (const auto* formulation : {"consistent", "paper"}) {
        auto overrides = quiet;
        overrides.push_back(std::string("fabrics.kevlar129.formulation=") + formulation);
        Simulation simulation(scene_with(overrides), comm);
        advance(simulation, 1);
        set_motion(
            simulation, [](const Vec3& x) { return Vec3(x.x() + 3 * x.y(), x.y(), x.z()); },
            [](const Vec3&) { return Vec3(0, 0, 0); });
        simulation.advance_forces();
        const auto text = told(simulation, Fault::energy_sum, comm);
        EXPECT_NE(text.find("its yarns are locked (lateral contact factor "), text.npos) << text;
        EXPECT_NE(text.find(", braid angle 9.22 deg)"), text.npos) << text;  // half of acos(3/sqrt(1 + 3^2))
        EXPECT_EQ(text.find("neither"), text.npos) << text;
    }
}

// Where contact has given energy, the deepest point is named: under the projectile, which the soft contact
// hardly stops.
TEST(Diagnosis, BlamesContactWhereItHasGivenEnergy) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with({"target.plies.count=2", "contact.projectile={stiffness: 1e9 N/m^3}",
                                      "contact.plies={stiffness: 1e9 N/m^3}"}),
                          comm);
    double deepest = 0;
    for (int n = 0; n < 400 && deepest <= 1.2; ++n) {
        advance(simulation, 1);
        deepest = simulation.deepest().in_thicknesses;
    }
    simulation.advance_forces();
    const auto text = told(simulation, Fault::contact, comm);
    EXPECT_NE(text.find("contact presses its points to a penetration of 1."), text.npos) << text;
    EXPECT_NE(text.find("contact distances (projectile); try a larger contact.projectile.stiffness"),
              text.npos)
        << text;
    // One of the four around the centre.
    EXPECT_TRUE(text.find("(ply 1, at x = 1 mm, y = ") != text.npos ||
                text.find("(ply 1, at x = -1 mm, y = ") != text.npos)
        << text;
}

TEST(Diagnosis, SaysWhereNothingStandsOut) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    Simulation simulation(scene_with(quiet), comm);
    advance(simulation, 1);
    disturb(simulation, {0, 0, 0}, {0, 0, 1});
    simulation.advance_forces();
    EXPECT_EQ(
        told(simulation, Fault::energy_sum, comm),
        "it is worst in element 65 (ply 1, at x = -1 mm, y = -1 mm): neither time step, folding, locking nor "
        "contact stands out there; try a smaller time.safety, or a larger limits.energy_error");
}

}  // namespace weavefront::solver::test
