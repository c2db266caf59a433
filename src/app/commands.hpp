#pragma once
/// @file
/// The subcommands and their options. Each function throws on failure.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint_schedule.hpp"

namespace weavefront::app {

struct RunOptions {
    std::filesystem::path scene, output;  ///< output empty: runs/<scene name>
    std::vector<std::string> overrides;
    std::optional<double> rebalance;
    CheckpointPlan checkpoints;
    std::string restart;  ///< auto or a file; empty: from the start
    bool overwrite = false;
};

/// Computes an impact. @note Collective
void run(const RunOptions& options);

struct CheckOptions {
    std::filesystem::path scene;
    std::vector<std::string> overrides;
};

/// Validates a scene and prints what its run takes.
void check(const CheckOptions& options);

struct CellOptions {
    std::filesystem::path scene, path, out;
    std::string fabric;  ///< empty: the only one
    std::vector<std::string> overrides;
};

/// Takes one material point through a prescribed deformation.
void cell(const CellOptions& options);

struct YarnOptions {
    std::filesystem::path scene, out;
    std::string fabric, rates;  ///< fabric empty: the only one
    std::string yarn = "fill";  ///< or `warp`
    std::vector<std::string> overrides;
};

/// Strains one yarn at constant rates up to its failure.
void yarn(const YarnOptions& options);

struct LibraryOptions {
    std::string name;  ///< empty: all
};

/// Prints fabrics of the library with their values and sources.
void fabrics(const LibraryOptions& options);

/// Prints projectiles of the library with their values and sources.
void projectiles(const LibraryOptions& options);

struct StudyOptions {
    std::filesystem::path study, output, check;  ///< output empty: runs/<study name>; check empty: none
    bool no_picture = false;
};

/// Computes variants of a scene and their errors. @note Collective
void study(StudyOptions options);

struct V50Options {
    std::filesystem::path scene, output, shots;  ///< output empty: runs/<scene name>_v50; shots empty: none
    std::vector<std::string> overrides, scatter;
    std::string from, to, width, sigma, complete, mesh, stiffness;  ///< as written; empty: the default
    std::optional<double> confidence;                               ///< of the intervals
    std::optional<int> ranks_per_shot, count;
    std::uint64_t seed = 1;
    CheckpointPlan checkpoints;
    std::string restart;  ///< auto; empty: from the start
    bool overwrite = false, no_picture = false;
};

/// Finds the ballistic limit of a scene, or its V50 where shots scatter. @note Collective
void v50(V50Options options);

struct PartitionOptions {
    std::filesystem::path scene, machine, out, calibrate;
    std::vector<std::string> overrides;
    std::optional<std::string> ranks;
    bool weak = false, measure = false;
    int repetitions = 3;
};

/// Forecasts or measures the time of a step on several ranks. @note Collective
void partition(const PartitionOptions& options);

}  // namespace weavefront::app
