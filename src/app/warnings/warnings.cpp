#include "warnings.hpp"

#include <algorithm>
#include <cmath>

#include "warnings/subjects.hpp"
#include "weavefront/partition/contact_zone.hpp"

namespace weavefront::app {

namespace {

// What happens in an impact is over when the projectile and the wave have crossed the target a few times.
constexpr double most_crossings = 30;

}  // namespace

std::vector<std::string> warnings(const scene::Scene& scene, const mesh::Panel& panel, double time_step) {
    const auto speed_of = [](const scene::Projectile& projectile) {
        const auto& v = projectile.velocity;
        return std::hypot(v[0], v[1], v[2]);
    };
    const Shot shot{scene, panel, time_step, scene.projectile ? speed_of(*scene.projectile) : 0,
                    partition::largest_wave_speed(scene)};
    Phrases found;
    for (const auto& fabric : scene.fabrics) {
        warn_of_weave(shot, fabric, found);
        warn_of_material(shot, fabric, found);
    }
    warn_of_target(shot, found);
    if (scene.projectile) warn_of_projectile(shot, found);
    warn_of_contact(shot, found);
    warn_of_controls(shot, found);
    return found;
}

double Shot::crossing() const {
    const double size = std::max(scene.target->size[0], scene.target->size[1]);
    return size / (speed > 0 ? std::min(speed, wave) : wave);
}

bool Shot::has_plausible_end() const {
    const bool begins = !scene.projectile || wave * scene.time.end >= scene.projectile->diameter;
    return begins && scene.time.end >= time_step && scene.time.end <= most_crossings * crossing();
}

std::array<double, 2> place_at(const scene::Projectile& projectile, double z) {
    const double time = (z - projectile.position[2]) / projectile.velocity[2];
    return {projectile.position[0] + projectile.velocity[0] * time,
            projectile.position[1] + projectile.velocity[1] * time};
}

}  // namespace weavefront::app
