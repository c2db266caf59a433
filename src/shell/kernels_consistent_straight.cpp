#include "feature_groups.hpp"

namespace weavefront::shell {

template std::unique_ptr<ElementGroup> make_feature_group<scene::Formulation::consistent, Yarns::straight>(
    const fabric::Features&, const scene::Fabric&, std::span<const GroupElement>);

}  // namespace weavefront::shell
