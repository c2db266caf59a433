#include "weavefront/ballistics/shot.hpp"

#include <algorithm>
#include <limits>

namespace weavefront::ballistics {

std::optional<MixedZone> mixed_zone(std::span<const Shot> shots) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    MixedZone zone{infinity, -infinity};
    for (const Shot& shot : shots)
        if (shot.is_complete)
            zone.lowest_complete = std::min(zone.lowest_complete, shot.speed);
        else
            zone.highest_partial = std::max(zone.highest_partial, shot.speed);
    if (zone.lowest_complete == infinity || zone.highest_partial == -infinity) return std::nullopt;
    return zone;
}

}  // namespace weavefront::ballistics
