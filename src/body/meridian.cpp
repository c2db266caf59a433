#include "meridian.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "weavefront/scene/trigonometry.hpp"

namespace weavefront::body {

namespace {

constexpr double pi = std::numbers::pi;

MeridianPoint point_of(const Arc& arc, double angle) {
    return {arc.centre.r + arc.radius * scene::sine(angle), arc.centre.z + arc.radius * scene::cosine(angle)};
}

/// Nodes and weights of Gauss and Legendre on [-1, 1], exact to degree 15: lines need degree 4 and arcs of a
/// quarter turn reach the rounding.
constexpr std::array<std::array<double, 2>, 4> gauss{{{0.1834346424956498, 0.3626837833783620},
                                                      {0.5255324099163290, 0.3137066458778873},
                                                      {0.7966664774136267, 0.2223810344533745},
                                                      {0.9602898564975363, 0.1012285362903763}}};

/// Integrals over the volume: 1, z, z2 and the square of the distance from the axis.
struct Moments {
    double volume = 0, z = 0, zz = 0, rr = 0;

    /// Disks of radius r along -dz.
    void add(const MeridianPoint& at, double dz) {
        const double disk = -pi * at.r * at.r * dz;
        volume += disk;
        z += disk * at.z;
        zz += disk * at.z * at.z;
        rr += disk * at.r * at.r / 2;
    }
};

void add_segment(const Segment& segment, Moments& moments) {
    constexpr int parts = 4;  // of an arc
    for (int part = 0; part < parts; ++part)
        for (const auto& [node, weight] : gauss)
            for (const double sign : {-1.0, 1.0}) {
                const double at = (part + (1 + sign * node) / 2) / parts, share = weight / (2 * parts);
                if (segment.arc) {
                    const auto& arc = *segment.arc;
                    const double turn = arc.to - arc.from, angle = arc.from + at * turn;
                    moments.add(point_of(arc, angle), -arc.radius * scene::sine(angle) * turn * share);
                } else {
                    const double dr = segment.to.r - segment.from.r, dz = segment.to.z - segment.from.z;
                    moments.add({segment.from.r + at * dr, segment.from.z + at * dz}, dz * share);
                }
            }
}

std::vector<MeridianPoint> points_of(const Meridian& meridian, int along_arc) {
    std::vector<MeridianPoint> points;
    for (std::size_t i = 0; i < meridian.size(); ++i) {
        const auto& [from, to, arc] = meridian[i];
        if (arc) {
            for (int k = 0; k <= along_arc; ++k)
                points.push_back(point_of(*arc, arc->from + (arc->to - arc->from) * k / along_arc));
            continue;
        }
        if (i == 0) points.push_back(from);
        if (i + 1 == meridian.size() || !meridian[i + 1].arc) points.push_back(to);
    }
    return points;
}

}  // namespace

Segment line(const MeridianPoint& from, const MeridianPoint& to) { return {from, to, std::nullopt}; }

Segment arc(const MeridianPoint& centre, double radius, double from, double to) {
    const Arc arc{centre, radius, from, to};
    return {point_of(arc, from), point_of(arc, to), arc};
}

void add_shank(Meridian& meridian, double radius, double length) {
    const MeridianPoint shoulder{radius, meridian.back().to.z}, rear{radius, -length};
    constexpr double rounding = 1e-9;
    if (shoulder.z - rear.z > rounding * radius) meridian.push_back(line(shoulder, rear));
    meridian.push_back(line(rear, {0, -length}));
}

MassProperties mass_of_revolution(const Meridian& meridian) {
    Moments moments;
    for (const auto& segment : meridian) add_segment(segment, moments);
    const double centroid = moments.z / moments.volume, about_axis = moments.rr / moments.volume,
                 across = about_axis / 2 + moments.zz / moments.volume - centroid * centroid;
    return {moments.volume, {0, 0, centroid}, Vec3(across, across, about_axis).asDiagonal()};
}

Outline revolve(const Meridian& meridian, const Resolution& resolution) {
    const int around = resolution.around;
    const auto points = points_of(meridian, resolution.along_arc);
    Outline outline;
    for (const auto& point : points)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * pi * i / around;
            outline.points.emplace_back(point.r * scene::cosine(angle), point.r * scene::sine(angle),
                                        point.z);
        }
    for (std::size_t ring = 0; ring + 1 < points.size(); ++ring)
        for (std::int64_t i = 0; i < around; ++i) {
            const auto first = static_cast<std::int64_t>(ring) * around, next = (i + 1) % around;
            outline.quads.push_back({first + i, first + next, first + around + next, first + around + i});
        }
    return outline;
}

}  // namespace weavefront::body
