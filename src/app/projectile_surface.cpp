#include "projectile_surface.hpp"

#include <cmath>
#include <numbers>

namespace weavefront::app {

namespace {

constexpr int around = 48, along_arc = 12;

struct ProfilePoint {
    double radius, z;
};

/// Points of an arc about (radius, z) from one angle to another, measured from the axis of the shot.
void add_arc(std::vector<ProfilePoint>& profile, double radius, double z, double arc, double from,
             double to) {
    for (int i = 0; i <= along_arc; ++i) {
        const double angle = from + (to - from) * i / along_arc;
        profile.push_back({radius + arc * std::sin(angle), z + arc * std::cos(angle)});
    }
}

/// Meridian from the nose to the rear.
std::vector<ProfilePoint> profile_of(const scene::Projectile& projectile) {
    constexpr double quarter_turn = std::numbers::pi / 2;
    const double radius = projectile.diameter / 2, edge = projectile.edge_radius;
    std::vector<ProfilePoint> profile;
    if (projectile.shape == scene::Shape::sphere) {
        add_arc(profile, 0, -radius, radius, 0, quarter_turn);
        add_arc(profile, 0, -radius, radius, quarter_turn, 2 * quarter_turn);
        return profile;
    }
    profile.push_back({0, 0});
    add_arc(profile, radius - edge, -edge, edge, 0, quarter_turn);
    add_arc(profile, radius - edge, edge - projectile.length, edge, quarter_turn, 2 * quarter_turn);
    profile.push_back({0, -projectile.length});
    return profile;
}

}  // namespace

io::Surface projectile_surface(const scene::Scene& scene) {
    io::Surface surface;
    if (!scene.projectile) return surface;
    const auto profile = profile_of(*scene.projectile);
    for (const auto& point : profile)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            surface.points.push_back(
                {point.radius * std::cos(angle), point.radius * std::sin(angle), point.z});
        }
    for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring)
        for (std::int64_t i = 0; i < around; ++i) {
            const auto first = static_cast<std::int64_t>(ring) * around, next = (i + 1) % around;
            surface.quads.push_back({first + i, first + next, first + around + next, first + around + i});
        }
    return surface;
}

}  // namespace weavefront::app
