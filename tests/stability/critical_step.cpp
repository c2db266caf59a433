/// The bound on the time step against the true limit 2/omega of central differences, omega^2 the largest eigenvalue of M^-1 K of the
/// whole model with the tangent K as a step sees it.

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <functional>
#include <vector>

#include "base_scene.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::stability {

namespace {

/// One whole ply, as thick as the paper's, that nothing touches and that does not break.
const std::vector<std::string> small_panel{"fabrics.kevlar129.thickness=0.82 mm",
                                           "fabrics.kevlar129.failure=",
                                           "target.size=[6 mm, 6 mm]",
                                           "target.symmetry=[]",
                                           "target.plies={count: 1, fabric: kevlar129, gap: 0}",
                                           "target.mesh={center: 1 mm}",
                                           "target.edges={x: free, y: free}",
                                           "projectile=",
                                           "contact=",
                                           "time={end: 1 s, safety: 1}",
                                           "output.history=1 s"};

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

using Positions = std::vector<Vec3>;
/// Where a node of the panel at rest stands at a time from 0 to 1.
using Path = std::function<Vec3(double, const Vec3&)>;

/// A model that is led along a path to a state, again and again, to see what it does there.
class State {
  public:
    State(const std::vector<std::string>& overrides, Path path, const parallel::Communicator& comm)
        : scene_(scene::parse_scene(base_scene, "base_scene", joined(small_panel, overrides))), path_(std::move(path)), comm_(comm) {}

    struct Steps {
        double bound, limit;  ///< s
    };

    [[nodiscard]] Steps time_steps() const {
        auto simulation = at_rest();
        const double membrane_at_rest = membrane(simulation), at_rest = frequency_squared(simulation.time_step());
        lead(simulation);
        const double bound = membrane(simulation) + (at_rest - membrane_at_rest);
        return {2 / std::sqrt(bound), 2 / std::sqrt(largest_eigenvalue())};
    }

  private:
    static constexpr int path_steps = 40;
    // Small against all lengths that matter, the least of them a contact's penetration of some um; the forces still have eight digits.
    static constexpr double difference = 1e-10;

    static double frequency_squared(double dt) { return 4 / (dt * dt); }

    static double membrane(const solver::Simulation& simulation) {
        double largest = 0;
        for (const auto& group : simulation.model().groups) largest = std::max(largest, group->frequency_squared());
        return largest;
    }

    [[nodiscard]] solver::Simulation at_rest() const { return {scene_, comm_}; }

    /// Goes to x in one step. The nodes are made so heavy that no force moves them off their way.
    static void step_to(solver::Simulation& simulation, const Positions& x) {
        auto& nodes = simulation.model().nodes;
        for (std::size_t n = 0; n < x.size(); ++n) nodes.v[n] = (x[n] - nodes.x[n]) / simulation.time_step();
        simulation.integrate();
        simulation.advance_forces();
    }

    [[nodiscard]] Positions position(const solver::InitialPositions& initial, double time) const {
        Positions x;
        for (std::size_t n = 0; n < initial.size(); ++n) x.push_back(path_(time, initial[n]));
        return x;
    }

    void lead(solver::Simulation& simulation) const {
        auto& nodes = simulation.model().nodes;
        nodes.mass.assign(nodes.mass.size(), 1e100);
        nodes.supports.assign(nodes.supports.size(), 0);  // every force counts, that on planes of symmetry too
        if (simulation.model().projectile) simulation.model().projectile->velocity.setZero();
        simulation.advance_forces();
        for (int k = 1; k <= path_steps; ++k) step_to(simulation, position(nodes.initial, 1.0 * k / path_steps));
    }

    /// Nodal forces one step after the state, with one component of one node off by `offset`.
    [[nodiscard]] std::vector<double> forces(std::size_t unknown, double offset) const {
        auto simulation = at_rest();
        lead(simulation);
        auto x = position(simulation.model().nodes.initial, 1);
        x[unknown / 3][static_cast<Eigen::Index>(unknown % 3)] += offset;
        step_to(simulation, x);
        const auto& model = simulation.model();
        std::vector<double> all;
        for (const auto& sum : model.nodes.force)
            for (const auto component : sum) all.push_back(model.assembly.scale().to(component));
        return all;
    }

    /// M^-1 K by columns, with central differences.
    [[nodiscard]] std::vector<std::vector<double>> tangent() const {
        const auto simulation = at_rest();
        const auto& mass = simulation.model().nodes.mass;
        std::vector<std::vector<double>> columns;
        for (std::size_t j = 0; j < 3 * mass.size(); ++j) {
            auto column = forces(j, -difference);
            const auto ahead = forces(j, difference);
            for (std::size_t i = 0; i < column.size(); ++i) column[i] = (column[i] - ahead[i]) / (2 * difference * mass[i / 3]);
            columns.push_back(std::move(column));
        }
        return columns;
    }

    /// By power iteration. What it still lacks after so many products makes the limit found too long, by far less than a per cent.
    [[nodiscard]] double largest_eigenvalue() const {
        const auto columns = tangent();
        const auto size = columns.size();
        std::vector<double> v(size);
        for (std::size_t i = 0; i < size; ++i) v[i] = std::sin(1.0 + 7.0 * static_cast<double>(i));
        double value = 0;
        for (int k = 0; k < 3000; ++k) {
            std::vector<double> w(size);
            for (std::size_t j = 0; j < size; ++j)
                for (std::size_t i = 0; i < size; ++i) w[i] += columns[j][i] * v[j];
            double along = 0, length = 0;
            for (std::size_t i = 0; i < size; ++i) along += w[i] * v[i], length += w[i] * w[i];
            value = k == 0 ? 0 : along;
            for (std::size_t i = 0; i < size; ++i) v[i] = w[i] / std::sqrt(length);
        }
        return value;
    }

    scene::Scene scene_;
    Path path_;
    const parallel::Communicator& comm_;
};

const Path rest = [](double, const Vec3& x) { return x; };

Path stretch(double along_x, double along_y) {
    return [=](double time, const Vec3& x) { return Vec3(x.x() * (1 + time * along_x), x.y() * (1 + time * along_y), x.z()); };
}

/// Yarns along x and y turn towards each other by the angle in all, keeping their lengths.
Path shear(double angle) {
    return [=](double time, const Vec3& x) {
        const double half = time * angle / 2;
        return Vec3(x.x() * std::cos(half) + x.y() * std::sin(half), x.x() * std::sin(half) + x.y() * std::cos(half), x.z());
    };
}

/// Part of the greatest press at a time: up to all of it, then a little back, so that all contact points unload.
double pressed(double time) { return time < 0.8 ? time / 0.8 : 1 - 0.25 * (time - 0.8); }

/// The stack is pressed together by a part of its height.
Path press(double share) {
    return [=](double time, const Vec3& x) { return Vec3(x.x(), x.y(), x.z() * (1 - share * pressed(time))); };
}

/// The ply is pressed onto the nose of a projectile. @param depth m
Path press_onto_nose(double depth) {
    return [=](double time, const Vec3& x) { return Vec3(x.x(), x.y(), x.z() - depth * pressed(time)); };
}

/// A state of a panel of 6 x 6 elements, and of a single element.
struct Named {
    const char* name;
    std::vector<std::string> overrides;
    Path path;
    double least;          ///< bound over the limit of the panel
    double least_element;  ///< the same of one element
};

void PrintTo(const Named& state, std::ostream* out) { *out << state.name; }

class CriticalStep : public testing::TestWithParam<Named> {};

// Above 1 the ratio may stand by what the limit lacks: the power iteration comes within 1e-3 of omega^2 (the largest eigenvalues of a
// regular mesh lie close together), the differences within 1e-5.
constexpr double too_long = 1e-3;

TEST_P(CriticalStep, IsBoundedFromBelowAndNotFarBelow) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto& [name, overrides, path, least, least_element] = GetParam();
    const auto [bound, limit] = State(overrides, path, comm).time_steps();
    const auto single = joined(overrides, {"target.size=[2 mm, 2 mm]", "target.symmetry=[x, y]"});
    const auto [element_bound, element_limit] = State(single, path, comm).time_steps();
    std::printf("%-20s bound %6.2f ns, limit %6.2f ns, ratio %.3f; one element %.3f\n", name, bound * 1e9, limit * 1e9, bound / limit,
                element_bound / element_limit);
    EXPECT_LE(bound / limit, 1 + too_long);
    EXPECT_GE(bound / limit, least);
    EXPECT_LE(element_bound / element_limit, 1 + too_long);
    EXPECT_GE(element_bound / element_limit, least_element);
}

const std::string straight = "fabrics.kevlar129.thickness=0", half_crimp = "fabrics.kevlar129.thickness=0.41 mm";
constexpr double degree = 3.14159265358979 / 180;

std::vector<std::string> pressed_plies(const std::string& count) {
    return {straight, "target.plies.count=" + count, "contact.plies={damping: 0}", "target.size=[2 mm, 2 mm]"};
}

const std::vector<std::string> on_projectile{straight, "target.size=[2 mm, 2 mm]", "contact.projectile={damping: 0}",
                                             "projectile={shape: cylinder, diameter: 8 mm, mass: 1000000 kg, velocity: [0, 0, 1 m/s]}"};

// The bound is that of the worst element with its crossovers held. In a panel the elements cannot all be in their worst mode at once where
// that mode needs both yarns: fill and warp that stretch together over a crossover that is free, or turn towards each other. There the
// panel can take longer steps than any of its elements; README.md says more.
INSTANTIATE_TEST_SUITE_P(
    States, CriticalStep,
    testing::Values(Named{"straight", {straight}, rest, 0.99, 0.99}, Named{"straight, tight", {straight}, stretch(0.02, 0.02), 0.98, 0.98},
                    Named{"slack, t = 0.41 mm", {half_crimp}, rest, 0.70, 0.95}, Named{"slack, t = 0.82 mm", {}, rest, 0.65, 0.90},
                    Named{"fill taut", {half_crimp}, stretch(0.05, 0), 0.85, 0.9},
                    Named{"both taut", {half_crimp}, stretch(0.02, 0.02), 0.74, 0.9},
                    Named{"sheared by 60 deg", {straight}, shear(60 * degree), 0.99, 0.99},
                    Named{"locking", {straight}, shear(67.5 * degree), 0.85, 0.95},
                    Named{"locked", {straight}, shear(75 * degree), 0.80, 0.99},
                    Named{"graded", {straight, "target.mesh={center: 0.5 mm, edge: 2 mm, growth: 1.5}"}, rest, 0.85, 0.85},
                    Named{"pressed, 2 plies", pressed_plies("2"), press(0.1), 0.85, 0.85},
                    Named{"pressed, 3 plies", pressed_plies("3"), press(0.1), 0.85, 0.85},
                    Named{"pressed, 8 plies", pressed_plies("8"), press(0.1), 0.85, 0.85},
                    Named{"on the projectile", on_projectile, press_onto_nose(20e-6), 0.70, 0.70}),
    [](const auto& state) {
        std::string name;
        for (const char c : std::string(state.param.name))
            if (std::isalnum(static_cast<unsigned char>(c))) name += c;
        return name;
    });

}  // namespace

}  // namespace weavefront::stability
