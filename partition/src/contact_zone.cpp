#include "weavefront/partition/contact_zone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weavefront::partition {

namespace {

// Measured from 20 to 180 us in the 267 m/s example and from 17 to 69 us in the 550 m/s one. The zone holds
// 19 of 20 elements that are near contact.
constexpr double share_of_speeds = 0.24;

}  // namespace

double wave_speed(const scene::Fabric& fabric) {
    double squared = 0;
    for (const auto& system : fabric.systems())
        squared = std::max(squared, system.elastic.static_modulus * system.yarn.area /
                                        (system.spacing * fabric.areal_density));
    return std::sqrt(squared);
}

double largest_wave_speed(const scene::Scene& scene) {
    double largest = 0;
    for (const auto& ply : scene.target->plies)
        largest = std::max(largest, wave_speed(scene.fabrics[static_cast<std::size_t>(ply.fabric)]));
    return largest;
}

ContactZone::ContactZone(const scene::Scene& scene) : end_(scene.time.end) {
    plies_ = scene.contact.plies && scene.target->plies.size() > 1;
    if (scene.projectiles.empty() || (!plies_ && !scene.contact.projectile)) return;
    axes_.clear();
    for (const auto& projectile : scene.projectiles)
        axes_.push_back({projectile.position[0], projectile.position[1]});
    start_ = scene.largest_diameter() / 2;
    if (plies_)
        speed_ = share_of_speeds * std::cbrt(std::pow(largest_wave_speed(scene), 2) * scene.largest_speed());
}

double ContactZone::contact_time_share(double distance, double decay) const {
    double arrival = 1;  // over the length of the run
    if (distance < start_)
        arrival = 0;
    else if (speed_ > 0 && end_ > 0)
        arrival = std::min(1.0, (distance - start_) / (speed_ * end_));
    return 1 - arrival - decay / 2 * (1 - arrival * arrival);
}

std::vector<double> ContactZone::distances(const mesh::Panel& panel) const {
    std::vector<double> distances;
    distances.reserve(static_cast<std::size_t>(panel.columns()));
    for (std::int64_t column = 0; column < panel.columns(); ++column) {
        const auto corners = panel.footprint(column);
        const Vec3 centre = (panel.position(0, corners[0]) + panel.position(0, corners[2])) / 2;
        double nearest = std::numeric_limits<double>::max();
        for (const auto& [x, y] : axes_)
            nearest = std::min(nearest, std::hypot(centre.x() - x, centre.y() - y));
        distances.push_back(nearest);
    }
    return distances;
}

}  // namespace weavefront::partition
