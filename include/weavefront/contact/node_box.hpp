#pragma once
/// @file
/// Boxes around positions or velocities of nodes.

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "weavefront/contact/surface.hpp"
#include "weavefront/simd/short_vectors.hpp"

namespace weavefront::contact {

/// Axis-aligned box around the positions or velocities of nodes. A fourth component of no meaning is carried
/// along: four numbers are loaded and compared as fast as one.
class NodeBox {
  public:
    NodeBox() = default;
    /// An empty box.
    [[nodiscard]] static NodeBox none() {
        NodeBox box;
        box.low_ = std::numeric_limits<double>::infinity() - simd::Double4{};
        box.high_ = -box.low_;
        return box;
    }
    NodeBox(std::span<const Vec3> values, std::int32_t first) : low_(load(values, first)), high_(low_) {}
    /// @param nodes of a facet
    NodeBox(std::span<const Vec3> values, const std::array<std::int32_t, 4>& nodes)
        : NodeBox(values, nodes[0]) {
        for (std::size_t a = 1; a < 4; ++a) add(values, nodes[a]);
    }
    explicit NodeBox(const Box& box)
        : low_{box.low.x(), box.low.y(), box.low.z(), 0},
          high_{box.high.x(), box.high.y(), box.high.z(), 0} {}

    void add(std::span<const Vec3> values, std::int32_t node) {
        const auto value = load(values, node);
        low_ = simd::min(low_, value);
        high_ = simd::max(high_, value);
    }
    void add(const NodeBox& other) {
        low_ = simd::min(low_, other.low_);
        high_ = simd::max(high_, other.high_);
    }
    /// Square of the largest distance of a value in this box to one in the other.
    [[nodiscard]] double squared_difference(const NodeBox& other) const {
        return squared_norm(simd::max(high_ - other.low_, other.high_ - low_));
    }
    /// Square of the distance between the boxes, 0 where they meet.
    [[nodiscard]] double squared_distance(const NodeBox& other) const {
        return squared_norm(simd::max(simd::max(other.low_ - high_, low_ - other.high_), simd::Double4{}));
    }

  private:
    [[nodiscard]] static simd::Double4 load(std::span<const Vec3> values, std::int32_t node) {
        const auto n = static_cast<std::size_t>(node);
        if (n + 1 == values.size())
            return simd::Double4{values[n].x(), values[n].y(), values[n].z(),
                                 0};  // no number follows the last one
        return simd::load<simd::Double4>(values[n].data());
    }
    /// The fourth component does not count.
    [[nodiscard]] static double squared_norm(const simd::Double4& a) {
        return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    }

    simd::Double4 low_, high_;
};

}  // namespace weavefront::contact
