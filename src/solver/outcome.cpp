#include "weavefront/solver/outcome.hpp"

#include <algorithm>

namespace weavefront::solver {

namespace {

// Of the diameter: a projectile that has gone so far without being touched has left the fabric.
constexpr double free_way = 0.1;

// Of the largest deflection: the back face swings back by more than its plies rattle.
constexpr double past_peak = 0.99;

}  // namespace

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::stopped:
            return "stopped";
        case Verdict::perforated:
            return "perforated";
        case Verdict::passed:
            return "passed without perforation";
        case Verdict::still_moving:
            break;
    }
    return "still moving";
}

Outcome outcome_of(const Shot& shot) {
    const auto& passages = shot.passages.plies();
    const auto count = [&](Way way) {
        return std::ranges::count_if(passages,
                                     [&](const auto& passage) { return passage && passage->way == way; });
    };
    Outcome outcome;
    outcome.plies_perforated = count(Way::hole);
    if (shot.passages.all()) {
        const auto all = static_cast<std::int64_t>(passages.size());
        outcome.verdict = outcome.plies_perforated == all ? Verdict::perforated : Verdict::passed;
        outcome.decided_at = 0;
        for (const auto& passage : passages)
            outcome.decided_at = std::max(*outcome.decided_at, passage->time);
    } else if (shot.turned_back) {
        outcome.verdict = Verdict::stopped;
        outcome.decided_at = shot.turned_back;
    }
    return outcome;
}

bool is_settled(const Simulation& simulation, const Balance& balance) {
    const auto& shots = simulation.shots();
    bool any_stopped = false;
    for (std::size_t p = 0; p < shots.size(); ++p) {
        const auto verdict = outcome_of(shots[p]).verdict;
        if (verdict == Verdict::still_moving) return false;
        const double way = balance.projectiles[p].velocity.norm() * (balance.time - shots[p].last_touched);
        if (way < free_way * simulation.projectile_diameter(p)) return false;
        any_stopped = any_stopped || verdict == Verdict::stopped;
    }
    if (shots.empty()) return false;
    // What is perforated goes on dishing for a while; a target that nothing holds flies on for ever.
    if (!any_stopped && !simulation.is_supported()) return true;
    return balance.back_face_deflection <= past_peak * simulation.counts().back_face_deflection;
}

}  // namespace weavefront::solver
