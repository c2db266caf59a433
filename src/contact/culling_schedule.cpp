#include "weavefront/contact/culling_schedule.hpp"

#include <cmath>

namespace weavefront::contact {

namespace {

// Lengths over the contact distance. A facet with less clearance than the first is evaluated in every step.
// Relative motion by the second makes a recheck of such a facet worth its cost.
constexpr double worthwhile_in_distance = 0.001, recheck_in_distance = 0.015;

// A facet follows its own candidates where the group's last step would use its clearance up in fewer steps
// than this. Following them for a step costs about a tenth of a recheck.
constexpr double steps_worth_own_candidates = 10;

/// Whether the candidates reach past the next ply: that ply has a hole or a free edge here.
bool looks_through_hole(const FacetRanges& candidates, std::int32_t ply, const Surface& surface) {
    return !candidates.empty() && surface.facets[static_cast<std::size_t>(candidates.back())].ply > ply + 1;
}

}  // namespace

CullingSchedule::CullingSchedule(const Surface& surface, std::span<const Vec3> x)
    : bound_(surface, x),
      states_(static_cast<std::size_t>(surface.owned)),
      due_(static_cast<std::size_t>(bound_.groups())) {}

void CullingSchedule::rebuild(const Surface& surface, const Candidates& candidates, std::span<const Vec3> x) {
    bound_.rebuild(surface, candidates, x);
    for (std::int32_t group = 0; group < bound_.groups(); ++group) {
        const auto states = states_of(group);
        for (std::size_t k = 0; k < states.size(); ++k) {
            auto& state = states[k];
            const auto f = bound_.facets(group)[k];
            const auto ply = surface.facets[static_cast<std::size_t>(f)].ply;
            // The clearance of the group does not cover facets that come into view through a hole.
            const bool clearance_holds =
                state.culled == Culled::by_group && !looks_through_hole(candidates.of(f), ply, surface);
            if (!clearance_holds) state = {};
            state.nearest = -1;
            state.near = {};
        }
    }
    std::ranges::fill(due_, 0);
}

double CullingSchedule::own_approach(std::int32_t f, const Shortlist& near, const CullingInput& input) {
    if (near.slots == 0) return 0;
    const auto velocities_of = [&](std::int32_t facet) {
        return NodeBox(input.nodes.v, input.surface.facets[static_cast<std::size_t>(facet)].nodes);
    };
    auto others = NodeBox::none();
    input.candidates.of(f).visit_some(near.slots, [&](std::int32_t candidate) {
        others.add(velocities_of(candidate));
        return true;
    });
    return input.nodes.dt * std::sqrt(velocities_of(f).squared_difference(others));
}

void CullingSchedule::recheck(State& state, std::int32_t f, std::int32_t group,
                              const CullingInput& input) const {
    const auto& [surface, all_candidates, distances, quadrature, memory, nodes] = input;
    const auto& facet = surface.facets[static_cast<std::size_t>(f)];
    const auto corners = corners_of(facet.nodes, nodes.x);
    const auto candidates = all_candidates.of(f);
    const ContactPoints points(quadrature.rule(f), corners, quadrature.spanned(f, corners));
    const ClearanceQuery query{facet.ply, points, candidates, surface, distances, nodes.x};
    const double accumulated = bound_.accumulated(group),
                 worthwhile = worthwhile_in_distance * distances.most();
    const bool in_contact = memory.holds(f);
    const double clear =
        in_contact ? 0 : clearance(query, state.nearest, state.near, accumulated, worthwhile);
    if (clear > steps_worth_own_candidates * bound_.of_last_step(group)) {
        state.culled = Culled::by_group;
        state.until = not_above(accumulated + clear);
    } else if (clear > 0) {
        state.culled = Culled::by_candidates;
        state.until = not_above(clear);
    } else {
        state.culled = Culled::no;
    }
    const bool is_culled = state.culled != Culled::no;
    if (is_culled && state.nearest >= 0) return;
    const auto nearest = find_nearest(query, centre_of(corners));
    state.nearest = is_culled || nearest.lead > worthwhile ? nearest.facet : -1;
    if (is_culled) return;
    // The nearest candidate is known to stay so for its lead. A facet out of contact may be clear before.
    const double soon = recheck_in_distance * distances.most();
    const double known = in_contact ? nearest.lead : std::min(nearest.lead, soon);
    state.until = not_above(accumulated + (state.nearest < 0 ? soon : known));
}

}  // namespace weavefront::contact
