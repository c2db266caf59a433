#include "projectile_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stl.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

using Pair = std::array<double, 2>;

constexpr std::size_t most_bytes = 50'000'000, most_points = 1000;

/// Length of one unit of a file, m.
double scale_of(Section& section) { return section.quantity("scale", length, positive, 1e-3); }

/// Rows `r, z` of a CSV file, after a header or none.
std::vector<Pair> rows_of(const std::string& text, const std::string& name) {
    require_text(text, name);
    std::vector<Pair> rows;
    std::string_view rest = text;
    for (int number = 1; !rest.empty(); ++number) {
        const auto line = trimmed(rest.substr(0, rest.find('\n')));
        rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1);
        const auto comma = line.find(',');
        const auto r = finite_number(line.substr(0, comma)),
                   z = comma == line.npos ? std::nullopt : finite_number(line.substr(comma + 1));
        if (r && z)
            rows.push_back({*r, *z});
        else if (!line.empty() && number > 1)
            throw InputError(
                {fmt::format("{}:{}: found '{}', allowed two numbers r, z", name, number, printable(line))});
        if (rows.size() > most_points)
            throw InputError(
                {fmt::format("{0}: found more than {1} points, allowed at most {1}", name, most_points)});
    }
    return rows;
}

double cross(const Pair& a, const Pair& b, const Pair& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross_each_other(const Pair& a, const Pair& b, const Pair& c, const Pair& d) {
    return cross(a, b, c) * cross(a, b, d) < 0 && cross(c, d, a) * cross(c, d, b) < 0;
}

/// What is wrong with a meridian; empty: nothing.
std::string fault_of(const std::vector<Pair>& points) {
    if (points.size() < 3) return fmt::format("{} points, allowed at least 3", points.size());
    if (points.front()[0] != 0 || points.back()[0] != 0)
        return "ends off the axis, allowed r = 0 at the first and the last point";
    if (points.front()[1] <= points.back()[1])
        return "the rear first, allowed from the nose (larger z) to the rear";
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i][0] < 0) return fmt::format("r below 0 at point {}, allowed r of at least 0", i);
        if (i > 0 && points[i] == points[i - 1])
            return fmt::format("point {} again at point {}, allowed different points", i - 1, i);
        if (i > 0 && i + 1 < points.size() && points[i][0] == 0)
            return fmt::format("point {} on the axis, allowed there the first and the last point only", i);
        for (std::size_t j = 0; j + 1 < i; ++j)
            if (i + 1 < points.size() && cross_each_other(points[j], points[j + 1], points[i], points[i + 1]))
                return fmt::format("lines that cross after points {} and {}, allowed none", j, i);
    }
    return {};
}

bool takes_file(Section& section, std::string_view other) {
    if (!section.has("file")) return false;
    section.refuse_if(section.has(other), other, "none beside file, which gives them");
    return true;
}

/// Corners of triangles as whole numbers. @param points how many there are
std::vector<std::array<std::int32_t, 3>> corners_of(Section& section, std::size_t points) {
    std::vector<std::array<std::int32_t, 3>> corners;
    for (const auto& triangle : section.vectors<3>("triangles", ratio, any_value, most_triangles)) {
        auto& numbers = corners.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) {
            const double number = triangle[c];
            if (number >= 0 && number < static_cast<double>(points) && number == std::floor(number)) {
                numbers[c] = static_cast<std::int32_t>(number);
                continue;
            }
            section.refuse_item_if(true, "triangles", corners.size() - 1,
                                   fmt::format("three whole numbers from 0 to {}, of points", points - 1));
            return {};
        }
    }
    return corners;
}

}  // namespace

std::vector<Pair> profile_points(Section& section) {
    std::vector<Pair> points;
    const bool from_file = takes_file(section, "points");
    const std::string_view key = from_file ? "file" : "points";
    if (from_file) {
        const double scale = scale_of(section);
        points = rows_of(section.file("file", most_bytes), section.text("file", ""));
        for (auto& [r, z] : points) r *= scale, z *= scale;
    } else {
        points = section.vectors<2>("points", length, any_value, most_points);
        if (!section.has_list("points")) return {};
    }
    for (const auto& [r, z] : points)
        if (!std::isfinite(r) || !std::isfinite(z)) return {};
    if (const auto fault = fault_of(points); !fault.empty()) {
        const auto comma = fault.find(", allowed ");
        section.refuse(key, fault.substr(0, comma), fault.substr(comma + 10));
        return {};
    }
    const double nose = points.front()[1];
    for (auto& point : points) point[1] -= nose;
    return points;
}

Triangles mesh_triangles(Section& section) {
    Triangles surface;
    std::string name = "projectile";
    if (takes_file(section, "points")) {
        section.refuse_if(section.has("triangles"), "triangles", "none beside file, which gives them");
        const double scale = scale_of(section);
        name = section.text("file", "");
        surface = parse_stl(section.file("file", most_bytes), name);
        require_closed(surface, name);
        for (auto& point : surface.points)
            for (double& x : point) x *= scale;
    } else {
        if (!section.has("points") && !section.has("triangles")) {
            section.refuse("file", "nothing", "the name of an STL file");
            return {};
        }
        surface.points = section.vectors<3>("points", length, any_value, 3 * most_triangles);
        surface.corners = corners_of(section, surface.points.size());
        for (const auto& point : surface.points)
            for (const double x : point)
                if (!std::isfinite(x)) return {};
        if (surface.corners.empty()) return {};
        require_closed(surface, name);
    }
    move_nose_to_origin(surface, name);
    return surface;
}

}  // namespace weavefront::scene
