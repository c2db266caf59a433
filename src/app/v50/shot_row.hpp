#pragma once
/// @file
/// One shot of `v50`: what is planned and what became of it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "weavefront/ballistics/limit_search.hpp"

namespace weavefront::app {

struct ShotRow {
    int number = 0;           ///< from 1
    std::size_t variant = 0;  ///< of V50Plan::variants
    double speed = 0;         ///< striking velocity, m/s
    std::string folder;       ///< name inside that of `v50`

    bool is_done = false;
    ballistics::Result result = ballistics::Result::none;
    std::string outcome = "planned";        ///< verdict; or stopped, failed, interrupted, planned
    std::string reason;                     ///< why there is no result
    std::optional<double> residual;         ///< velocity along the shot at the end, m/s; negative: rebound
    std::optional<double> absorbed_energy;  ///< that the projectile has lost, J
    std::optional<double> deflection;       ///< largest, of the back face, m
    std::optional<double> energy_error;     ///< closure error over the initial energy
    std::optional<std::int64_t> plies_perforated;
    bool is_stopped_by_guard = false, is_failed = false;
};

/// `shot_003_358.25`, with the speed in m/s.
std::string folder_of_shot(int number, double speed);

}  // namespace weavefront::app
