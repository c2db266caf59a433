#pragma once
/// @file
/// The structure of a results file, with everything that no frame changes except the topology.

#include <cstdint>
#include <string>
#include <vector>

#include "weavefront/io/results.hpp"

namespace weavefront::io {

inline constexpr const char* hidden_name = "vtkGhostType";
inline constexpr const char* ply_name = "ply";

/// Sizes of one frame: part 0 is the fabric, part 1 the surface of the projectile, where there is one.
struct PartSizes {
    std::vector<std::int64_t> points;
    std::vector<std::int64_t> cells;

    explicit PartSizes(const ResultsSetup& setup);
    [[nodiscard]] std::int64_t parts() const { return static_cast<std::int64_t>(points.size()); }
    [[nodiscard]] std::int64_t all_points() const;
    [[nodiscard]] std::int64_t all_cells() const;
};

/// Bytes of the arrays of a file with so many frames, nearly all of it.
[[nodiscard]] double results_bytes(const ResultsSetup& setup, std::int64_t frames);

/// Creates the file on one process: groups, attributes, all extents and all offsets, with NSteps = 0. File
/// space is allocated for `max_frames` frames, sparse until they are written.
/// @param path   of the file, which must not be there
/// @param setup  what is constant; the owned parts of its topology are not read
/// @throws FileError
void create_results_skeleton(const std::string& path, const ResultsSetup& setup);

}  // namespace weavefront::io
