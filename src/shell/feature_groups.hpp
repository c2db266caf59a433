#pragma once
/// @file
/// The kernels of all sets of features, spread over several sources to be compiled side by side.

#include <memory>
#include <span>

#include "feature_group.hpp"

namespace weavefront::shell {

/// The group of a fabric whose fill and warp differ, or whose strength is scattered: one kernel for all of
/// either kind.
std::unique_ptr<ElementGroup> make_unequal_group(const fabric::Features& features,
                                                 const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements);

/// What the yarns of a set of features do: straight, crimped, crimped with friction. As fabric::feature_set
/// counts them.
enum class Yarns { straight, crimped, frictional };

/// The group of one formulation and kind of yarns, chosen by the remaining features.
template <scene::Formulation formulation, Yarns yarns, int remaining = 0>
std::unique_ptr<ElementGroup> make_feature_group(const fabric::Features& features,
                                                 const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements) {
    constexpr int index =
        16 * static_cast<int>(yarns) + 2 * remaining + (formulation == scene::Formulation::paper ? 1 : 0);
    constexpr auto candidate = fabric::feature_set(index);
    static_assert(candidate.formulation == formulation);
    if (features == candidate) return std::make_unique<FeatureGroup<candidate>>(fabric, elements);
    if constexpr (remaining < 7)
        return make_feature_group<formulation, yarns, remaining + 1>(features, fabric, elements);
    return nullptr;
}

extern template std::unique_ptr<ElementGroup>
make_feature_group<scene::Formulation::consistent, Yarns::straight>(const fabric::Features&,
                                                                    const scene::Fabric&,
                                                                    std::span<const GroupElement>);
extern template std::unique_ptr<ElementGroup>
make_feature_group<scene::Formulation::consistent, Yarns::crimped>(const fabric::Features&,
                                                                   const scene::Fabric&,
                                                                   std::span<const GroupElement>);
extern template std::unique_ptr<ElementGroup>
make_feature_group<scene::Formulation::consistent, Yarns::frictional>(const fabric::Features&,
                                                                      const scene::Fabric&,
                                                                      std::span<const GroupElement>);
extern template std::unique_ptr<ElementGroup> make_feature_group<scene::Formulation::paper, Yarns::straight>(
    const fabric::Features&, const scene::Fabric&, std::span<const GroupElement>);
extern template std::unique_ptr<ElementGroup> make_feature_group<scene::Formulation::paper, Yarns::crimped>(
    const fabric::Features&, const scene::Fabric&, std::span<const GroupElement>);
extern template std::unique_ptr<ElementGroup>
make_feature_group<scene::Formulation::paper, Yarns::frictional>(const fabric::Features&,
                                                                 const scene::Fabric&,
                                                                 std::span<const GroupElement>);

}  // namespace weavefront::shell
