#include "run_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>

#include "closing_warnings.hpp"
#include "inactive_features.hpp"
#include "run_head.hpp"
#include "versions.hpp"
#include "warnings.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/io/sha256.hpp"
#include "weavefront/io/summary.hpp"
#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/solver/outcome.hpp"

namespace weavefront::app {

namespace {

std::array<double, 3> array_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<io::PhaseTime> phase_times(const solver::PhaseSeconds& seconds,
                                       const parallel::Communicator& comm) {
    const auto all = parallel::all_gather(comm, seconds);
    std::vector<io::PhaseTime> times;
    for (std::size_t p = 0; p < seconds.size(); ++p) {
        io::PhaseTime time{std::string(solver::phase_names[p]), std::numeric_limits<double>::max(), 0, 0};
        for (const auto& rank : all) {
            time.min = std::min(time.min, rank[p]);
            time.mean += rank[p] / static_cast<double>(all.size());
            time.max = std::max(time.max, rank[p]);
        }
        times.push_back(time);
    }
    return times;
}

std::string status_of(Ending::Kind kind) {
    if (kind == Ending::Kind::stopped) return "stopped";
    return kind == Ending::Kind::interrupted ? "interrupted" : "finished";
}

/// Time of the first broken yarn of each ply over the ranks; none where all are whole.
std::vector<std::optional<double>> first_breaks(const solver::Counts& counts,
                                                const parallel::Communicator& comm) {
    std::vector<std::optional<double>> times;
    for (const double local : counts.first_break) {
        const double first = comm.min(local);
        times.push_back(first < std::numeric_limits<double>::max() ? std::optional(first) : std::nullopt);
    }
    return times;
}

/// @note Collective
io::ShotOutcome shot_outcome(const solver::Simulation& simulation) {
    const auto found = solver::outcome_of(simulation.shots().front());
    const auto deepest = simulation.deepest();
    io::ShotOutcome outcome;
    outcome.verdict = solver::name_of(found.verdict);
    outcome.decided_at = found.decided_at;
    outcome.plies_perforated = found.plies_perforated;
    outcome.peak_back_face_deflection = simulation.counts().back_face_deflection;
    if (deepest.element < 0) return outcome;
    outcome.deepest_penetration = deepest.overlap;
    outcome.deepest_at = array_of(deepest.place);
    outcome.deepest_ply = deepest.element / simulation.panel().columns() + 1;
    outcome.deepest_time = deepest.time;
    return outcome;
}

/// @param last balance; where a run has ended before its first row, it has no projectiles
std::vector<io::ProjectileOutcome> projectile_outcomes(const solver::Simulation& simulation,
                                                       const solver::Balance& last) {
    std::vector<io::ProjectileOutcome> outcomes;
    for (std::size_t p = 0; p < simulation.shots().size(); ++p) {
        const auto found = solver::outcome_of(simulation.shots()[p]);
        outcomes.push_back(
            {std::string(solver::name_of(found.verdict)), found.decided_at, found.plies_perforated,
             (p < last.projectiles.size() ? last.projectiles[p].velocity : simulation.projectile_velocity(p))
                 .z()});
    }
    return outcomes;
}

std::string outcome_text(const io::ProjectileOutcome& outcome, std::size_t plies) {
    const auto when =
        outcome.decided_at ? fmt::format(" at t = {:.4g} us", *outcome.decided_at * 1e6) : std::string();
    return fmt::format("{}{}: {} of {} plies perforated", outcome.verdict, when, outcome.plies_perforated,
                       plies);
}

std::string description_of(const scene::Projectile& projectile) {
    const auto later = projectile.delay > 0 ? fmt::format(", {:.4g} us later", projectile.delay * 1e6) : "";
    return fmt::format("{} of {:.4g} g, {:.4g} mm across, {:.6g} m/s{}", scene::shape_name(projectile.shape),
                       projectile.mass * 1e3, projectile.diameter * 1e3, projectile.speed(), later);
}

}  // namespace

io::HistoryRow row_of(const solver::Balance& b, std::int64_t columns) {
    io::HistoryRow row;
    row.time = b.time;
    for (const auto& now : b.projectiles) {
        io::ProjectileRow projectile{
            array_of(now.position), array_of(now.velocity), array_of(now.contact_force), {}};
        if (now.rotation)
            projectile.rotation =
                io::Rotation{now.rotation->attitude, array_of(now.rotation->angular_velocity),
                             array_of(now.rotation->moment)};
        row.projectiles.push_back(projectile);
    }
    row.kinetic_fabric = b.kinetic_fabric;
    row.kinetic_projectile = b.kinetic_projectile;
    row.internal = b.internal;
    row.hourglass = b.hourglass;
    row.contact = b.contact;
    row.friction = b.friction;
    row.damping = b.damping;
    row.external = b.external;
    row.eroded = b.eroded;
    row.energy_error = b.energy_error;
    row.broken_yarns = b.broken_yarns;
    row.eroded_elements = b.eroded_elements;
    row.max_displacement = b.max_displacement;
    row.time_step = b.time_step;
    row.back_face_deflection = b.back_face_deflection;
    if (b.deepest.element >= 0) {
        row.penetration = b.deepest.overlap;
        row.penetration_at = {b.deepest.place.x(), b.deepest.place.y()};
        row.penetration_ply = b.deepest.element / columns + 1;
    }
    row.debris_elements = b.debris_elements;
    row.debris_mass = b.debris_mass;
    row.debris_displacement = b.debris_displacement;
    row.contact_friction = b.contact_friction;
    return row;
}

io::HistoryRow history_layout(const solver::Simulation& simulation) {
    io::HistoryRow layout;
    for (const auto& projectile : simulation.model().projectiles) {
        layout.projectiles.emplace_back();
        if (projectile.body.turns()) layout.projectiles.back().rotation.emplace();
    }
    if (simulation.has_contact_friction()) layout.contact_friction = 0;
    return layout;
}

RunReport::RunReport(const scene::Scene& scene, const parallel::Communicator& comm, io::Log& log)
    : scene_(scene), comm_(comm), log_(log) {
    for (const auto& line : run_head(comm)) log_.record(line);
}

void RunReport::start(const solver::Simulation& simulation) {
    computing_ = std::chrono::steady_clock::now();
    const auto& model = simulation.model();
    std::array<std::int64_t, 1> bytes{static_cast<std::int64_t>(model.bytes())};
    comm_.sum(bytes);
    const auto& panel = simulation.panel();
    log_.info(fmt::format("Weavefront {}: {}", WEAVEFRONT_VERSION, scene_.title));
    log_.info("  units         SI in all files (m, kg, s, N, J, Pa); this log says its own");
    log_.info(fmt::format(
        "  mesh          {} plies of {} x {} columns: {} elements, {} nodes{}", panel.plies.size(),
        panel.columns_x(), panel.columns_y(), panel.elements(), panel.nodes(),
        panel.multiplicity() > 1 ? fmt::format(" (1/{} of the target)", panel.multiplicity()) : ""));
    for (const auto& fabric : scene_.fabrics)
        log_.info(fmt::format("  fabric        {}: {} formulation, {:.4g} g/m2, t_e = {:.4g} mm", fabric.name,
                              fabric.formulation == scene::Formulation::consistent ? "consistent" : "paper",
                              fabric.areal_density * 1e3, fabric.effective_thickness() * 1e3));
    for (const auto& projectile : scene_.projectiles)
        log_.info("  projectile    " + description_of(projectile));
    log_.info(fmt::format("  ranks         {}, {:.1f} MB in all for mesh and fabric", comm_.size(),
                          static_cast<double>(bytes[0]) / 1e6));
    log_.info(fmt::format("  time step     {:.4g} ns, about {:.0f} steps to {:.6g} us",
                          simulation.time_step() * 1e9, scene_.time.end / simulation.time_step(),
                          scene_.time.end * 1e6));
    for (const auto& phrase : inactive_features(scene_, comm_.size())) log_.info("  left out      " + phrase);
    for (const auto& phrase : warnings(scene_, panel, simulation.time_step())) log_.warn(phrase);
    tell_lack_of_shared_memory(simulation);
}

void RunReport::tell_lack_of_shared_memory(const solver::Simulation& simulation) {
    if (!comm_.any(simulation.lacks_shared_memory()) || is_lack_told_) return;
    is_lack_told_ = true;
    log_.warn(
        "ranks of one host send messages, which takes longer: /dev/shm has no room for the memory that they "
        "would share");
}

std::string RunReport::projectile_text(const solver::Simulation& simulation) {
    const auto& projectiles = simulation.model().projectiles;
    if (projectiles.empty()) return "";
    const auto rest = projectiles.size() - 1;
    return fmt::format("projectile {:.1f} m/s{}", projectiles.front().body.velocity().z(),
                       rest > 0 ? fmt::format(" and {} more", rest) : "");
}

void RunReport::rebalanced(const solver::Simulation& simulation, const solver::Rebalancing& rebalancing) {
    log_.info(fmt::format(
        "  rebalanced    at t = {:.6g} us: the slowest rank took {:.0f} % more than the mean, {:.0f} % are "
        "predicted now",
        simulation.time() * 1e6, (rebalancing.measured - 1) * 100, (rebalancing.predicted - 1) * 100));
}

void RunReport::never_rebalanced(double worst) {
    const auto reason =
        comm_.size() == 1 ? std::string("a single rank has nobody to share with")
        : worst == 0      ? fmt::format("fewer than {} steps", solver::LoadWatch::window)
                     : fmt::format("in {} steps the slowest rank took at most {:.0f} % more than the mean",
                                   solver::LoadWatch::window, (worst - 1) * 100);
    log_.info("  rebalanced    never: " + reason);
}

void RunReport::restarted(const solver::Simulation& simulation, const std::filesystem::path& checkpoint,
                          const std::vector<std::string>& passed_over) {
    for (const auto& reason : passed_over) log_.warn("a checkpoint is passed over: " + reason);
    log_.info(fmt::format("  restart       from {} at t = {:.6g} us, step {}", checkpoint.string(),
                          simulation.time() * 1e6, simulation.steps()));
}

void RunReport::checkpoint_written(const solver::Simulation& simulation, const std::filesystem::path& path,
                                   double seconds) {
    log_.record(fmt::format("  checkpoint    {} at t = {:.6g} us, step {}, in {}", path.filename().string(),
                            simulation.time() * 1e6, simulation.steps(), io::duration_text(seconds)));
}

void RunReport::finish(solver::Simulation& simulation, const solver::Balance& last, const Ending& ending,
                       const std::filesystem::path& directory, const std::string& history_hash) {
    io::Summary summary;
    const double computed = seconds_since(computing_);
    simulation.seconds()[static_cast<std::size_t>(solver::Phase::setup)] = seconds_since(begin_) - computed;
    summary.status = status_of(ending.kind);
    summary.reason = ending.reason;
    summary.history_sha256 = history_hash;
    if (comm_.rank() == 0 && ending.kind != Ending::Kind::interrupted)
        summary.results_sha256 = io::sha256_of_file(directory / "results.vtkhdf");
    summary.versions = library_versions();
    summary.scene_hash = scene_.hash;
    summary.title = scene_.title;
    summary.ranks = comm_.size();
    summary.elements = simulation.panel().elements();
    summary.nodes = simulation.panel().nodes();
    summary.steps = simulation.steps();
    summary.time = simulation.time();
    summary.wall_seconds = phase_times(simulation.seconds(), comm_);
    summary.element_steps = summary.elements * summary.steps;
    const double wall = comm_.max(computed);
    summary.nanoseconds_per_element_step =
        wall * 1e9 * comm_.size() / static_cast<double>(std::max<std::int64_t>(summary.element_steps, 1));
    const auto outcomes = projectile_outcomes(simulation, last);
    if (!outcomes.empty()) {
        summary.residual_velocity = outcomes.front().residual_velocity;
        summary.outcome = shot_outcome(simulation);
    }
    if (outcomes.size() > 1) summary.projectiles = outcomes;
    summary.max_displacement = simulation.counts().max_displacement;
    summary.back_face_deflection = simulation.counts().back_face_deflection;
    summary.energy_error = last.energy_error;
    summary.broken_yarns = last.broken_yarns;
    summary.eroded_elements = last.eroded_elements;
    summary.first_break = first_breaks(simulation.counts(), comm_);
    summary.left_out = inactive_features(scene_, comm_.size());

    log_.info(fmt::format("{}{} at t = {:.6g} us after {} steps: {}",
                          static_cast<char>(std::toupper(summary.status[0])), summary.status.substr(1),
                          summary.time * 1e6, summary.steps, summary.reason));
    for (const auto& outcome : outcomes)
        log_.info(fmt::format("  outcome       {}; {:.2f} m/s along z",
                              outcome_text(outcome, simulation.panel().plies.size()),
                              outcome.residual_velocity));
    log_.info(fmt::format("  displacement  at most {:.3f} mm, of the back face {:.3f} mm",
                          summary.max_displacement * 1e3, summary.back_face_deflection * 1e3));
    log_.info(fmt::format("  fabric        {} yarns broken (element-directions), {} elements eroded",
                          last.broken_yarns, last.eroded_elements));
    log_.info(
        fmt::format("  energy        closes within {:.3g} % of the transferred energy, at the end {:.4g} J; "
                    "fabric {:.3g} J, hourglass {:.3g} J, contact "
                    "{:.3g} J",
                    simulation.counts().largest_closure_error * 100, last.transferred_energy, last.internal,
                    last.hourglass, last.contact));
    for (const auto& warning : closing_warnings(simulation, last)) log_.warn(warning);
    tell_lack_of_shared_memory(simulation);
    for (const auto& phase : summary.wall_seconds)
        log_.info(fmt::format("  {:<13} {:.2f} / {:.2f} / {:.2f} s (least, mean, most over the ranks)",
                              phase.name, phase.min, phase.mean, phase.max));
    log_.info(fmt::format("  cost          {} in all, {:.1f} ns per element-step and core",
                          io::duration_text(seconds_since(begin_)), summary.nanoseconds_per_element_step));
    log_.info("  results       " + directory.string());
    io::write_summary(directory / "summary.json", summary, comm_);
    record_end();
}

void RunReport::record_end() { log_.record(run_tail(seconds_since(begin_))); }

}  // namespace weavefront::app
