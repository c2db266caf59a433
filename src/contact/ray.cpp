#include "weavefront/contact/ray.hpp"

#include <cmath>

#include "weavefront/contact/bilinear_quad.hpp"

namespace weavefront::contact {

namespace {

// A point on the edge of two facets must be hit on at least one of them, in spite of rounding.
constexpr double edge_tolerance = 1e-9;

}  // namespace

Rays one_ray(const Vec3& origin, const Vec3& direction) {
    Rays rays;
    for (std::size_t i = 0; i < batch_width; ++i) {
        rays.origin.x[i] = origin.x(), rays.origin.y[i] = origin.y(), rays.origin.z[i] = origin.z();
        rays.direction.x[i] = direction.x(), rays.direction.y[i] = direction.y(),
        rays.direction.z[i] = direction.z();
    }
    return rays;
}

// Let n be the direction of the ray, e = c2 - c0 and f = c3 - c1 the diagonals, and N = n.(e x f). Seen along
// n, corner a has the coordinates u_a = r_a.(n x e) and w_a = r_a.(n x f). As u_0 = u_2 and w_1 = w_3, the
// intersection obeys
//     xi - eta = d0 + d3 m,    xi + eta = s0 + s3 m,    m = xi eta,
// and 4 m = (xi + eta)^2 - (xi - eta)^2 is a quadratic equation for m. Its slope at a root has the sign of
// minus the Jacobian of the map. So one root is the point of the facet; the other one lies where the map is
// turned over.
RayHits intersect(const Rays& rays, const std::array<Vec3, 4>& corners) {
    const Vec3 e = corners[2] - corners[0], f = corners[3] - corners[1], normal = e.cross(f);
    const BilinearMap map(corners);
    RayHits hits;
    Lanes beyond;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double nx = rays.direction.x[i], ny = rays.direction.y[i], nz = rays.direction.z[i];
        const double ox = rays.origin.x[i], oy = rays.origin.y[i], oz = rays.origin.z[i];
        const double ux = ny * e.z() - nz * e.y(), uy = nz * e.x() - nx * e.z(), uz = nx * e.y() - ny * e.x();
        const double wx = ny * f.z() - nz * f.y(), wy = nz * f.x() - nx * f.z(), wz = nx * f.y() - ny * f.x();
        const auto across_u = [&](const Vec3& c) {
            return (c.x() - ox) * ux + (c.y() - oy) * uy + (c.z() - oz) * uz;
        };
        const auto across_w = [&](const Vec3& c) {
            return (c.x() - ox) * wx + (c.y() - oy) * wy + (c.z() - oz) * wz;
        };
        const double u0 = 2 * across_u(corners[0]), u13 = across_u(corners[1]) + across_u(corners[3]);
        const double w1 = 2 * across_w(corners[1]), w02 = across_w(corners[0]) + across_w(corners[2]);
        const double facing = normal.x() * nx + normal.y() * ny + normal.z() * nz,
                     inverse = 1 / (facing > 0 ? facing : 1.0);
        const double d0 = inverse * (u0 + u13), d3 = inverse * (u0 - u13), s0 = inverse * (w02 + w1),
                     s3 = inverse * (w02 - w1);
        const double A = s3 * s3 - d3 * d3, B = 2 * (s0 * s3 - d0 * d3) - 4, C = s0 * s0 - d0 * d0;
        const double discriminant = B * B - 4 * A * C,
                     root = std::sqrt(discriminant > 0 ? discriminant : 0.0) - B;
        const double m = 2 * C / (root > 0 ? root : 1.0);
        const double xi = (s0 + s3 * m + d0 + d3 * m) / 2, eta = (s0 + s3 * m - d0 - d3 * m) / 2;
        hits.xi[i] = xi;
        hits.eta[i] = eta;
        hits.distance[i] =
            (map.c.x() + map.t1.x() * xi + map.t2.x() * eta + map.t3.x() * xi * eta - ox) * nx +
            (map.c.y() + map.t1.y() * xi + map.t2.y() * eta + map.t3.y() * xi * eta - oy) * ny +
            (map.c.z() + map.t1.z() * xi + map.t2.z() * eta + map.t3.z() * xi * eta - oz) * nz;
        // The larger parent coordinate; 2, outside of every facet, where there is no intersection.
        const double larger = std::abs(xi) > std::abs(eta) ? std::abs(xi) : std::abs(eta);
        const double within = facing > 0 ? larger : 2.0, real = discriminant >= 0 ? within : 2.0;
        beyond[i] = root > 0 ? real : 2.0;
    }
    for (std::size_t i = 0; i < batch_width; ++i) hits.hit[i] = beyond[i] <= 1 + edge_tolerance;
    return hits;
}

}  // namespace weavefront::contact
