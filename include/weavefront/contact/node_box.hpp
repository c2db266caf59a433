#pragma once
/// @file
/// Boxes around positions or velocities of nodes.

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Axis-aligned box around the positions or velocities of nodes. A fourth component of no meaning is carried
/// along: four numbers are loaded and compared as fast as one.
class NodeBox {
  public:
    NodeBox() = default;
    /// An empty box.
    [[nodiscard]] static NodeBox none() {
        NodeBox box;
        box.low_.setConstant(std::numeric_limits<double>::infinity());
        box.high_ = -box.low_;
        return box;
    }
    NodeBox(std::span<const Vec3> values, std::int32_t first) : low_(load(values, first)), high_(low_) {}
    /// @param nodes of a facet
    NodeBox(std::span<const Vec3> values, const std::array<std::int32_t, 4>& nodes)
        : NodeBox(values, nodes[0]) {
        for (std::size_t a = 1; a < 4; ++a) add(values, nodes[a]);
    }
    explicit NodeBox(const Box& box) {
        low_ << box.low.array(), 0;
        high_ << box.high.array(), 0;
    }

    void add(std::span<const Vec3> values, std::int32_t node) {
        const auto value = load(values, node);
        low_ = low_.min(value);
        high_ = high_.max(value);
    }
    void add(const NodeBox& other) {
        low_ = low_.min(other.low_);
        high_ = high_.max(other.high_);
    }
    /// Square of the largest distance of a value in this box to one in the other.
    [[nodiscard]] double squared_difference(const NodeBox& other) const {
        return (high_ - other.low_).max(other.high_ - low_).head<3>().matrix().squaredNorm();
    }
    /// Square of the distance between the boxes, 0 where they meet.
    [[nodiscard]] double squared_distance(const NodeBox& other) const {
        return (other.low_ - high_).max(low_ - other.high_).max(0).head<3>().matrix().squaredNorm();
    }

  private:
    [[nodiscard]] static Eigen::Array4d load(std::span<const Vec3> values, std::int32_t node) {
        const auto n = static_cast<std::size_t>(node);
        if (n + 1 == values.size())
            return {values[n].x(), values[n].y(), values[n].z(), 0};  // no number follows the last one
        return Eigen::Map<const Eigen::Array4d>(values[n].data());
    }

    Eigen::Array4d low_, high_;
};

}  // namespace weavefront::contact
