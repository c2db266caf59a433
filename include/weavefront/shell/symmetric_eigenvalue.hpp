#pragma once
/// @file
/// Largest eigenvalue of a small symmetric matrix.

#include <algorithm>
#include <array>
#include <cmath>

namespace weavefront::shell {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Zeroes a[p][q] by a rotation of rows and columns p and q.
inline void rotate(Matrix4& a, std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const double half = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const double tangent = (half < 0 ? -1 : 1) / (std::abs(half) + std::sqrt(half * half + 1));
    const double c = 1 / std::sqrt(tangent * tangent + 1), s = tangent * c;
    for (auto& row : a) {
        const double at_p = row[p], at_q = row[q];
        row[p] = c * at_p - s * at_q;
        row[q] = s * at_p + c * at_q;
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const double at_p = a[p][k], at_q = a[q][k];
        a[p][k] = c * at_p - s * at_q;
        a[q][k] = s * at_p + c * at_q;
    }
}

/// An upper bound of the largest eigenvalue, to rounding: Jacobi rotations, then Gershgorin's circles around
/// what is left beside the diagonal. Only + - * / sqrt, so the same bits on every processor.
inline double largest_eigenvalue(Matrix4 a) {
    for (int sweep = 0; sweep < 6; ++sweep)
        for (std::size_t p = 0; p < 3; ++p)
            for (std::size_t q = p + 1; q < 4; ++q) rotate(a, p, q);
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        double reach = a[i][i];
        for (std::size_t j = 0; j < 4; ++j)
            if (j != i) reach += std::abs(a[i][j]);
        largest = i == 0 ? reach : std::max(largest, reach);
    }
    return largest;
}

}  // namespace weavefront::shell
