#pragma once
/// @file
/// Shots as the statistics of a limit velocity see them.

#include <optional>
#include <span>
#include <vector>

namespace weavefront::ballistics {

/// A shot with a result.
struct Shot {
    double speed = 0;          ///< striking velocity, m/s
    bool is_complete = false;  ///< complete penetration; else partial
};

/// Speeds between which partial and complete penetrations lie side by side.
struct MixedZone {
    double lowest_complete = 0, highest_partial = 0;  ///< m/s

    /// Whether a partial penetration lies above a complete one.
    [[nodiscard]] bool exists() const { return highest_partial > lowest_complete; }
    /// m/s; at most 0: there is no such zone
    [[nodiscard]] double width() const { return highest_partial - lowest_complete; }
};

/// The zone of mixed results. @return none: all shots are partial, or all complete
std::optional<MixedZone> mixed_zone(std::span<const Shot> shots);

}  // namespace weavefront::ballistics
