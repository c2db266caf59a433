#include "shot_result.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "study/variant_run.hpp"
#include "weavefront/study/curve.hpp"

namespace weavefront::app {

namespace {

nlohmann::json summary_of(const std::filesystem::path& folder) {
    const auto path = folder / "summary.json";
    std::ifstream file(path);
    auto summary = nlohmann::json::parse(file, nullptr, false);
    for (const char* key : {"status", "reason", "energy_error"})
        if (!summary.is_object() || !summary.contains(key))
            throw std::runtime_error(
                fmt::format("{}: no {}, as the summary of a run has: remove the file", path.string(), key));
    if (!summary.contains("outcome") || !summary["outcome"].is_object())
        throw std::runtime_error(
            fmt::format("{}: no outcome, as the summary of a shot has: remove the file", path.string()));
    return summary;
}

}  // namespace

std::string folder_of_shot(int number, double speed) {
    return fmt::format("shot_{:03}_{:.2f}", number, speed);
}

bool is_shot_computed(const scene::Scene& scene, const std::filesystem::path& folder) {
    return is_computed(scene::Compute::impact, {scene, {}, {}, scene.hash}, folder);
}

void read_shot(const std::filesystem::path& folder, const Criterion& criterion,
               const std::array<double, 3>& direction, ShotRow& row) {
    if (!std::filesystem::exists(folder / "summary.json")) return;
    const auto summary = summary_of(folder);
    const auto history = study::read_columns(folder / "history.csv");
    const auto last = [&](const char* column) { return history.at(column).back(); };
    const std::string status = summary["status"];
    row.outcome = status;
    if (status == "interrupted") return;
    row.is_done = true;
    row.energy_error = summary["energy_error"];
    const auto& outcome = summary["outcome"];
    row.plies_perforated = outcome["plies_perforated"].get<std::int64_t>();
    row.deflection = outcome["peak_back_face_deflection"].get<double>();
    row.residual = last("projectile_vx") * direction[0] + last("projectile_vy") * direction[1] +
                   last("projectile_vz") * direction[2];
    row.absorbed_energy = history.at("kinetic_projectile").front() - last("kinetic_projectile");
    if (status != "finished") {
        row.is_stopped_by_guard = true;
        row.reason = summary["reason"];
        return;
    }
    row.outcome = outcome["verdict"];
    row.result = result_of(criterion, row.outcome, *row.plies_perforated, *row.residual);
    if (row.result == ballistics::Result::none) row.reason = summary["reason"];
}

}  // namespace weavefront::app
