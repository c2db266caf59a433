#include "weavefront/solver/balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "misses.hpp"
#include "weavefront/solver/central_difference.hpp"
#include "weavefront/solver/guard.hpp"
#include "weavefront/solver/motion.hpp"
#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

namespace {

// Part of the energy scale that sums of millions of terms, each rounded to 2^-44 of it, resolve to far better
// than any limit.
constexpr double resolved = 0x1p-20;

}  // namespace

void require_balance(const Balance& balance, double limit, std::int64_t step) {
    const auto when = fmt::format("at t = {:.6g} us, step {} (limits.energy_error allows {:.3g} %)",
                                  balance.time * 1e6, step, limit * 100);
    if (std::abs(balance.closure_error) > limit)
        throw GuardStop(fmt::format("the energy balance is off by {:.3g} % of the {:.3g} J that the "
                                    "projectile has handed over {}",
                                    balance.closure_error * 100, balance.transferred_energy, when),
                        Fault::energy_sum);
    const auto require_taken = [&](const char* what, double energy, Fault fault) {
        if (energy < -limit * balance.transferred_energy)
            throw GuardStop(
                fmt::format("{} given {:.3g} J more than {} had taken, of {:.3g} J that the projectile has "
                            "handed over {}",
                            what, -energy, what[0] == 'y' ? "they" : "it", balance.transferred_energy, when),
                fault);
    };
    require_taken("yarns have", balance.internal, Fault::internal);
    require_taken("friction has", balance.friction, Fault::friction);
    require_taken("contact has", balance.contact, Fault::contact);
    require_taken("contact friction has", balance.contact_friction.value_or(0), Fault::contact);
}

double Simulation::damping_work(std::size_t node, const Vec3& next, double backward, double forward) const {
    const Vec3& last = model_.nodes.v[node];
    return scene_.damping * model_.nodes.mass[node] * (last + next).dot(backward * last + forward * next) / 4;
}

/// What this rank adds to a balance: energies as integers of the ledger's scale, and counts.
struct Simulation::LedgerSums {
    enum Of : std::size_t {
        kinetic,
        internal,
        hourglass,
        friction,
        damping,
        contact,
        contact_friction,
        eroded,
        broken_yarns,
        eroded_elements,
        folded,
        debris_elements,
        debris_mass,
        faulty,
        size
    };

    const parallel::FixedPoint& scale;
    std::array<std::int64_t, size> values{};

    std::int64_t& operator[](Of sum) { return values[sum]; }
    void add(Of sum, double energy) {
        if (scale.fits(energy))
            values[sum] += scale.from(energy);
        else
            ++values[faulty];
    }
};

void Simulation::add_nodal_energies(LedgerSums& sums) const {
    const auto& nodes = model_.nodes;
    const auto count = static_cast<std::size_t>(nodes.count);
    const double step = clock_.velocity_step();
    std::size_t n = 0;
    if (scene_.damping == 0)
        for (; n + energies_at_once <= count; n += energies_at_once) {
            const auto energies = kinetic_energies(nodes, model_.assembly.scale(), n, step, clock_.last_dt);
            for (std::size_t i = 0; i < energies_at_once; ++i)
                if (nodes.owned[n + i]) sums.add(LedgerSums::kinetic, energies[i]);
        }
    for (; n < count; ++n) {
        if (!nodes.owned[n]) continue;
        const Vec3 &v = nodes.v[n], next = updated_velocity(n);
        const Vec3 acceleration = acceleration_between(v, next, step);
        sums.add(LedgerSums::kinetic,
                 nodes.mass[n] * v.dot(opposite_velocity(v, acceleration, clock_.last_dt)) / 2);
        if (scene_.damping > 0) sums.add(LedgerSums::damping, damping_work(n, next, clock_.last_dt, 0));
    }
}

void Simulation::add_element_energies(LedgerSums& sums) const {
    for (const auto& group : model_.groups) {
        sums[LedgerSums::folded] += group->inverted(model_.nodes.x);
        for (std::int32_t i = 0; i < group->size(); ++i) {
            if (!group->alive(i)) continue;
            const auto energy = group->energy(i);
            sums.add(LedgerSums::internal, energy.work);
            sums.add(LedgerSums::hourglass, energy.hourglass);
            sums.add(LedgerSums::friction, energy.friction);
        }
    }
    sums[LedgerSums::internal] += ledger_.eroded_work;
    sums[LedgerSums::friction] += ledger_.eroded_friction;
    sums[LedgerSums::eroded] += ledger_.eroded_hourglass;
    sums[LedgerSums::contact] += ledger_.contact;
    sums[LedgerSums::contact_friction] += ledger_.contact_friction;
    sums[LedgerSums::damping] += ledger_.damping;
    sums[LedgerSums::broken_yarns] = counts_.broken_yarns;
    sums[LedgerSums::eroded_elements] = counts_.eroded_elements;
}

Simulation::Displacements Simulation::displacements(LedgerSums& sums) const {
    const auto& nodes = model_.nodes;
    const auto& heights = nodes.initial.heights;
    const auto of_ply = nodes.initial.in_plane.one_ply.size();
    Displacements largest;
    for (std::size_t ply = 0, n = 0; ply < heights.size(); ++ply)
        for (std::size_t i = 0; i < of_ply; ++i, ++n) {
            if (!nodes.owned[n]) continue;
            const double along_z = nodes.x[n].z() - heights[ply];
            if (!joined_.has_node(n)) {
                largest.of_debris = std::max(largest.of_debris, std::abs(along_z));
                sums[LedgerSums::debris_mass] += ledger_.mass_scale.from(nodes.mass[n]);
                continue;
            }
            largest.of_joined = std::max(largest.of_joined, std::abs(along_z));
            if (ply + 1 == heights.size()) largest.of_back_face = std::max(largest.of_back_face, along_z);
        }
    if (!joined_.is_whole())
        for (std::size_t e = 0; e < static_cast<std::size_t>(model_.surface.owned); ++e)
            if (joined_.is_debris(model_, e)) ++sums[LedgerSums::debris_elements];
    return {comm_.max(largest.of_joined), comm_.max(largest.of_back_face), comm_.max(largest.of_debris)};
}

const JoinedFabric& Simulation::joined_fabric() const {
    std::array<std::int64_t, 1> broken{counts_.broken_yarns};
    comm_.sum(broken);
    if (broken[0] != joined_at_) joined_.find(model_, panel_, comm_);
    joined_at_ = broken[0];
    return joined_;
}

void Simulation::add_projectiles(Balance& balance) const {
    for (std::size_t p = 0; p < shots_.size(); ++p) {
        const auto& body = model_.projectiles[p].body;
        const auto& wrench = shots_[p].wrench;
        ProjectileNow now{body.position(), projectile_velocity(p), wrench.force, {}};
        if (body.turns())
            now.rotation =
                Rotation{body.attitude().quaternion(), projectile_angular_velocity(p), wrench.moment};
        balance.projectiles.push_back(now);
        balance.kinetic_projectile += body.kinetic_energy(wrench, clock_.last_dt);
    }
}

void Simulation::close(Balance& balance) const {
    if (ledger_.initial_energy <= 0) return;
    const double defect = balance.total() - ledger_.initial_energy;
    balance.transferred_energy =
        std::max({ledger_.transferred_energy, balance.total() - balance.kinetic_projectile,
                  resolved * ledger_.energy_scale});
    balance.energy_error = defect / ledger_.initial_energy;
    balance.closure_error = defect / balance.transferred_energy;
}

Balance Simulation::record_balance() {
    const auto now = balance();
    const auto raise = [](auto& largest, auto value) { largest = std::max(largest, value); };
    ledger_.transferred_energy = now.transferred_energy;
    raise(counts_.largest_closure_error, std::abs(now.closure_error));
    counts_.lowest_contact_energy = std::min(counts_.lowest_contact_energy, now.contact);
    raise(counts_.largest_hourglass, now.hourglass);
    raise(counts_.largest_internal, now.internal);
    raise(counts_.max_displacement, now.max_displacement);
    raise(counts_.back_face_deflection, now.back_face_deflection);
    raise(counts_.inverted, now.folded_elements);
    return now;
}

Balance Simulation::balance() const {
    static_cast<void>(joined_fabric());
    const Timed timed(seconds_, Phase::ledger);
    LedgerSums sums{.scale = ledger_.scale};
    add_nodal_energies(sums);
    add_element_energies(sums);
    const auto largest = displacements(sums);
    comm_.sum(sums.values);
    if (sums[LedgerSums::faulty] > 0)
        throw GuardStop(fmt::format("an energy is not finite at t = {:.6g} us, step {}", clock_.time * 1e6,
                                    clock_.steps));

    const auto whole = [&](LedgerSums::Of sum) { return multiplicity_ * ledger_.scale.to(sums[sum]); };
    const auto counted = [&](LedgerSums::Of sum) {
        return static_cast<std::int64_t>(multiplicity_) * sums[sum];
    };
    Balance balance;
    balance.time = clock_.time;
    balance.time_step = clock_.dt;
    balance.kinetic_fabric = whole(LedgerSums::kinetic);
    balance.internal = whole(LedgerSums::internal);
    balance.hourglass = whole(LedgerSums::hourglass);
    balance.friction = whole(LedgerSums::friction);
    balance.damping = whole(LedgerSums::damping);
    balance.contact = whole(LedgerSums::contact);
    if (ledger_.has_contact_friction) balance.contact_friction = whole(LedgerSums::contact_friction);
    balance.eroded = whole(LedgerSums::eroded);
    balance.broken_yarns = counted(LedgerSums::broken_yarns);
    balance.eroded_elements = counted(LedgerSums::eroded_elements);
    balance.debris_elements = counted(LedgerSums::debris_elements);
    balance.debris_mass = multiplicity_ * ledger_.mass_scale.to(sums[LedgerSums::debris_mass]);
    balance.max_displacement = largest.of_joined;
    balance.back_face_deflection = largest.of_back_face;
    balance.debris_displacement = largest.of_debris;
    balance.deepest = deepest();
    add_projectiles(balance);
    close(balance);
    balance.folded_elements = counted(LedgerSums::folded);
    return balance;
}

}  // namespace weavefront::solver
