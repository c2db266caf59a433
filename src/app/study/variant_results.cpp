#include "variant_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "strip_frames.hpp"
#include "weavefront/partition/contact_zone.hpp"
#include "weavefront/study/closed_forms.hpp"

namespace weavefront::app {

VariantResults::VariantResults(const scene::Case& variant, const std::filesystem::path& folder)
    : variant_(variant), folder_(folder) {
    const std::filesystem::path path = folder / "summary.json";
    std::ifstream file(path);
    summary_ = nlohmann::json::parse(file, nullptr, false);
    if (!file || summary_.is_discarded())
        throw std::runtime_error(fmt::format("{}: cannot be read", path.string()));
    for (const char* key : {"status", "reason", "element_steps", "ranks", "nanoseconds_per_element_step"})
        if (!summary_.is_object() || !summary_.contains(key))
            throw std::runtime_error(
                fmt::format("{}: no {}, as the summary of a run has: remove the file", path.string(), key));
    history_ = study::read_columns(folder / "history.csv");
}

study::Curve VariantResults::history(const std::string& column) const {
    return {history_.at("time"), history_.at(column)};
}

std::optional<double> VariantResults::outcome(const std::string& name) const {
    if (name.starts_with("strip_")) return strip(name);
    if (history_.at("time").empty()) return std::nullopt;
    if (name == "peak_displacement") return std::ranges::max(history_.at("max_displacement"));
    if (name == "absorbed_energy")
        return history_.at("kinetic_projectile").front() - last("kinetic_projectile");
    if (name == "residual_velocity")
        return variant_.scene.projectiles.empty() ? std::nullopt : std::optional(last("projectile_vz"));
    return last(name);
}

std::optional<double> VariantResults::strip(const std::string& name) const {
    if (summary_.value("status", "") != "finished" || variant_.scene.projectiles.empty()) return std::nullopt;
    if (!waves_) {
        const double speed = partition::wave_speed(variant_.scene.fabrics.front());
        const double expected =
            study::smith_impact(variant_.scene.projectiles.front().velocity[2], speed).strain;
        waves_ = study::measure_strip(strip_frames(folder_ / "results.vtkhdf"), expected);
    }
    if (name == "strip_strain") return waves_->strain;
    return name == "strip_transverse_speed" ? waves_->transverse_speed : waves_->longitudinal_speed;
}

}  // namespace weavefront::app
