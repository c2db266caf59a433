#pragma once
/// @file
/// summary.json: the outcome of a run for scripts.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Wall time of one phase of the time loop over the ranks, s.
struct PhaseTime {
    std::string name;
    double min = 0;
    double mean = 0;
    double max = 0;
};

/// What became of the shot.
struct ShotOutcome {
    std::string verdict;               ///< stopped, perforated, still moving, or passed without perforation
    std::optional<double> decided_at;  ///< s; null: it is not
    std::int64_t plies_perforated = 0;
    double peak_back_face_deflection = 0;  ///< m
    double deepest_penetration = 0;        ///< m
    std::array<double, 3> deepest_at{};    ///< its place, m
    std::int64_t deepest_ply = 0;          ///< 1 = struck first; 0: nothing ever was in contact
    std::optional<double> deepest_time;    ///< s
};

/// Of one of several projectiles.
struct ProjectileOutcome {
    std::string verdict;               ///< as that of ShotOutcome
    std::optional<double> decided_at;  ///< s; null: it is not
    std::int64_t plies_perforated = 0;
    double residual_velocity = 0;  ///< m/s
};

/// Outcome of a run; the keys of the file are the names of the members. SI units.
struct Summary {
    std::string status;                           ///< finished, stopped or interrupted
    std::string reason;                           ///< why it ended
    std::map<std::string, std::string> versions;  ///< of Weavefront and the libraries
    std::string scene_hash;
    std::string title;
    int ranks = 1;
    std::int64_t elements = 0;  ///< modelled
    std::int64_t nodes = 0;     ///< modelled
    std::int64_t steps = 0;
    double time = 0;                      ///< reached, s
    std::vector<PhaseTime> wall_seconds;  ///< in the order in which they are listed
    std::int64_t element_steps = 0;
    double nanoseconds_per_element_step = 0;
    std::optional<ShotOutcome> outcome;          ///< of the first projectile; null: there is none
    std::optional<double> residual_velocity;     ///< of the first projectile, m/s; null: there is none
    std::vector<ProjectileOutcome> projectiles;  ///< where there are several; empty: left out
    double max_displacement = 0;                 ///< m
    double back_face_deflection = 0;             ///< m
    double energy_error = 0;                     ///< 1
    std::int64_t broken_yarns = 0;               ///< element-directions, whole target
    std::int64_t eroded_elements = 0;            ///< whole target
    std::vector<std::optional<double>>
        first_break;  ///< time at which the first yarn of each ply broke, s; null: all whole
    std::vector<std::string> left_out;  ///< what the scene does not ask for
    std::string history_sha256;         ///< of history.csv, 64 hex digits
    std::string results_sha256;         ///< of results.vtkhdf; empty: not computed
};

/// Writes the summary as a whole or not at all: under a temporary name first, then renamed.
/// @param path     of the file; replaced
/// @param summary  read on rank 0
/// @throws NotFinite, FileError on all ranks
/// @note Collective
void write_summary(const std::filesystem::path& path, const Summary& summary,
                   const parallel::Communicator& comm);

}  // namespace weavefront::io
