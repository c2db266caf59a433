#include <nlohmann/json.hpp>

#include "findings.hpp"
#include "versions.hpp"

namespace weavefront::app {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json json_of(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json json_of(const ballistics::Estimate& estimate) {
    return {
        {"value", estimate.value}, {"lower", json_of(estimate.lower)}, {"upper", json_of(estimate.upper)}};
}

Json json_of(const std::variant<ballistics::Fit, std::string>& found) {
    if (const auto* refusal = std::get_if<std::string>(&found)) return {{"refused", *refusal}};
    const auto& fit = std::get<ballistics::Fit>(found);
    Json quantiles = Json::array();
    for (const auto& [probability, speed] : fit.quantiles) {
        Json quantile = {{"probability", probability}};
        quantile.update(json_of(speed));
        quantiles.push_back(quantile);
    }
    return {{"refused", nullptr},
            {"v50", json_of(fit.speed_at(0.5))},
            {"sigma", json_of(fit.sigma)},
            {"v05", json_of(fit.speed_at(0.05))},
            {"v95", json_of(fit.speed_at(0.95))},
            {"log_likelihood", fit.log_likelihood},
            {"quantiles", quantiles}};
}

Json json_of(const std::optional<ballistics::ResidualCurve>& curve) {
    if (!curve) return nullptr;
    return {{"v50", curve->v50}, {"a", curve->a}, {"p", curve->p}, {"deviation", curve->deviation}};
}

Json json_of(const V50Plan& plan, const V50Findings& findings) {
    Json limits = Json::array();
    for (std::size_t i = 0; i < findings.limits.size(); ++i) {
        const auto& limit = findings.limits[i];
        limits.push_back({{"variant", plan.variants[i].label},
                          {"partial", json_of(limit.bracket.low)},
                          {"complete", json_of(limit.bracket.high)},
                          {"middle", json_of(limit.middle())},
                          {"shots", limit.shots},
                          {"failure", limit.failure.empty() ? Json() : Json(limit.failure)}});
    }
    return limits;
}

Json json_of_mean(const V50Findings& findings) {
    if (!findings.mean) return nullptr;
    Json names = Json::array();
    for (const auto i : findings.mean->shots) names.push_back(findings.shot_names[i]);
    return {{"v50", findings.mean->v50}, {"spread", findings.mean->spread}, {"shots", names}};
}

std::string result_name(ballistics::Result result) {
    if (result == ballistics::Result::none) return "none";
    return result == ballistics::Result::complete ? "complete" : "partial";
}

Json json_of_shots(const V50Plan& plan, const Campaign& campaign) {
    Json shots = Json::array();
    for (const auto& row : campaign.rows())
        shots.push_back({{"shot", row.number},
                         {"variant", plan.variants[row.variant].label},
                         {"speed", row.speed},
                         {"result", result_name(row.result)},
                         {"outcome", row.outcome},
                         {"reason", row.reason.empty() ? Json() : Json(row.reason)},
                         {"residual", json_of(row.residual)},
                         {"absorbed_energy", json_of(row.absorbed_energy)},
                         {"back_face_deflection", json_of(row.deflection)},
                         {"plies_perforated", json_of(row.plies_perforated)},
                         {"energy_error", json_of(row.energy_error)},
                         {"folder", row.folder}});
    for (const auto& [shot, where] : plan.range_shots)
        shots.push_back({{"shot", nullptr},
                         {"variant", "range"},
                         {"speed", shot.speed},
                         {"result", shot.is_complete ? "complete" : "partial"},
                         {"outcome", nullptr},
                         {"reason", nullptr},
                         {"residual", nullptr},
                         {"absorbed_energy", nullptr},
                         {"back_face_deflection", nullptr},
                         {"plies_perforated", nullptr},
                         {"energy_error", nullptr},
                         {"folder", where}});
    return shots;
}

}  // namespace

std::string json_of_v50(const V50Plan& plan, const Campaign& campaign, const V50Findings& findings) {
    Json zone;
    if (findings.zone && findings.zone->exists())
        zone = {{"lowest_complete", findings.zone->lowest_complete},
                {"highest_partial", findings.zone->highest_partial}};
    const Json document = {{"title", plan.title},
                           {"scene", plan.scene_name},
                           {"versions", library_versions()},
                           {"unit", {{"name", plan.unit.name}, {"si", plan.unit.si}}},
                           {"projectile_mass", plan.projectile_mass},
                           {"complete", plan.criterion.text},
                           {"confidence", plan.confidence},
                           {"is_scattered", !plan.scatter.empty()},
                           {"limits", json_of(plan, findings)},
                           {"spread", json_of(findings.spread)},
                           {"mixed_results", zone},
                           {"mil_std_662f", json_of_mean(findings)},
                           {"normal", json_of(findings.fits[0])},
                           {"logistic", json_of(findings.fits[1])},
                           {"recht_ipson", json_of(findings.recht_ipson)},
                           {"lambert_jonas", json_of(findings.lambert_jonas)},
                           {"shots", json_of_shots(plan, campaign)}};
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace weavefront::app
