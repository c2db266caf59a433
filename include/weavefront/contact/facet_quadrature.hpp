#pragma once
/// @file
/// The integration points of every owned facet.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "weavefront/contact/quadrature.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/mesh/repeated.hpp"

namespace weavefront::contact {

/// Assigns each owned facet the quadrature rule of its initial shape. Rules repeat from ply to ply, as the
/// initial areas do.
class FacetQuadrature {
  public:
    /// @param spacing largest distance between points, m; none: contact at the nodes
    /// @param x       initial positions, m
    /// @param most    largest number of points along an edge
    FacetQuadrature(std::optional<double> spacing, const Surface& surface, std::span<const Vec3> x,
                    int most = std::numeric_limits<int>::max());

    /// Whether the points are the nodes.
    [[nodiscard]] bool at_nodes() const { return quadrature_.at_nodes(); }

    /// Points of an owned facet.
    [[nodiscard]] const QuadratureRule& rule(std::int32_t facet) const {
        return quadrature_.rule(rules_[static_cast<std::size_t>(facet)]);
    }

    /// Corners of the part of an owned facet that its points span.
    /// @param corners present corners of the facet, m
    [[nodiscard]] std::array<Vec3, 4> spanned(std::int32_t facet, const std::array<Vec3, 4>& corners) const {
        return quadrature_.spanned(rules_[static_cast<std::size_t>(facet)], corners);
    }

  private:
    Quadrature quadrature_;
    mesh::Repeated<std::int32_t> rules_;
};

}  // namespace weavefront::contact
