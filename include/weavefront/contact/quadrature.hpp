#pragma once
/// @file
/// Integration points of contact.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "weavefront/contact/bilinear_quad.hpp"
#include "weavefront/mesh/vec3.hpp"
#include "weavefront/simd/lanes.hpp"

namespace weavefront::contact {

using namespace simd;

/// Up to eight points of a quad: shape functions and shares of its area. Lanes from `count` on are padding:
/// they repeat the last point with a share of 0.
struct QuadratureBatch {
    ShapeFunctions N{};
    Lanes share{};
    std::size_t count = 0;
};

using QuadratureRule = std::vector<QuadratureBatch>;

/// Midpoints of n x m equal cells of the parent square. n = 0: the corners, each with a quarter of the area.
QuadratureRule quadrature(int n, int m);

/// Rules of the elements of a mesh. Points are no farther apart than a spacing in the reference
/// configuration.
class Quadrature {
  public:
    /// @param spacing largest distance between points, m; none: contact at the nodes
    /// @param most    largest number of points along an edge
    explicit Quadrature(std::optional<double> spacing, int most = std::numeric_limits<int>::max())
        : spacing_(spacing), most_(most) {}

    /// Index of the rule for an element with these corners (m).
    std::int32_t rule_for(const std::array<Vec3, 4>& corners);

    /// Whether the points are the nodes.
    [[nodiscard]] bool at_nodes() const { return !spacing_; }

    /// The rule of an index that `rule_for` returned.
    [[nodiscard]] const QuadratureRule& rule(std::int32_t index) const {
        const auto& rule = rules_[static_cast<std::size_t>(index)];
        if (rule.points.empty()) rule.points = quadrature(rule.n, rule.m);
        return rule.points;
    }

    /// Corners of the part of an element that its points span, m. @param corners of the element, m
    [[nodiscard]] std::array<Vec3, 4> spanned(std::int32_t index, const std::array<Vec3, 4>& corners) const;

  private:
    struct Rule {
        int n, m;
        mutable QuadratureRule
            points;  ///< empty until first used, since most elements never come into contact
    };
    std::optional<double> spacing_;
    int most_;
    std::vector<Rule> rules_;
};

}  // namespace weavefront::contact
