#include "feature_groups.hpp"

namespace weavefront::shell {

std::unique_ptr<ElementGroup> make_unequal_group(const scene::Fabric& fabric,
                                                 std::span<const GroupElement> elements) {
    return std::make_unique<FeatureGroup<fabric::any_unequal_fabric>>(fabric, elements);
}

}  // namespace weavefront::shell
