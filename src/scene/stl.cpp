#include "stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <optional>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

using Point = std::array<double, 3>;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw InputError({fmt::format("{}: {}", name, what)});
}

/// Collects triangles and gives each place one number.
class Collector {
  public:
    explicit Collector(const std::string& name) : name_(name) {}

    void add(const Point& point) {
        for (const double x : point)
            if (!std::isfinite(x))
                refuse(name_, fmt::format("triangle {}: found a coordinate that is not finite",
                                          surface_.corners.size() + 1));
        const Point key{point[0] + 0.0, point[1] + 0.0, point[2] + 0.0};  // -0 becomes 0
        const auto [place, is_new] =
            numbers_.try_emplace(key, static_cast<std::int32_t>(surface_.points.size()));
        if (is_new) surface_.points.push_back(key);
        triangle_[corners_++] = place->second;
        if (corners_ < 3) return;
        surface_.corners.push_back(triangle_);
        corners_ = 0;
        if (surface_.corners.size() > most_triangles)
            refuse(name_, fmt::format("found more than {0} triangles, allowed at most {0}", most_triangles));
    }
    [[nodiscard]] bool in_triangle() const { return corners_ > 0; }
    [[nodiscard]] std::size_t triangles() const { return surface_.corners.size(); }
    [[nodiscard]] Triangles take() { return std::move(surface_); }

  private:
    const std::string& name_;
    Triangles surface_;
    std::map<Point, std::int32_t> numbers_;
    std::array<std::int32_t, 3> triangle_{};
    std::size_t corners_ = 0;
};

float float_at(std::string_view bytes, std::size_t at) {
    static_assert(std::endian::native == std::endian::little);
    float value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

constexpr std::size_t header = 84, record = 50;

std::uint32_t count_of_binary(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

Triangles parse_binary(std::string_view bytes, const std::string& name) {
    Collector collector(name);
    for (std::size_t i = 0; i < count_of_binary(bytes); ++i)
        for (std::size_t corner = 1; corner <= 3; ++corner) {  // the first vector is the normal
            const std::size_t at = header + i * record + corner * 12;
            collector.add({float_at(bytes, at), float_at(bytes, at + 4), float_at(bytes, at + 8)});
        }
    return collector.take();
}

/// The next word; empty: none.
std::string_view next_word(std::string_view& text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const auto word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

Triangles parse_ascii(std::string_view bytes, const std::string& name) {
    require_text(bytes, name);
    Collector collector(name);
    std::string_view rest = bytes.substr(std::min(bytes.find('\n'), bytes.size()));  // after the title
    for (auto word = next_word(rest); !word.empty(); word = next_word(rest)) {
        if (word == "endloop" && collector.in_triangle())
            refuse(name,
                   fmt::format("triangle {}: found less than three corners", collector.triangles() + 1));
        if (word == "endsolid") return collector.take();
        if (word != "vertex") continue;
        Point point{};
        for (double& x : point) {
            const auto text = next_word(rest);
            const auto number = finite_number(text);
            if (!number)
                refuse(name, fmt::format("triangle {}: found '{}', allowed a number",
                                         collector.triangles() + 1, printable(text)));
            x = *number;
        }
        collector.add(point);
    }
    refuse(name,
           fmt::format("found no 'endsolid' after triangle {}: the file is cut off", collector.triangles()));
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::array<const Point*, 3> corners_of(const Triangles& surface, std::size_t triangle) {
    std::array<const Point*, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
        corners[c] = &surface.points[static_cast<std::size_t>(surface.corners[triangle][c])];
    return corners;
}

std::string text_of(const Point& point) { return fmt::format("({}, {}, {})", point[0], point[1], point[2]); }

/// Messages on triangles without an area.
void find_degenerate(const Triangles& surface, const std::string& name, MessageList& faults) {
    constexpr double least_sine = 1e-10;
    for (std::size_t t = 0; t < surface.corners.size(); ++t) {
        const auto [a, b, c] = corners_of(surface, t);
        const Point along = minus(*b, *a), other = minus(*c, *a), normal = cross(along, other);
        const double longest =
            std::max({dot(along, along), dot(other, other), dot(minus(*c, *b), minus(*c, *b))});
        if (!(dot(normal, normal) > least_sine * least_sine * longest * longest))
            faults.add(
                fmt::format("{}: triangle {}: degenerate: found no area at {}", name, t + 1, text_of(*a)));
    }
}

/// Messages on edges that do not join two triangles of opposite way along them.
void find_open(const Triangles& surface, const std::string& name, MessageList& faults) {
    std::map<std::array<std::int32_t, 2>, std::size_t> first;  // directed edge, triangle
    for (std::size_t t = 0; t < surface.corners.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::array edge{surface.corners[t][c], surface.corners[t][(c + 1) % 3]};
            const auto [place, is_new] = first.try_emplace(edge, t);
            if (!is_new)
                faults.add(
                    fmt::format("{}: triangle {}: flipped against triangle {}: both run the same way "
                                "along their edge at {}",
                                name, t + 1, place->second + 1,
                                text_of(surface.points[static_cast<std::size_t>(edge[0])])));
        }
    for (const auto& [edge, t] : first)
        if (!first.contains({edge[1], edge[0]}))
            faults.add(fmt::format("{}: triangle {}: open edge: found no other triangle along {} to {}", name,
                                   t + 1, text_of(surface.points[static_cast<std::size_t>(edge[0])]),
                                   text_of(surface.points[static_cast<std::size_t>(edge[1])])));
}

/// Height at which the z axis meets a triangle. The axis is taken to pass an edge on its lower side, so a
/// closed surface is met an even number of times.
std::optional<double> height_on_axis(const std::array<const Point*, 3>& corners) {
    bool inside = false;
    for (std::size_t c = 0; c < 3; ++c) {
        const Point &a = *corners[c], &b = *corners[(c + 1) % 3];
        if ((a[1] > 0) == (b[1] > 0)) continue;
        if (a[0] - a[1] * (b[0] - a[0]) / (b[1] - a[1]) > 0) inside = !inside;
    }
    const Point normal = cross(minus(*corners[1], *corners[0]), minus(*corners[2], *corners[0]));
    if (!inside || normal[2] == 0) return std::nullopt;
    return dot(normal, *corners[0]) / normal[2];
}

}  // namespace

Triangles parse_stl(std::string_view bytes, const std::string& name) {
    if (bytes.size() >= header && bytes.size() == header + record * std::size_t{count_of_binary(bytes)})
        return parse_binary(bytes, name);
    if (bytes.starts_with("solid")) return parse_ascii(bytes, name);
    refuse(name, bytes.size() < header
                     ? fmt::format("found {} bytes, allowed an STL file, ASCII or binary", bytes.size())
                     : fmt::format("found {} bytes, {} for the {} triangles of its header, allowed an STL "
                                   "file, ASCII or binary",
                                   bytes.size(), header + record * std::size_t{count_of_binary(bytes)},
                                   count_of_binary(bytes)));
}

void require_closed(const Triangles& surface, const std::string& name) {
    MessageList faults;
    if (surface.corners.empty()) faults.add(fmt::format("{}: found no triangles", name));
    find_degenerate(surface, name, faults);
    find_open(surface, name, faults);
    faults.raise();
    double volume = 0;
    for (std::size_t t = 0; t < surface.corners.size(); ++t) {
        const auto [a, b, c] = corners_of(surface, t);
        volume += dot(*a, cross(*b, *c)) / 6;
    }
    if (!(volume > 0))
        refuse(name, "found triangles that look inward, allowed corners counter-clockwise seen from outside");
}

void move_nose_to_origin(Triangles& surface, const std::string& name) {
    double nose = -std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < surface.corners.size(); ++t)
        if (const auto height = height_on_axis(corners_of(surface, t))) nose = std::max(nose, *height);
    if (!std::isfinite(nose))
        refuse(name,
               "found a surface that the z axis misses, allowed one about it: the nose is where the axis "
               "leaves it towards +z");
    double size = 0;
    for (const auto& point : surface.points) size = std::max(size, std::abs(point[2] - nose));
    constexpr double rounding = 1e-9;  // a surface that was moved stays where it is
    if (std::abs(nose) <= rounding * size) return;
    for (auto& point : surface.points) point[2] -= nose;
}

bool is_symmetric(const Triangles& surface, std::size_t axis) {
    double size = 0;
    for (const auto& point : surface.points)
        for (const double x : point) size = std::max(size, std::abs(x));
    const double close = 1e-6 * size;
    auto sorted = surface.points;
    std::ranges::sort(sorted, {}, [](const Point& point) { return point[2]; });
    return std::ranges::all_of(surface.points, [&](Point mirrored) {
        mirrored[axis] = -mirrored[axis];
        auto at = std::ranges::lower_bound(sorted, mirrored[2] - close, {},
                                           [](const Point& point) { return point[2]; });
        for (; at != sorted.end() && (*at)[2] <= mirrored[2] + close; ++at) {
            const Point apart = minus(*at, mirrored);
            if (dot(apart, apart) <= close * close) return true;
        }
        return false;
    });
}

}  // namespace weavefront::scene
