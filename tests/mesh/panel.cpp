/// The panel: ids, geometry, supports, symmetry.

#include "weavefront/mesh/panel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "small_target.hpp"

namespace weavefront::test {
namespace {

using mesh::make_panel;

TEST(Panel, ColumnsTileTheTarget) {
    const auto panel = make_panel(small_target());
    EXPECT_EQ(panel.elements(), 3 * panel.columns());
    EXPECT_EQ(panel.nodes(), 3 * panel.nodes_per_ply());
    double area = 0;
    std::vector<int> uses(static_cast<std::size_t>(panel.nodes_per_ply()));
    for (std::int64_t column = 0; column < panel.columns(); ++column) {
        const auto nodes = panel.footprint(column);
        const auto at = [&](std::size_t a) { return panel.position(0, nodes[a]); };
        const double twice = (at(2) - at(0)).cross(at(3) - at(1)).z();
        ASSERT_GT(twice, 0) << "counter-clockwise seen from +z";
        ASSERT_GT((at(1) - at(0)).x(), 0);
        area += twice / 2;
        for (const auto node : nodes) ++uses.at(static_cast<std::size_t>(node));
    }
    EXPECT_NEAR(area, 0.02 * 0.03, 1e-15 * static_cast<double>(panel.columns()));
    EXPECT_EQ(std::ranges::count(uses, 1), 4);  // the corners of the target
    EXPECT_EQ(std::ranges::count(uses, 2), 2 * (panel.columns_x() + panel.columns_y()) - 4);
    EXPECT_EQ(std::ranges::count(uses, 0), 0);
}

TEST(Panel, PliesLieOverEachOther) {
    const auto panel = make_panel(small_target());
    for (std::int64_t node = 0; node < panel.nodes_per_ply(); ++node) {
        EXPECT_EQ(panel.position(0, node).z(), 0);
        EXPECT_EQ(panel.position(2, node) - panel.position(0, node), Vec3(0, 0, 0.6e-3));
    }
}

TEST(Panel, IsFinestUnderTheProjectile) {
    auto scene = small_target();
    scene.projectiles = {scene::Projectile{.position = {0.004, -0.009, 0}}};
    const auto panel = make_panel(scene);
    const auto finest = [](const std::vector<double>& line, double at) {
        double size = 1, where = 0;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (line[i + 1] - line[i] < size)
                size = line[i + 1] - line[i], where = (line[i] + line[i + 1]) / 2;
        return std::abs(where - at) < size;
    };
    EXPECT_TRUE(finest(panel.x, 0.004));
    EXPECT_TRUE(finest(panel.y, -0.009));
}

TEST(Panel, EdgesHoldTheirDirections) {
    auto scene = small_target();
    scene.target->edges = {scene::Edge::sliding, scene::Edge::fixed};
    const auto panel = make_panel(scene);
    constexpr int x = 1, y = 2, z = 4;
    const auto held = [&](std::int64_t i, std::int64_t j) {
        return panel.supports(j * (panel.columns_x() + 1) + i);
    };
    for (const std::int64_t i : {std::int64_t{0}, panel.columns_x()}) {
        EXPECT_EQ(held(i, 1), z);
        EXPECT_EQ(held(i, 0), x | y | z);
    }
    for (const std::int64_t j : {std::int64_t{0}, panel.columns_y()}) EXPECT_EQ(held(1, j), x | y | z);
    EXPECT_EQ(held(1, 1), 0);
    scene.target->edges = {scene::Edge::free, scene::Edge::free};
    const auto loose = make_panel(scene);
    for (std::int64_t node = 0; node < loose.nodes_per_ply(); ++node) ASSERT_EQ(loose.supports(node), 0);
}

TEST(Panel, HoldsWhatLiesBeyondTheOpeningAsItsEdges) {
    auto scene = small_target();
    scene.target->frame = scene::Frame{.radius = 8e-3, .edge_radius = 1e-3};
    const auto held = [&](scene::Edge edge) {
        scene.target->edges = {edge, edge};
        const auto panel = make_panel(scene);
        std::int64_t beyond = 0;
        for (std::int64_t node = 0; node < panel.nodes_per_ply(); ++node) {
            const Vec3 at = panel.position(0, node);
            const bool is_beyond = std::hypot(at.x(), at.y()) > 8e-3;
            beyond += is_beyond ? 1 : 0;
            EXPECT_EQ(panel.clamp_of(node).has_value(), is_beyond && edge == scene::Edge::clamp);
            const bool is_edge = std::abs(at.x()) == 0.01 || std::abs(at.y()) == 0.015;
            const int all = edge == scene::Edge::fixed ? 7 : edge == scene::Edge::clamp ? 4 : 0;
            EXPECT_EQ(panel.supports(node), is_beyond || is_edge ? all : 0);
        }
        EXPECT_GT(beyond, panel.nodes_per_ply() / 4);
    };
    for (const auto edge : {scene::Edge::fixed, scene::Edge::clamp, scene::Edge::frame}) held(edge);
}

TEST(Panel, OfASymmetricModelIsItsPartOfTheWhole) {
    auto scene = small_target();
    const auto whole = make_panel(scene);
    scene.target->symmetry = {true, true};
    scene.target->edges = {scene::Edge::free, scene::Edge::fixed};
    const auto quarter = make_panel(scene);
    EXPECT_EQ(whole.multiplicity(), 1);
    EXPECT_EQ(quarter.multiplicity(), 4);
    EXPECT_EQ(quarter.x, std::vector<double>(std::ranges::find(whole.x, 0.0), whole.x.end()));
    EXPECT_EQ(quarter.y, std::vector<double>(std::ranges::find(whole.y, 0.0), whole.y.end()));
    const auto stride = quarter.columns_x() + 1;
    EXPECT_EQ(quarter.supports(0), 1 | 2);                                 // on both planes of symmetry
    EXPECT_EQ(quarter.supports(1), 2);                                     // in the plane y = 0
    EXPECT_EQ(quarter.supports(stride), 1);                                // in the plane x = 0
    EXPECT_EQ(quarter.supports(quarter.columns_y() * stride), 1 | 2 | 4);  // fixed edge
    EXPECT_EQ(quarter.supports(quarter.columns_x()), 2);                   // free edge, in the plane y = 0
}

TEST(Panel, NeedsATarget) { EXPECT_THROW(make_panel(scene::Scene{}), std::invalid_argument); }

}  // namespace
}  // namespace weavefront::test
