#include <stdexcept>

#include "feature_groups.hpp"

namespace weavefront::shell {

namespace {

template <scene::Formulation formulation>
std::unique_ptr<ElementGroup> of_formulation(const fabric::Features& features, const scene::Fabric& fabric,
                                             std::span<const GroupElement> elements) {
    if (!features.crimp) return make_feature_group<formulation, Yarns::straight>(features, fabric, elements);
    if (!features.friction)
        return make_feature_group<formulation, Yarns::crimped>(features, fabric, elements);
    return make_feature_group<formulation, Yarns::frictional>(features, fabric, elements);
}

}  // namespace

std::unique_ptr<ElementGroup> make_element_group(const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements) {
    const auto features = fabric::features_of(fabric);
    if (features.unequal) return make_unequal_group(features, fabric, elements);
    auto group = features.paper()
                     ? of_formulation<scene::Formulation::paper>(features, fabric, elements)
                     : of_formulation<scene::Formulation::consistent>(features, fabric, elements);
    if (!group) throw std::logic_error("no kernel for the features of fabric " + fabric.name);
    return group;
}

}  // namespace weavefront::shell
