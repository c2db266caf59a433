#include "weavefront/solver/balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/motion.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

namespace {

// Part of the initial energy that sums of millions of terms, each rounded to 2^-44 of it, resolve to far better than any limit.
constexpr double resolved = 0x1p-20;

}  // namespace

void require_balance(const Balance& balance, double limit, std::int64_t step) {
    const auto when = fmt::format("at t = {:.6g} us, step {} (limits.energy_error allows {:.3g} %)", balance.time * 1e6, step, limit * 100);
    if (std::abs(balance.closure) > limit)
        throw GuardStop(fmt::format("the energy balance is off by {:.3g} % of the {:.3g} J that the projectile has handed over {}",
                                    balance.closure * 100, balance.turnover, when));
    if (balance.contact < -limit * balance.turnover)
        throw GuardStop(fmt::format("contact has given {:.3g} J more than it had taken, of {:.3g} J that the projectile has handed over {}",
                                    -balance.contact, balance.turnover, when));
}

double Simulation::damping_work(std::size_t node, const Vec3& next, double backward, double forward) const {
    const Vec3& last = model_.nodes.v[node];
    return scene_.damping * model_.nodes.mass[node] * (last + next).dot(backward * last + forward * next) / 4;
}

double Simulation::back_face_deflection() const {
    const auto& surface = model_.surface;
    const auto last = static_cast<std::int32_t>(panel_.plies.size()) - 1;
    double largest = 0;
    for (auto f = static_cast<std::size_t>(surface.owned); f > 0 && surface.facets[f - 1].ply == last; --f) {
        if (!surface.alive[f - 1]) continue;
        for (const auto node : surface.facets[f - 1].nodes) {
            const auto n = static_cast<std::size_t>(node);
            largest = std::max(largest, model_.nodes.x[n].z() - model_.nodes.initial.height(n));
        }
    }
    return largest;
}

Balance Simulation::balance() {
    const Timed timed(seconds_, Phase::ledger);
    const auto& nodes = model_.nodes;
    enum Sum : std::size_t { kinetic, internal, hourglass, friction, damping, contact, eroded, broken, eroded_count, folded, faulty, size };
    std::array<std::int64_t, size> sums{};
    double highest = 0;
    const auto add = [&](Sum sum, double value) {
        if (energy_.fits(value))
            sums[sum] += energy_.from(value);
        else
            ++sums[faulty];
    };
    const auto count = static_cast<std::size_t>(nodes.count);
    const double step = (last_dt_ + dt_) / 2;
    std::size_t n = 0;
    if (scene_.damping == 0)
        for (; n + energies_at_once <= count; n += energies_at_once) {
            const auto energies = kinetic_energies(nodes, model_.assembly.scale(), n, step, last_dt_);
            for (std::size_t i = 0; i < energies_at_once; ++i)
                if (nodes.owned[n + i]) add(kinetic, energies[i]);
        }
    for (; n < count; ++n) {
        if (!nodes.owned[n]) continue;
        const Vec3 next = next_velocity(n), acceleration = (next - nodes.v[n]) / step;
        add(kinetic, nodes.mass[n] * nodes.v[n].dot(nodes.v[n] + last_dt_ * acceleration) / 2);
        if (scene_.damping > 0) add(damping, damping_work(n, next, last_dt_, 0));
    }
    const auto of_ply = nodes.initial.in_plane.period.size();
    for (std::size_t ply = 0, node = 0; ply < nodes.initial.heights.size(); ++ply)
        for (std::size_t i = 0; i < of_ply; ++i, ++node)
            if (nodes.owned[node]) highest = std::max(highest, std::abs(nodes.x[node].z() - nodes.initial.heights[ply]));
    for (const auto& group : model_.groups) {
        sums[folded] += group->inverted(nodes.x);
        for (std::int32_t i = 0; i < group->size(); ++i) {
            if (!group->alive(i)) continue;
            const auto energy = group->energy(i);
            add(internal, energy.work);
            add(hourglass, energy.hourglass);
            add(friction, energy.friction);
        }
    }
    sums[internal] += eroded_work_;
    sums[friction] += eroded_friction_;
    sums[eroded] += eroded_hourglass_;
    sums[contact] += contact_work_;
    sums[damping] += damping_work_;
    sums[broken] = counts_.broken_yarns;
    sums[eroded_count] = counts_.eroded_elements;
    comm_.sum(sums);
    if (sums[faulty] > 0) throw GuardStop(fmt::format("an energy is not finite at t = {:.6g} us, step {}", time_ * 1e6, steps_));

    const auto whole = [&](Sum sum) { return multiplicity_ * energy_.to(sums[sum]); };
    Balance balance;
    balance.time = time_;
    balance.time_step = dt_;
    balance.kinetic_fabric = whole(kinetic);
    balance.internal = whole(internal);
    balance.hourglass = whole(hourglass);
    balance.friction = whole(friction);
    balance.damping = whole(damping);
    balance.contact = whole(contact);
    balance.eroded = whole(eroded);
    const auto multiplicity = static_cast<std::int64_t>(multiplicity_);
    balance.broken_yarns = multiplicity * sums[broken];
    balance.eroded_elements = multiplicity * sums[eroded_count];
    balance.max_displacement = comm_.max(highest);
    balance.back_face_deflection = comm_.max(back_face_deflection());
    if (model_.projectile) {
        const auto& p = *model_.projectile;
        const Vec3 acceleration = projectile_force_ / scene_.projectile->mass;
        balance.projectile = p.position;
        balance.projectile_velocity = p.velocity + last_dt_ / 2 * acceleration;
        balance.contact_force = projectile_force_;
        balance.kinetic_projectile = scene_.projectile->mass * p.velocity.dot(p.velocity + last_dt_ * acceleration) / 2;
    }
    if (initial_energy_ > 0) {
        const double defect = balance.total() - initial_energy_;
        turnover_ = std::max({turnover_, balance.total() - balance.kinetic_projectile, resolved * initial_energy_});
        balance.energy_error = defect / initial_energy_;
        balance.turnover = turnover_;
        balance.closure = defect / turnover_;
    }
    counts_.inverted = std::max(counts_.inverted, multiplicity * sums[folded]);
    counts_.largest_closure = std::max(counts_.largest_closure, std::abs(balance.closure));
    counts_.lowest_contact_energy = std::min(counts_.lowest_contact_energy, balance.contact);
    counts_.max_displacement = std::max(counts_.max_displacement, balance.max_displacement);
    counts_.back_face_deflection = std::max(counts_.back_face_deflection, balance.back_face_deflection);
    return balance;
}

}  // namespace weavefront::solver
