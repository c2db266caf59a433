#include "weavefront/io/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "agreement.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/replace_file.hpp"

namespace weavefront::io {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json to_json(const std::optional<ShotOutcome>& outcome) {
    if (!outcome) return {};
    return {{"verdict", outcome->verdict},
            {"decided_at", to_json(outcome->decided_at)},
            {"plies_perforated", outcome->plies_perforated},
            {"peak_back_face_deflection", outcome->peak_back_face_deflection},
            {"deepest_penetration", outcome->deepest_penetration},
            {"deepest_at", outcome->deepest_at},
            {"deepest_ply", outcome->deepest_ply},
            {"deepest_time", to_json(outcome->deepest_time)}};
}

Json to_json(const ProjectileOutcome& outcome) {
    return {{"verdict", outcome.verdict},
            {"decided_at", to_json(outcome.decided_at)},
            {"plies_perforated", outcome.plies_perforated},
            {"residual_velocity", outcome.residual_velocity}};
}

Json to_json(const Summary& summary) {
    Json phases = Json::object();
    Json first_break = Json::array();
    for (const auto& time : summary.first_break) first_break.push_back(to_json(time));
    for (const auto& phase : summary.wall_seconds)
        phases[phase.name] = {{"min", phase.min}, {"mean", phase.mean}, {"max", phase.max}};
    Json json{{"status", summary.status},
              {"reason", summary.reason},
              {"title", summary.title},
              {"scene_hash", summary.scene_hash},
              {"versions", summary.versions},
              {"ranks", summary.ranks},
              {"elements", summary.elements},
              {"nodes", summary.nodes},
              {"steps", summary.steps},
              {"time", summary.time},
              {"wall_seconds", phases},
              {"element_steps", summary.element_steps},
              {"nanoseconds_per_element_step", summary.nanoseconds_per_element_step},
              {"outcome", to_json(summary.outcome)},
              {"residual_velocity", to_json(summary.residual_velocity)},
              {"max_displacement", summary.max_displacement},
              {"back_face_deflection", summary.back_face_deflection},
              {"energy_error", summary.energy_error},
              {"broken_yarns", summary.broken_yarns},
              {"eroded_elements", summary.eroded_elements},
              {"first_break", first_break},
              {"left_out", summary.left_out},
              {"history_sha256", summary.history_sha256},
              {"results_sha256", summary.results_sha256}};
    for (const auto& projectile : summary.projectiles) json["projectiles"].push_back(to_json(projectile));
    return json;
}

// JSON has no infinities: the library would write null, which reads as "does not apply".
void require_finite(const Json& json, const std::string& key) {
    if (json.is_number_float() && !std::isfinite(json.get<double>()))
        throw NotFinite("summary: " + key + " is not finite");
    if (!json.is_structured()) return;
    for (const auto& [name, value] : json.items()) require_finite(value, json.is_object() ? name : key);
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary,
                   const parallel::Communicator& comm) {
    Json json;
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        json = to_json(summary);
        require_finite(json, "summary");
    });
    agreement.settle<NotFinite>();
    // Text that is not UTF-8, as a path may be, is written with the character that stands for what it is not.
    agreement.attempt_on_root(
        [&] { replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"); });
    agreement.settle<FileError>();
}

}  // namespace weavefront::io
