#include "weavefront/contact/ray.hpp"

#include <cmath>

namespace weavefront::contact {

namespace {

/// Bilinear map c0 + c1 xi + c2 eta + c3 xi eta.
struct Bilinear {
    Lanes c0, c1, c2, c3;
};

Bilinear bilinear(const std::array<Lanes, 4>& corner) {
    Bilinear map;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double a = corner[0][i], b = corner[1][i], c = corner[2][i], d = corner[3][i];
        map.c0[i] = (a + b + c + d) / 4;
        map.c1[i] = (b + c - a - d) / 4;
        map.c2[i] = (c + d - a - b) / 4;
        map.c3[i] = (a + c - b - d) / 4;
    }
    return map;
}

// Points on a common edge must be found from at least one side whatever the rounding.
constexpr double edge_tolerance = 1e-9;

// A nearly rectangular facet takes two or three steps of Newton's method; what has not come to rest by then is met by no line. Convergence
// is quadratic: after a step of 1e-7 the error is of the order of 1e-14.
constexpr int most_iterations = 10;
constexpr double at_rest = 1e-7;

// Parent coordinates of a line that misses the facet by far; they are held there, so that the iteration stays finite.
constexpr double far_away = 8;

double within(double coordinate) {
    const double above = coordinate > -far_away ? coordinate : -far_away;
    return above < far_away ? above : far_away;
}

/// The facet seen along the lines: two coordinates across each, and one along it.
struct View {
    Bilinear u, w, along;
};

View view(const Rays& rays, const std::array<Vec3, 4>& corners) {
    // Two directions across a line, not orthonormal: direction x (diagonal of the facet) and direction x (the other diagonal).
    const Vec3 d13 = corners[2] - corners[0], d24 = corners[3] - corners[1];
    std::array<Lanes, 4> u, w, along;
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double nx = rays.direction.x[i], ny = rays.direction.y[i], nz = rays.direction.z[i];
        const double ux = ny * d13.z() - nz * d13.y(), uy = nz * d13.x() - nx * d13.z(), uz = nx * d13.y() - ny * d13.x();
        const double wx = ny * d24.z() - nz * d24.y(), wy = nz * d24.x() - nx * d24.z(), wz = nx * d24.y() - ny * d24.x();
        for (std::size_t a = 0; a < 4; ++a) {
            const double rx = corners[a].x() - rays.origin.x[i], ry = corners[a].y() - rays.origin.y[i],
                         rz = corners[a].z() - rays.origin.z[i];
            u[a][i] = rx * ux + ry * uy + rz * uz;
            w[a][i] = rx * wx + ry * wy + rz * wz;
            along[a][i] = rx * nx + ry * ny + rz * nz;
        }
    }
    return {bilinear(u), bilinear(w), bilinear(along)};
}

/// One step of Newton's method for u = w = 0; the largest change of a lane that is not far away.
double newton(const View& v, RayHits& hits, Lanes& change) {
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double xi = hits.xi[i], eta = hits.eta[i];
        const double ru = v.u.c0[i] + v.u.c1[i] * xi + (v.u.c2[i] + v.u.c3[i] * xi) * eta;
        const double rw = v.w.c0[i] + v.w.c1[i] * xi + (v.w.c2[i] + v.w.c3[i] * xi) * eta;
        const double u_xi = v.u.c1[i] + v.u.c3[i] * eta, u_eta = v.u.c2[i] + v.u.c3[i] * xi;
        const double w_xi = v.w.c1[i] + v.w.c3[i] * eta, w_eta = v.w.c2[i] + v.w.c3[i] * xi;
        const double determinant = u_xi * w_eta - u_eta * w_xi, inverse = 1 / (determinant != 0 ? determinant : 1.0);
        const double new_xi = within(xi - (ru * w_eta - rw * u_eta) * inverse), new_eta = within(eta - (u_xi * rw - w_xi * ru) * inverse);
        change[i] = determinant != 0 ? std::abs(new_xi - xi) + std::abs(new_eta - eta) : 1.0;
        hits.xi[i] = new_xi;
        hits.eta[i] = new_eta;
    }
    double largest = 0;
    for (std::size_t i = 0; i < batch_width; ++i) largest = change[i] > largest ? change[i] : largest;
    return largest;
}

}  // namespace

RayHits meet(const Rays& rays, const std::array<Vec3, 4>& corners) {
    const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    const auto v = view(rays, corners);
    RayHits hits;
    Lanes change{};
    for (int k = 0; k < most_iterations && newton(v, hits, change) > at_rest; ++k) {
    }
    for (std::size_t i = 0; i < batch_width; ++i) {
        const double facing = normal.x() * rays.direction.x[i] + normal.y() * rays.direction.y[i] + normal.z() * rays.direction.z[i];
        const bool inside = std::abs(hits.xi[i]) <= 1 + edge_tolerance && std::abs(hits.eta[i]) <= 1 + edge_tolerance;
        hits.hit[i] = facing > 0 && inside && change[i] <= at_rest;
        hits.distance[i] = v.along.c0[i] + v.along.c1[i] * hits.xi[i] + (v.along.c2[i] + v.along.c3[i] * hits.xi[i]) * hits.eta[i];
    }
    return hits;
}

}  // namespace weavefront::contact
