#include "weavefront/contact/ply_pair_laws.hpp"

#include <algorithm>

namespace weavefront::contact {

PlyPairLaws::PlyPairLaws(const scene::ContactLaw& law, const std::vector<PlyProperties>& plies) {
    std::vector<double> different;
    for (const auto& ply : plies) {
        const auto found = std::ranges::find(different, ply.areal_density);
        densities_.push_back(static_cast<std::size_t>(found - different.begin()));
        if (found == different.end()) different.push_back(ply.areal_density);
    }
    density_count_ = different.size();
    for (const double one : different)
        for (const double other : different) laws_.emplace_back(law, one * other / (one + other));
}

}  // namespace weavefront::contact
