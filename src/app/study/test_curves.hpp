#pragma once
/// @file
/// A yarn or a cell of fabric by itself, as variants of a study.

#include <cstdint>

#include "csv_table.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::app {

inline constexpr const char* yarn_header = "time,strain,stress";
inline constexpr const char* cell_header =
    "time,h_fill,stress_fill,stress_warp,stress_xx,stress_yy,stress_xy,evaluations";

/// What such a variant leaves.
struct TestCurve {
    CsvTable table;
    std::int64_t steps = 0;
    double seconds = 0;  ///< wall time of the steps, the shortest of several passes where they are short
};

/// Strains a straight yarn from rest at a constant rate.
TestCurve yarn_curve(const scene::Case& variant);

/// Takes a cell through its deformation path, each row in `refinement` equal steps.
/// @throws scene::InputError, std::runtime_error for a path at fault
TestCurve cell_curve(const scene::Case& variant);

}  // namespace weavefront::app
