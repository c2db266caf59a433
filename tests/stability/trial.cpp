#include "trial.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>

#include "weavefront/scene/read.hpp"
#include "weavefront/solver/balance.hpp"
#include "weavefront/solver/guard.hpp"

namespace weavefront::stability {

namespace {

// Steps between two looks at the energies: fast enough for an instability to be seen long before it
// overflows.
constexpr std::int64_t steps_between_rows = 10;

// A run that takes this many times the steps that its first time step promises is taken to hang.
constexpr double most_steps = 50;

/// FNV-1a over the bits of doubles.
class Fingerprint {
  public:
    void add(double value) {
        for (auto bits = std::bit_cast<std::uint64_t>(value); bits != 0; bits >>= 8)
            hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3ULL;
        hash_ = (hash_ ^ 0x100) * 0x100000001b3ULL;
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// A run under observation.
class GuardedRun {
  public:
    GuardedRun(const Case& trial, const scene::Scene& scene, solver::Simulation& simulation, Result& result)
        : trial_(trial), scene_(scene), simulation_(simulation), result_(result) {}

    /// To the end. @throws solver::GuardStop
    void run() {
        const double promised =
            trial_.steps > 0 ? static_cast<double>(trial_.steps) : scene_.time.end / simulation_.time_step();
        for (;;) {
            simulation_.advance_forces();
            const auto steps = result_.steps = simulation_.steps();
            const bool end = trial_.steps > 0 ? steps >= trial_.steps : simulation_.time() >= scene_.time.end;
            if (steps % steps_between_rows == 0 || end) look();
            if (end) break;
            if (static_cast<double>(steps) > most_steps * promised) {
                result_.outcome = Outcome::endless;
                return;
            }
            simulation_.integrate();
        }
        look_at_fields();
    }

  private:
    void look() {
        const auto row = simulation_.record_balance();
        if (simulation_.steps() == 0) initial_ = row.total();
        transferred_ = std::max({transferred_, row.total() - row.kinetic_projectile, 0x1p-20 * initial_});
        const double error = (row.total() - initial_) / transferred_;
        const auto projectile = row.projectiles.empty() ? solver::ProjectileNow() : row.projectiles.front();
        see({row.time, projectile.position.z(), projectile.velocity.z(), projectile.contact_force.z(),
             row.kinetic_fabric, row.kinetic_projectile, row.internal, row.hourglass, row.contact,
             row.friction, row.damping, row.eroded, row.max_displacement, row.time_step, error});
        result_.time = row.time;
        result_.energy_error = std::max(result_.energy_error, std::abs(error));
        result_.hourglass_share = std::max(result_.hourglass_share, row.hourglass / transferred_);
        result_.given =
            std::max(result_.given, -std::min({row.internal, row.friction, row.contact}) / transferred_);
        result_.given_by_single = std::max(result_.given_by_single, given_by_elements() / transferred_);
        result_.broken_yarns = row.broken_yarns;
        result_.eroded_elements = row.eroded_elements;
        // As an ordinary run does at each row, but over what the fabric was given at the start, too.
        auto guarded = row;
        guarded.transferred_energy = transferred_;
        guarded.closure_error = error;
        solver::require_balance(guarded, scene_.limits.energy_error, simulation_.steps());
    }

    /// What the yarns and the friction of elements have given beyond what they took, J: those that have not
    /// do not make up for it.
    [[nodiscard]] double given_by_elements() const {
        double given = 0;
        for (const auto& group : simulation_.model().groups)
            for (std::int32_t e = 0; e < group->size(); ++e) {
                if (!group->alive(e)) continue;
                const auto energy = group->energy(e);
                given -= std::min(energy.work, 0.0) + std::min(energy.friction, 0.0);
            }
        return simulation_.panel().multiplicity() * given;
    }

    void look_at_fields() {
        const auto& nodes = simulation_.model().nodes;
        for (std::size_t n = 0; n < nodes.x.size(); ++n)
            see({nodes.x[n].x(), nodes.x[n].y(), nodes.x[n].z(), nodes.v[n].x(), nodes.v[n].y(),
                 nodes.v[n].z()});
        const auto elements = static_cast<std::int32_t>(simulation_.model().slots.size());
        for (std::int32_t e = 0; e < elements; ++e) {
            const auto out = simulation_.model().output(e);
            see({out.strain_fill, out.strain_warp, out.stress_fill, out.stress_warp, out.braid_angle,
                 out.crimp_height});
        }
        result_.bits = fingerprint_.value();
    }

    void see(std::initializer_list<double> values) {
        for (const double value : values) {
            result_.finite = result_.finite && std::isfinite(value);
            fingerprint_.add(value);
        }
    }

    const Case& trial_;
    const scene::Scene& scene_;
    solver::Simulation& simulation_;
    Result& result_;
    double initial_ = 0, transferred_ = 0;
    Fingerprint fingerprint_;
};

}  // namespace

Result run(const Case& trial, const std::string& base, const std::string& formulation,
           const parallel::Communicator& comm) {
    Result result;
    const auto start = std::chrono::steady_clock::now();
    auto overrides = trial.overrides;
    overrides.push_back("fabrics.kevlar129.formulation=" + formulation);
    try {
        const auto scene = scene::parse_scene(base, trial.name, overrides);
        solver::Simulation simulation(scene, comm);
        if (trial.prepare) trial.prepare(simulation);
        GuardedRun(trial, scene, simulation, result).run();
    } catch (const scene::InputError& error) {
        result.outcome = Outcome::refused;
        result.message = error.messages().front();
    } catch (const solver::GuardStop& stop) {
        result.outcome = Outcome::stopped;
        result.message = stop.what();
    } catch (const std::exception& fault) {
        result.outcome = Outcome::crashed;
        result.message = fault.what();
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace weavefront::stability
