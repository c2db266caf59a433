#pragma once
/// @file
/// The bilinear quad: shape functions, interpolation and the polynomial form of its map.
///
/// Corners 0 to 3 have the parent coordinates (xi, eta) = (-1, -1), (1, -1), (1, 1), (-1, 1).

#include <array>
#include <cstddef>

#include "weavefront/mesh/vec3.hpp"
#include "weavefront/simd/lanes.hpp"

namespace weavefront::contact {

using namespace simd;

/// Shape functions of a batch of points, [corner].
using ShapeFunctions = std::array<Lanes, 4>;

/// Sets the shape functions of one point of a batch.
inline void set_shape_functions(ShapeFunctions& N, std::size_t point, double xi, double eta) {
    N[0][point] = (1 - xi) * (1 - eta) / 4;
    N[1][point] = (1 + xi) * (1 - eta) / 4;
    N[2][point] = (1 + xi) * (1 + eta) / 4;
    N[3][point] = (1 - xi) * (1 + eta) / 4;
}

/// Shape functions at the points of a batch.
inline ShapeFunctions shape_functions(const Lanes& xi, const Lanes& eta) {
    ShapeFunctions N;
    for (std::size_t i = 0; i < batch_width; ++i) set_shape_functions(N, i, xi[i], eta[i]);
    return N;
}

/// Interpolates values of the corners at one point of a batch. The bits are those of `interpolate`.
inline Vec3 at_point(const std::array<Vec3, 4>& corners, const ShapeFunctions& N, std::size_t i) {
    return N[0][i] * corners[0] + N[1][i] * corners[1] + N[2][i] * corners[2] + N[3][i] * corners[3];
}

/// Interpolates values of the corners at all points of a batch.
inline VectorLanes interpolate(const std::array<Vec3, 4>& corners, const ShapeFunctions& N) {
    VectorLanes out;
    for (std::size_t i = 0; i < batch_width; ++i) {
        out.x[i] = N[0][i] * corners[0].x() + N[1][i] * corners[1].x() + N[2][i] * corners[2].x() +
                   N[3][i] * corners[3].x();
        out.y[i] = N[0][i] * corners[0].y() + N[1][i] * corners[1].y() + N[2][i] * corners[2].y() +
                   N[3][i] * corners[3].y();
        out.z[i] = N[0][i] * corners[0].z() + N[1][i] * corners[1].z() + N[2][i] * corners[2].z() +
                   N[3][i] * corners[3].z();
    }
    return out;
}

/// The map of a quad as a polynomial: x(xi, eta) = c + xi t1 + eta t2 + xi eta t3.
struct BilinearMap {
    Vec3 c;   ///< centre, mean of the corners
    Vec3 t1;  ///< tangent along xi at the centre
    Vec3 t2;  ///< tangent along eta at the centre
    Vec3 t3;  ///< taper and warp; zero for a parallelogram

    explicit BilinearMap(const std::array<Vec3, 4>& corners)
        : c((corners[0] + corners[1] + corners[2] + corners[3]) / 4),
          t1((corners[1] + corners[2] - corners[0] - corners[3]) / 4),
          t2((corners[2] + corners[3] - corners[0] - corners[1]) / 4),
          t3((corners[0] + corners[2] - corners[1] - corners[3]) / 4) {}
};

}  // namespace weavefront::contact
