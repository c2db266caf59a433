/// Lines that meet bilinear facets.

#include "weavefront/contact/ray.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace weavefront::test {
namespace {

using contact::batch_width;
using Facet = std::array<Vec3, 4>;

Facet warped_facet(std::mt19937_64& random, double distortion) {
    Facet facet{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    for (auto& corner : facet)
        for (int d = 0; d < 3; ++d) corner[d] += uniform(random, -distortion, distortion);
    return facet;
}

Vec3 at(const Facet& c, double xi, double eta) {
    return (1 - xi) * (1 - eta) / 4 * c[0] + (1 + xi) * (1 - eta) / 4 * c[1] +
           (1 + xi) * (1 + eta) / 4 * c[2] + (1 - xi) * (1 + eta) / 4 * c[3];
}

void set(contact::VectorLanes& lanes, std::size_t i, const Vec3& value) {
    lanes.x[i] = value.x(), lanes.y[i] = value.y(), lanes.z[i] = value.z();
}

/// A unit vector within `slant` of +z.
Vec3 near_z(std::mt19937_64& random, double slant) {
    return Vec3(uniform(random, -slant, slant), uniform(random, -slant, slant), 1).normalized();
}

TEST(Ray, FindsTheKnownPointOfAWarpedFacet) {
    std::mt19937_64 random(5);
    for (int n = 0; n < 2000; ++n) {
        const auto facet = warped_facet(random, 0.2);
        contact::Rays rays;
        contact::Lanes xi, eta, distance;
        for (std::size_t i = 0; i < batch_width; ++i) {
            xi[i] = uniform(random, -1, 1), eta[i] = uniform(random, -1, 1),
            distance[i] = uniform(random, -1, 1);
            const Vec3 direction = near_z(random, 0.3);
            set(rays.direction, i, direction);
            set(rays.origin, i, at(facet, xi[i], eta[i]) - distance[i] * direction);
        }
        const auto hits = contact::intersect(rays, facet);
        for (std::size_t i = 0; i < batch_width; ++i) {
            ASSERT_TRUE(hits.hit[i]) << n << ' ' << i;
            ASSERT_NEAR(hits.xi[i], xi[i], 1e-9);
            ASSERT_NEAR(hits.eta[i], eta[i], 1e-9);
            ASSERT_NEAR(hits.distance[i], distance[i], 1e-9);
        }
        // seen from the other side nothing is met
        for (std::size_t i = 0; i < batch_width; ++i)
            set(rays.direction, i, -Vec3(rays.direction.x[i], rays.direction.y[i], rays.direction.z[i]));
        for (const bool hit : contact::intersect(rays, facet).hit) ASSERT_FALSE(hit);
    }
}

TEST(Ray, MissesFacetsBesideIt) {
    std::mt19937_64 random(6);
    for (int n = 0; n < 2000; ++n) {
        const auto facet = warped_facet(random, 0.1);
        contact::Rays rays;
        std::array<bool, batch_width> inside{};
        for (std::size_t i = 0; i < batch_width; ++i) {
            const double xi = uniform(random, -1.5, 1.5), eta = uniform(random, -1.5, 1.5);
            inside[i] = std::abs(xi) <= 1 && std::abs(eta) <= 1;
            set(rays.direction, i, Vec3(0, 0, 1));
            set(rays.origin, i, at(facet, xi, eta) - Vec3(0, 0, 0.5));
        }
        const auto hits = contact::intersect(rays, facet);
        for (std::size_t i = 0; i < batch_width; ++i) ASSERT_EQ(hits.hit[i], inside[i]);
    }
}

TEST(Ray, NoRayPassesBetweenFacets) {
    std::mt19937_64 random(7);
    constexpr int n = 20;
    Plies plies;
    plies.add(n, {}, [&](double u, double v) {
        return Vec3(u * n + uniform(random, -0.2, 0.2), v * n + uniform(random, -0.2, 0.2),
                    uniform(random, -0.2, 0.2));
    });
    const auto node = [&](int i, int j) -> const Vec3& {
        return plies.x[static_cast<std::size_t>(j * (n + 1) + i)];
    };
    for (int trial = 0; trial < 500; ++trial) {
        // through edges, and through nodes in the last two lanes
        contact::Rays rays;
        for (std::size_t lane = 0; lane < batch_width; ++lane) {
            const int i = 2 + static_cast<int>(random() % (n - 4)),
                      j = 2 + static_cast<int>(random() % (n - 4));
            const double along = lane < 6 ? uniform(random, 0, 1) : 0;
            const Vec3 target =
                (1 - along) * node(i, j) + along * (lane % 2 == 0 ? node(i + 1, j) : node(i, j + 1));
            const Vec3 direction = near_z(random, 0.1);
            set(rays.direction, lane, direction);
            set(rays.origin, lane, target - uniform(random, -0.3, 0.3) * direction);
        }
        std::array<int, batch_width> found{};
        for (const auto& facet : plies.surface.facets) {
            const auto hits = contact::intersect(rays, contact::corners_of(facet.nodes, plies.x));
            for (std::size_t lane = 0; lane < batch_width; ++lane) found[lane] += hits.hit[lane];
        }
        for (const int count : found) ASSERT_GE(count, 1);
    }
}

}  // namespace
}  // namespace weavefront::test
