#pragma once
/// @file
/// Frames whose every value is a closed form of frame, global id and component, exact in binary; model.py
/// holds the same forms.

#include "weavefront/io/results.hpp"

namespace weavefront::io {

/// Grid of 7 x 5 nodes, two plies, spread over the ranks without any order.
struct SyntheticModel {
    bool projectile = true;
    int rank = 0;
    int ranks = 1;

    [[nodiscard]] Topology topology() const;
    [[nodiscard]] Surface surface() const;
    [[nodiscard]] Frame frame(int k) const;
    [[nodiscard]] ResultsSetup setup(const std::filesystem::path& path, int max_frames) const;

    /// Whose item a global id is.
    [[nodiscard]] bool owns(std::int64_t id) const {
        return static_cast<int>(id * 7919 % 101 % ranks) == rank;
    }
};

}  // namespace weavefront::io
