#pragma once
/// @file
/// The meridian of a body of revolution: its outline in the half-plane through the axis.

#include <optional>
#include <vector>

#include "weavefront/body/shape.hpp"

namespace weavefront::body {

/// Point of the half-plane: distance from the axis and height, m.
struct MeridianPoint {
    double r, z;
};

/// Circle that an arc lies on. Angles are measured from the z axis towards +r, rad. An arc of growing angle
/// is convex.
struct Arc {
    MeridianPoint centre;
    double radius;  ///< m
    double from, to;
};

/// Straight line or arc of a meridian. The body lies on its right-hand side, looking in (r, z) along it.
struct Segment {
    MeridianPoint from, to;
    std::optional<Arc> arc;  ///< absent: a line
};

/// Connected segments from the foremost point of the axis to the rearmost one.
using Meridian = std::vector<Segment>;

/// A straight segment.
Segment line(const MeridianPoint& from, const MeridianPoint& to);

/// An arc about a centre.
Segment arc(const MeridianPoint& centre, double radius, double from, double to);

/// Appends the cylinder behind a nose, and the rear face. @param length of the body, m
void add_shank(Meridian& meridian, double radius, double length);

/// Volume, centroid and inertia of the body at uniform density.
MassProperties mass_of_revolution(const Meridian& meridian);

/// Points of an outline around the axis, and along an arc less 1.
struct Resolution {
    int around, along_arc;
};
inline constexpr Resolution for_pictures{48, 12}, fine{720, 90};

/// The surface of the body.
Outline revolve(const Meridian& meridian, const Resolution& resolution = for_pictures);

}  // namespace weavefront::body
