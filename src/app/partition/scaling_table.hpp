#pragma once
/// @file
/// Decompositions of a scene for a list of rank counts, as a table.

#include <optional>
#include <string>
#include <vector>

#include "weavefront/partition/forecast.hpp"

namespace weavefront::app {

struct ScalingRow {
    partition::Forecast forecast;
    double efficiency = 1;           ///< against one rank alone with the scene as it stands
    std::optional<double> measured;  ///< time of a step, s
    double slowdown = 1;  ///< time of a reference step while it was measured, over that of the calibration
};

/// The scene for `ranks`. @param weak refines the mesh by sqrt(ranks / first), which keeps the elements per
/// rank as they are
scene::Scene scaled_scene(const scene::Scene& scene, bool weak, int ranks, int first);

/// One row a rank count, without measured times.
std::vector<ScalingRow> forecast_all(const scene::Scene& scene, bool weak, const std::vector<int>& ranks,
                                     const partition::Machine& machine);

/// With right-aligned columns, for a terminal.
std::string terminal_table(const std::vector<ScalingRow>& rows);

/// SI units; measured_seconds and measured_slowdown are empty where nothing was measured.
std::string csv_table(const std::vector<ScalingRow>& rows);

}  // namespace weavefront::app
