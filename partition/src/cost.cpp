#include "weavefront/partition/cost.hpp"

#include <cmath>

#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/partition/machine.hpp"

namespace weavefront::partition {

std::vector<std::int32_t> column_costs(const mesh::Panel& panel, const scene::Scene& scene) {
    const auto& machine = committed_machine();
    const ContactZone zone(scene);
    const auto plies = static_cast<double>(panel.plies.size());
    const double everywhere = machine.element + machine.node + (zone.plies() ? machine.watch : 0);
    std::vector<std::int32_t> costs;
    costs.reserve(static_cast<std::size_t>(panel.columns()));
    for (const double distance : zone.distances(panel)) {
        const double contact = zone.contact_time_share(distance, machine.decay) * machine.touch +
                               zone.press_weight(distance) * machine.press;
        costs.push_back(static_cast<std::int32_t>(std::lround(1e9 * plies * (everywhere + contact))));
    }
    return costs;
}

}  // namespace weavefront::partition
