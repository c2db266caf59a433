#pragma once
/// @file
/// Values that fill and warp have in common, or each for itself.

#include <algorithm>
#include <optional>
#include <string_view>

#include "section.hpp"

namespace weavefront::scene {

/// A value of the fill and of the warp, SI.
struct Both {
    double fill = 0, warp = 0;

    [[nodiscard]] double least() const { return std::min(fill, warp); }
    [[nodiscard]] double most() const { return std::max(fill, warp); }
};

/// A quantity of fill and warp: one value for both, or a map of two. @param otherwise its default, of both;
/// absent: the key is required
inline Both both(Section& section, std::string_view key, const Dimension& dimension, const Range& range,
                 std::optional<double> otherwise = {}) {
    if (section.has_map(key))
        return section.required(key, [&](Section& each) {
            const double fill = each.quantity("fill", dimension, range);
            return Both{fill, each.quantity("warp", dimension, range)};
        });
    const double value = section.quantity(key, dimension, range, otherwise);
    return {value, value};
}

}  // namespace weavefront::scene
