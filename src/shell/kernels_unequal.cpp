#include "feature_groups.hpp"

namespace weavefront::shell {

std::unique_ptr<ElementGroup> make_unequal_group(const fabric::Features& features,
                                                 const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements) {
    if (features.scatter)
        return std::make_unique<FeatureGroup<fabric::any_scattered_fabric>>(fabric, elements);
    return std::make_unique<FeatureGroup<fabric::any_unequal_fabric>>(fabric, elements);
}

}  // namespace weavefront::shell
