#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr Range jaw_pressure{0, false, 1e9, " greater than 0, at most 1 GPa"};

Clamp read_clamp(Section& section) {
    Clamp clamp;
    clamp.pressure = section.quantity("pressure", pressure, jaw_pressure);
    clamp.friction = read_friction(section, {}).value_or(Friction{});
    section.refuse_if(clamp.friction.static_coefficient == 0, "friction",
                      "greater than 0: without friction a clamp is an edge that is sliding");
    return clamp;
}

void read_edges(Section& section, Target& target) {
    for (const auto& [name, axis] : axis_names) {
        if (section.has_map(name)) {
            target.edges[axis] = Edge::clamp;
            target.clamps[axis] =
                section.required(name, [](Section& edge) { return edge.required("clamp", read_clamp); });
        } else {
            target.edges[axis] = section.choice(name, edge_names, Edge::fixed);
        }
    }
}

bool needs_frame(Edge edge) { return edge == Edge::frame || edge == Edge::clamp; }

/// Of the edges that may end at an opening.
bool may_have_opening(Edge edge) { return needs_frame(edge) || edge == Edge::fixed; }

void read_straight_bars(Section& opening, const Target& target, Frame& frame) {
    for (const auto& [name, axis] : axis_names) {
        const auto edge = target.edges[axis];
        opening.refuse_if(!may_have_opening(edge) && opening.has(name), name,
                          fmt::format("only where edges.{} is frame, fixed or a clamp", name));
        if (!needs_frame(edge) && !(may_have_opening(edge) && opening.has(name))) continue;
        frame.half_opening[axis] = opening.quantity(name, length, positive) / 2;
        opening.refuse_if(*frame.half_opening[axis] >= target.size[axis] / 2, name,
                          fmt::format("less than the target's {}, which rests on both sides of it",
                                      text_of(target.size[axis], opening.unit_of(name, length), 6)));
    }
}

void read_round(Section& opening, const Target& target, Frame& frame) {
    const double least = std::min(target.size[0], target.size[1]);
    frame.radius = opening.quantity("diameter", length, positive) / 2;
    opening.refuse_if(2 * *frame.radius >= least, "diameter",
                      fmt::format("less than {}, the smaller size of the target",
                                  text_of(least, opening.unit_of("diameter", length), 6)));
    opening.refuse_if(!may_have_opening(target.edges[0]) || !may_have_opening(target.edges[1]) ||
                          target.edges[0] != target.edges[1] || target.clamps[0] != target.clamps[1],
                      "diameter", "only where both edges are frame, both fixed, or both the same clamp");
}

Frame read_frame(Section& section, const Target& target) {
    Frame frame;
    frame.edge_radius = section.quantity("edge_radius", length, non_negative, 1e-3);
    section.required("opening", [&](Section& opening) {
        if (opening.has("diameter"))
            read_round(opening, target, frame);
        else
            read_straight_bars(opening, target, frame);
        return frame;
    });
    const bool is_open = frame.radius || frame.half_opening[0] || frame.half_opening[1];
    section.refuse_if(!is_open && section.has_map("opening"), "opening", "x, y or diameter");
    return frame;
}

}  // namespace

void read_supports(Section& section, Target& target) {
    section.optional("edges", [&](Section& edges) {
        read_edges(edges, target);
        return target.edges;
    });
    const bool is_needed = std::ranges::any_of(target.edges, needs_frame),
               is_allowed = std::ranges::any_of(target.edges, may_have_opening);
    section.refuse_if(!is_allowed && section.has("frame"), "frame",
                      "only with an edge that is frame, fixed or a clamp, such as edges: {x: frame}");
    if (!is_needed && !(is_allowed && section.has("frame"))) return;
    target.frame = section.required("frame", [&](Section& frame) { return read_frame(frame, target); });
}

}  // namespace weavefront::scene
