#pragma once
/// @file
/// The state of contact points between plies that lasts from step to step.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "weavefront/contact/coulomb.hpp"
#include "weavefront/contact/facet_memory.hpp"
#include "weavefront/contact/normal_rays.hpp"
#include "weavefront/contact/penalty.hpp"

namespace weavefront::contact {

/// Penetrations of the points of one facet, [batch].
using FacetPoints = std::array<PenetrationLanes, most_batches>;
/// Tractions of the points of one facet, [batch][lane].
using FacetTractions = std::array<std::array<TangentialTraction, batch_width>, most_batches>;

/// Penetrations and tractions of the facets in contact, and the dissipated budget of every owned facet.
/// Facets without contact have no penetrations and take no memory for them. Without friction there are no
/// tractions.
class PointMemory {
  public:
    /// @param facets   number of owned facets
    /// @param friction whether points have tractions
    explicit PointMemory(std::size_t facets, bool friction = false)
        : penetrations_(static_cast<std::int32_t>(facets)), dissipated_budgets_(facets) {
        if (friction) tractions_.emplace(static_cast<std::int32_t>(facets));
    }

    /// Whether a facet has penetrations.
    [[nodiscard]] bool holds(std::int32_t facet) const { return penetrations_.find(facet) != nullptr; }

    /// Penetrations of a facet; zero where it has none.
    [[nodiscard]] FacetPoints recall(std::int32_t facet) const {
        const auto* points = penetrations_.find(facet);
        return points ? *points : FacetPoints{};
    }
    /// The largest penetration of a facet's points, m; 0: none presses.
    [[nodiscard]] double largest(std::int32_t facet) const {
        double most = 0;
        if (const auto* points = penetrations_.find(facet))
            for (const auto& batch : *points)
                for (std::size_t i = 0; i < batch_width; ++i)
                    most = std::max(most, batch.overlap[i] - batch.ignored[i]);
        return most;
    }
    /// Replaces the penetrations of a facet.
    void keep(std::int32_t facet, const FacetPoints& points) { penetrations_.take(facet) = points; }
    /// Drops the penetrations and tractions of a facet. Its dissipated budget stays.
    void forget(std::int32_t facet) {
        penetrations_.forget(facet);
        if (tractions_) tractions_->forget(facet);
    }

    /// Tractions of a facet; zero where it had none. They hold until those of another facet are taken.
    /// @pre points have friction
    [[nodiscard]] FacetTractions& tractions(std::int32_t facet) { return tractions_->take(facet); }

    /// Dissipated budget of a facet, J/m2: see PenaltyLaw.
    [[nodiscard]] double& dissipated_budget(std::int32_t facet) {
        return dissipated_budgets_[static_cast<std::size_t>(facet)];
    }

    /// State of a facet, for an archive of module `state`.
    template <class Archive>
    void state(Archive& archive, std::int32_t facet) {
        auto& budget = dissipated_budget(facet);
        if (archive.size("dissipated_budget", budget != 0 ? 1 : 0) > 0) archive("dissipated_budget", budget);
        constexpr std::size_t points_of_facet = most_batches * batch_width;
        if (archive.size("overlap", holds(facet) ? points_of_facet : 0) == 0) return;
        FacetPoints points = recall(facet);
        for (auto& batch : points)
            for (std::size_t i = 0; i < batch_width; ++i) {
                Penetration point{batch.overlap[i], batch.ignored[i], batch.opened[i]};
                point.state(archive);
                batch.overlap[i] = point.overlap;
                batch.ignored[i] = point.ignored;
                batch.opened[i] = point.opened;
            }
        if constexpr (Archive::reads) keep(facet, points);
        if (!tractions_) return;
        for (auto& batch : tractions(facet))
            for (auto& point : batch) point.state(archive);
    }

  private:
    FacetMemory<FacetPoints> penetrations_;
    std::optional<FacetMemory<FacetTractions>> tractions_;
    std::vector<double> dissipated_budgets_;  ///< J/m2
};

}  // namespace weavefront::contact
