#pragma once
/// @file
/// The schedule of facets that contact between plies evaluates in a step.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "weavefront/contact/candidates.hpp"
#include "weavefront/contact/clearance_query.hpp"
#include "weavefront/contact/contact_distances.hpp"
#include "weavefront/contact/facet_quadrature.hpp"
#include "weavefront/contact/nodal_motion.hpp"
#include "weavefront/contact/point_memory.hpp"
#include "weavefront/contact/relative_motion_bound.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::contact {

/// State of contact that the schedule reads in a step.
struct CullingInput {
    const Surface& surface;
    const Candidates& candidates;
    const ContactDistances& distances;
    const FacetQuadrature& quadrature;
    const PointMemory& memory;
    NodalMotion nodes;
};

/// Culls facets that cannot touch anything yet. The clearance of a facet is its distance to the nearest
/// candidate, less the contact distance. A culled facet is not looked at again until relative motion may have
/// used its clearance up. Therefore culling changes no force.
class CullingSchedule {
  public:
    /// Starts with all owned facets due. @param x initial positions, m
    CullingSchedule(const Surface& surface, std::span<const Vec3> x);

    /// Adopts new candidates. Local indices of ghosts may have changed, and facets may have been eroded.
    /// @param x present positions, m
    void rebuild(const Surface& surface, const Candidates& candidates, std::span<const Vec3> x);

    /// Advances by one step and visits all facets that may touch something.
    /// @param evaluate called with a facet and with its nearest candidate, -1 if not known; it updates
    ///                 `input.memory`
    template <class Evaluate>
    void for_each_active(const CullingInput& input, const Evaluate& evaluate) {
        bound_.advance(input.nodes.v, input.nodes.dt);
        for (std::int32_t group = 0; group < bound_.groups(); ++group)
            if (bound_.accumulated(group) >= due_[static_cast<std::size_t>(group)])
                visit_group(group, input, evaluate);
    }

  private:
    enum class Culled : std::uint8_t {
        no,             ///< evaluated in every step
        by_group,       ///< until the relative motion of its group uses its clearance up
        by_candidates,  ///< until that of its own near candidates does: a closer bound at a higher cost
    };
    /// State of a facet. Every element of a rank has one, so it is packed.
    struct [[gnu::packed]] State {
        /// By `culled`: relative motion of the group at which a facet is rechecked, or the clearance that is
        /// left towards its own near candidates, m.
        float until = 0;
        std::int32_t nearest = -1;  ///< candidate; -1: not known. A culled facet keeps the last one known.
        Shortlist near;
        Culled culled = Culled::no;
    };
    static_assert(sizeof(State) == 17);

    template <class Evaluate>
    void visit_group(std::int32_t group, const CullingInput& input, const Evaluate& evaluate) {
        const double accumulated = bound_.accumulated(group);
        const auto states = states_of(group);
        const auto facets = bound_.facets(group);
        double due = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k < states.size(); ++k) {
            auto& state = states[k];
            const auto f = facets[k];
            if (!input.surface.alive[static_cast<std::size_t>(f)]) continue;
            if (expired(state, f, accumulated, input)) recheck(state, f, group, input);
            if (state.culled == Culled::no) {
                const bool was_in_contact = input.memory.holds(f);
                evaluate(f, state.nearest);
                const bool has_parted = was_in_contact && !input.memory.holds(f);
                if (has_parted) state.until = 0;
            }
            due = std::min(due,
                           state.culled == Culled::by_group ? static_cast<double>(state.until) : accumulated);
        }
        due_[static_cast<std::size_t>(group)] = due;
    }

    /// Whether a facet must be rechecked. Advances the clearance of facets culled by their candidates.
    [[nodiscard]] static bool expired(State& state, std::int32_t facet, double accumulated,
                                      const CullingInput& input) {
        if (state.culled != Culled::by_candidates) return accumulated >= state.until;
        if (accumulated >= state.near.until) return true;
        state.until = not_above(state.until - own_approach(facet, state.near, input));
        return state.until <= 0;
    }
    /// Bound on the relative motion of a facet and its near candidates over the last step, m.
    [[nodiscard]] static double own_approach(std::int32_t facet, const Shortlist& near,
                                             const CullingInput& input);
    /// Decides from the present clearance whether and how a facet is culled.
    void recheck(State& state, std::int32_t facet, std::int32_t group, const CullingInput& input) const;

    [[nodiscard]] std::span<State> states_of(std::int32_t group) {
        return std::span(states_).subspan(bound_.before(group), bound_.facets(group).size());
    }

    RelativeMotionBound bound_;
    std::vector<State> states_;  ///< of the owned facets, group by group
    std::vector<double> due_;    ///< by group: relative motion at which its first facet is due, m
};

}  // namespace weavefront::contact
