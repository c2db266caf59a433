#include "v50_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "impact.hpp"
#include "list_option.hpp"
#include "shared_text.hpp"
#include "weavefront/scene/quantity.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

// Measured limits are known to about 15 m/s, and this model's own scatter at the limit is about 5 m/s.
constexpr double default_width = 5;  // m/s
constexpr double least_width = 0.1;  // m/s, ten grains of the speeds
constexpr int default_count = 20, most_count = 10'000;
constexpr std::uint64_t most_seed = 1'000'000'000;
constexpr double first_step = 0.2;        // of the scene's velocity
constexpr double default_guess = 0.5;     // of the scene's velocity, on both sides of it
constexpr double default_deviation = 20;  // parts of the way from `from` to `to`
// A shot near the limit takes longer than others to be decided.
constexpr double longer = 4;

using Findings = std::vector<std::string>;

/// A speed of an option; none: it was not given, or is wrong.
std::optional<double> read_speed(const char* option, const std::string& text, Findings& findings,
                                 SpeedUnit& unit) {
    if (text.empty()) return std::nullopt;
    const auto read = scene::speed_of(text);
    if (const auto* problem = std::get_if<std::string>(&read)) {
        findings.push_back(fmt::format("{}: {}, such as '428 m/s'", option, *problem));
        return std::nullopt;
    }
    const auto& speed = std::get<scene::WrittenSpeed>(read);
    if (!(speed.si > 0)) {
        findings.push_back(
            fmt::format("{}: found '{}', allowed a velocity above 0", option, scene::printable(text)));
        return std::nullopt;
    }
    // The unit of the first option that has one is that of the messages.
    if (unit.name.empty())
        unit = {speed.unit, std::get<scene::WrittenSpeed>(scene::speed_of("1 " + speed.unit)).si};
    return speed.si;
}

void read_numbers(const V50Options& options, V50Plan& plan, Findings& findings) {
    plan.confidence = options.confidence.value_or(plan.confidence);
    if (!(plan.confidence > 0 && plan.confidence < 1))
        findings.push_back(fmt::format(
            "--confidence: found {}, allowed a number between 0 and 1, such as 0.95", plan.confidence));
    plan.count = options.count.value_or(default_count);
    if (plan.count < 1 || plan.count > most_count)
        findings.push_back(fmt::format("--count: found {}, allowed 1 to {} shots", plan.count, most_count));
    if (options.ranks_per_shot && *options.ranks_per_shot < 1)
        findings.push_back(
            fmt::format("--ranks-per-shot: found {}, allowed at least 1", *options.ranks_per_shot));
    if (!options.restart.empty() && options.restart != "auto")
        findings.push_back(
            fmt::format("--restart: found '{}', allowed 'auto'", scene::printable(options.restart)));
    if (options.complete.empty()) return;
    const auto criterion = criterion_of(options.complete);
    if (const auto* problem = std::get_if<std::string>(&criterion))
        findings.push_back("--complete: " + *problem);
    else
        plan.criterion = std::get<Criterion>(criterion);
}

/// Random strength draws anew for each shot, unless the user says how its seed goes.
void add_seeds(V50Plan& plan, const scene::Scene& scene) {
    for (const auto& fabric : scene.fabrics) {
        if (!fabric.failure || !fabric.failure->scatter) continue;
        ballistics::ScatterLaw law;
        law.kind = ballistics::ScatterLaw::Kind::seed;
        law.path = fmt::format("fabrics.{}.failure.scatter.seed", fabric.name);
        if (std::ranges::find(plan.scatter, law.path, &ballistics::ScatterLaw::path) == plan.scatter.end())
            plan.scatter.push_back(law);
    }
}

void read_scatter(const V50Options& options, V50Plan& plan, const scene::Scene& scene, Findings& findings) {
    plan.seed = options.seed;
    if (plan.seed > most_seed)
        findings.push_back(fmt::format("--seed: found {}, allowed 0 to {}", plan.seed, most_seed));
    for (const auto& text : options.scatter) {
        const auto law = ballistics::scatter_law_of(text);
        if (const auto* problem = std::get_if<std::string>(&law))
            findings.push_back("--scatter: " + *problem);
        else
            plan.scatter.push_back(std::get<ballistics::ScatterLaw>(law));
    }
    add_seeds(plan, scene);
    const bool scatters = !options.scatter.empty() || !plan.scatter.empty();
    const auto refuse = [&](bool is_given, const char* option) {
        if (is_given)
            findings.push_back(fmt::format(
                "{}: found {} scatter, allowed {} it only: --scatter, or failure.scatter of a fabric", option,
                scatters ? "with" : "without", scatters ? "without" : "with"));
    };
    refuse(!scatters && options.count, "--count");
    refuse(!scatters && !options.sigma.empty(), "--sigma");
    refuse(scatters && !options.width.empty(), "--width");
    refuse(scatters && !options.mesh.empty(), "--mesh");
    refuse(scatters && !options.stiffness.empty(), "--stiffness");
}

void read_speeds(const V50Options& options, V50Plan& plan, Findings& findings) {
    plan.unit.name.clear();
    plan.search.from = read_speed("--from", options.from, findings, plan.unit);
    plan.search.to = read_speed("--to", options.to, findings, plan.unit);
    plan.search.width = read_speed("--width", options.width, findings, plan.unit).value_or(default_width);
    plan.design.sigma = read_speed("--sigma", options.sigma, findings, plan.unit).value_or(0);
    if (plan.search.from && plan.search.to && *plan.search.from >= *plan.search.to)
        findings.push_back(fmt::format("--to: found '{}', allowed a velocity above that of --from, '{}'",
                                       options.to, options.from));
    if (plan.search.width < least_width)
        findings.push_back(
            fmt::format("--width: found '{}', allowed at least {} m/s", options.width, least_width));
}

/// What the scene says: the velocity to begin with, and what lacks.
void read_velocity(const V50Options& options, V50Plan& plan, const scene::Scene& scene, Findings& findings) {
    const auto name = options.scene.string();
    if (scene.projectiles.empty() || !scene.contact.projectile)
        return findings.push_back(
            fmt::format("{}: found no {}, allowed a scene with one, as a limit needs it", name,
                        scene.projectiles.empty() ? "projectile" : "contact.projectile"));
    if (scene.projectiles.size() > 1)
        return findings.push_back(
            fmt::format("{}: found {} projectiles, allowed one: a limit is that of one projectile", name,
                        scene.projectiles.size()));
    if (std::ranges::none_of(scene.fabrics, [](const auto& fabric) { return fabric.failure.has_value(); }))
        findings.push_back(fmt::format(
            "{}: found no fabric with failure, allowed at least one: nothing is perforated otherwise", name));
    const auto& v = scene.projectiles.front().velocity;
    const double speed = scene.projectiles.front().speed();
    for (std::size_t i = 0; i < 3; ++i) plan.direction[i] = v[i] / speed;
    if (plan.unit.name.empty()) plan.unit = {scene.units.speed.name, scene.units.speed.si};
    plan.search.start =
        std::clamp(speed, plan.search.from.value_or(speed),
                   plan.search.to.value_or(std::max(speed, plan.search.from.value_or(speed))));
    plan.search.step = first_step * speed;
    plan.design.from =
        plan.search.from.value_or((1 - default_guess) * std::min(speed, plan.search.to.value_or(speed)));
    plan.design.to =
        plan.search.to.value_or((1 + default_guess) * std::max(speed, plan.search.from.value_or(speed)));
    if (!(plan.design.sigma > 0)) plan.design.sigma = (plan.design.to - plan.design.from) / default_deviation;
}

std::vector<std::string> stiffer(const scene::Scene& scene, double factor) {
    std::vector<std::string> settings;
    const auto add = [&](const char* key, const std::optional<scene::ContactLaw>& law) {
        if (law)
            settings.push_back(fmt::format("contact.{}.stiffness={} N/m^3", key, law->stiffness * factor));
    };
    add("projectile", scene.contact.projectile);
    add("plies", scene.contact.plies);
    return settings;
}

void read_variants(const V50Options& options, V50Plan& plan, const scene::Scene& scene, Findings& findings) {
    plan.variants.push_back({"scene", {}});
    if (!options.mesh.empty())
        for (const auto& item : items_of(options.mesh)) {
            const std::string size(scene::trimmed(item));
            plan.variants.push_back({"mesh " + size, {"target.mesh.center=" + size}});
        }
    if (!options.stiffness.empty())
        for (const auto& item : items_of(options.stiffness)) {
            const auto factor = scene::finite_number(item);
            if (factor && *factor > 0)
                plan.variants.push_back({fmt::format("stiffness x {}", *factor), stiffer(scene, *factor)});
            else
                findings.push_back(
                    fmt::format("--stiffness: found '{}', allowed factors above 0, such as '0.5, 2'",
                                scene::printable(item)));
        }
}

/// Variants that are the scene as it stands, or one another, are computed once.
void leave_out_repeated(V50Plan& plan) {
    std::vector<std::string> hashes;
    std::vector<V50Variant> kept;
    for (std::size_t i = 0; i < plan.variants.size(); ++i) {
        const auto hash = plan.scene_of(i, 1, plan.search.start).hash;
        if (std::ranges::find(hashes, hash) != hashes.end()) continue;
        hashes.push_back(hash);
        kept.push_back(plan.variants[i]);
    }
    plan.variants = kept;
}

void raise(const Findings& findings) {
    if (!findings.empty()) throw scene::InputError(findings);
}

}  // namespace

std::vector<std::string> V50Plan::settings_of(std::size_t variant, int number, double speed) const {
    auto all = settings;
    const auto& own = variants[variant].settings;
    all.insert(all.end(), own.begin(), own.end());
    all.push_back(fmt::format("{}=[{} m/s, {} m/s, {} m/s]", velocity_key, speed * direction[0],
                              speed * direction[1], speed * direction[2]));
    for (const auto& law : scatter) all.push_back(ballistics::drawn_setting(law, seed, number));
    return all;
}

scene::Scene V50Plan::scene_of(std::size_t variant, int number, double speed) const {
    // Ranks parse scenes of shots at different times: none of them reads a file for the others.
    const auto read = [this](const std::filesystem::path& path, std::size_t most) {
        const auto known = files.find(path);
        return known == files.end() ? scene::read_bytes(path, most) : known->second;
    };
    return scene::parse_scene(scene_text, scene_name, settings_of(variant, number, speed),
                              scene::Need::impact, read);
}

V50Plan read_v50_plan(const V50Options& options, const parallel::Communicator& comm) {
    V50Plan plan;
    Findings findings;
    read_numbers(options, plan, findings);
    read_speeds(options, plan, findings);
    plan.scene_name = options.scene.string();
    plan.scene_text = shared_text(options.scene, comm);
    const auto read = [&plan, shared = shared_files(comm)](const std::filesystem::path& path,
                                                           std::size_t most) {
        return plan.files[path] = shared(path, most);
    };
    const auto scene =
        scene::parse_scene(plan.scene_text, plan.scene_name, options.overrides, scene::Need::impact, read);
    read_scatter(options, plan, scene, findings);
    read_velocity(options, plan, scene, findings);
    read_variants(options, plan, scene, findings);
    raise(findings);
    plan.title = scene.title;
    plan.plies = static_cast<std::int64_t>(scene.target->plies.size());
    plan.velocity_key = scene.has_projectile_list ? "projectiles.0.velocity" : "projectile.velocity";
    plan.projectile_mass = scene.projectiles.front().mass;
    plan.columns = columns_of(scene);
    plan.checkpoints = options.checkpoints;
    plan.settings = {"time.stop=decided", fmt::format("time.end={} s", longer * scene.time.end),
                     "output.interval=0"};
    plan.settings.insert(plan.settings.end(), options.overrides.begin(), options.overrides.end());
    plan.groups = std::max(
        1, comm.size() / std::max(1, options.ranks_per_shot.value_or(std::min(comm.size(), plan.columns))));
    plan.search.side_by_side = plan.groups;
    leave_out_repeated(plan);
    // Every draw is checked now rather than in the middle.
    if (!plan.scatter.empty())
        for (int number = 1; number <= plan.count; ++number)
            (void)plan.scene_of(0, number, plan.search.start);
    if (!options.shots.empty())
        plan.range_shots =
            parse_range_shots(shared_text(options.shots, comm, scene::most_of_table), options.shots.string());
    return plan;
}

}  // namespace weavefront::app
