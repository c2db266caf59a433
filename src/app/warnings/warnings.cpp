#include "warnings.hpp"

#include <algorithm>
#include <utility>

#include "warnings/subjects.hpp"
#include "weavefront/partition/contact_zone.hpp"

namespace weavefront::app {

namespace {

// What happens in an impact is over when the projectile and the wave have crossed the target a few times.
constexpr double most_crossings = 30;

/// Several projectiles may be alike.
void add_once(std::string phrase, Phrases& found) {
    if (std::ranges::find(found, phrase) == found.end()) found.push_back(std::move(phrase));
}

}  // namespace

std::vector<std::string> warnings(const scene::Scene& scene, const mesh::Panel& panel, double time_step) {
    const Shot shot{scene, panel, time_step, scene.largest_speed(), partition::largest_wave_speed(scene)};
    Phrases found;
    for (const auto& fabric : scene.fabrics) {
        warn_of_weave(shot, fabric, found);
        warn_of_material(shot, fabric, found);
    }
    warn_of_target(shot, found);
    for (const auto& projectile : scene.projectiles) {
        Phrases of_this;
        warn_of_projectile(shot, projectile, of_this);
        for (auto& phrase : of_this) add_once(std::move(phrase), found);
    }
    warn_of_overlaps(scene, found);
    warn_of_contact(shot, found);
    warn_of_controls(shot, found);
    return found;
}

double Shot::crossing() const {
    const double size = std::max(scene.target->size[0], scene.target->size[1]), slowest = scene.least_speed();
    return size / (slowest > 0 ? std::min(slowest, wave) : wave);
}

bool Shot::has_plausible_end() const {
    const bool begins = wave * scene.time.end >= scene.largest_diameter();
    return begins && scene.time.end >= time_step &&
           scene.time.end <= most_crossings * crossing() + scene.largest_delay();
}

std::array<double, 2> place_at(const scene::Projectile& projectile, double z) {
    const double time = (z - projectile.position[2]) / projectile.velocity[2];
    return {projectile.position[0] + projectile.velocity[0] * time,
            projectile.position[1] + projectile.velocity[1] * time};
}

}  // namespace weavefront::app
