#pragma once
/// @file
/// Which facets may meet which.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// Facets of later plies over or under each owned facet, as seen along z.
struct Candidates {
    std::vector<std::int32_t> first{0};  ///< of each owned facet, into `facets`
    std::vector<std::int32_t> facets;    ///< ascending ply, then ascending global id

    [[nodiscard]] std::span<const std::int32_t> of(std::int32_t facet) const {
        const auto f = static_cast<std::size_t>(facet);
        return std::span(facets).subspan(static_cast<std::size_t>(first[f]), static_cast<std::size_t>(first[f + 1] - first[f]));
    }
};

/// Finds, for every alive owned facet, the alive facets of the next ply whose footprint in x and y comes within `reach`; where some of
/// these are eroded, also those of the ply behind, and so on. The result for a facet does not depend on which rank owns it.
Candidates find_candidates(const Surface& surface, std::span<const Vec3> x, double reach);

}  // namespace weavefront::contact
