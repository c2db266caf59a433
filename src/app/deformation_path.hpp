#pragma once
/// @file
/// A prescribed deformation of one material point.

#include <cstddef>
#include <filesystem>
#include <vector>

namespace weavefront::app {

/// Deformation gradient in the initial yarn axes, 1 fill and 2 warp, at a time.
struct Deformation {
    double time = 0;  ///< s
    double F11 = 1, F12 = 0, F21 = 0, F22 = 1;
    std::size_t line = 0;  ///< of its file, for messages

    [[nodiscard]] double determinant() const { return F11 * F22 - F12 * F21; }
};

/// What the kernel asks of a deformation: stretches of the yarns and cosine of the angle between them.
struct Kinematics {
    double lambda_f, lambda_w, cos_2theta;
};

/// Of the convected yarn vectors, the columns of F.
[[nodiscard]] Kinematics kinematics(const Deformation& deformation);

/// Reads a CSV file with the columns time,F11,F12,F21,F22; its first row is the identity, times increase, and
/// yarns are stretched to between a hundredth and a hundred times their length.
/// @throws scene::InputError with every finding as file:line:column, or when the file cannot be read
[[nodiscard]] std::vector<Deformation> read_deformation_path(const std::filesystem::path& path);

}  // namespace weavefront::app
