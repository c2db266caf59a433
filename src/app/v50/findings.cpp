#include "findings.hpp"

#include <algorithm>
#include <array>

namespace weavefront::app {

namespace {

constexpr std::array distributions{ballistics::Distribution::normal, ballistics::Distribution::logistic};

// Of the curve and its band in the picture, V05, V50 and V95 among them.
constexpr std::array probabilities{0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4,  0.45, 0.5,
                                   0.55, 0.6,  0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 0.98, 0.99};

std::vector<ballistics::Perforation> perforations(const Campaign& campaign) {
    std::vector<ballistics::Perforation> found;
    for (const auto& row : campaign.rows())
        if (row.variant == 0 && row.result == ballistics::Result::complete && row.residual &&
            *row.residual > 0)
            found.push_back({row.speed, *row.residual});
    return found;
}

std::optional<double> spread_of(const std::vector<VariantLimit>& limits) {
    std::vector<double> middles;
    for (const auto& limit : limits)
        if (const auto middle = limit.middle()) middles.push_back(*middle);
    if (middles.size() < 2) return std::nullopt;
    const auto [least, most] = std::ranges::minmax(middles);
    return most - least;
}

}  // namespace

std::optional<double> VariantLimit::middle() const {
    if (!bracket.low || !bracket.high) return std::nullopt;
    return 0.5 * (*bracket.low + *bracket.high);
}

V50Findings find_v50(const V50Plan& plan, const Campaign& campaign) {
    V50Findings findings;
    for (const auto& row : campaign.rows()) {
        if (row.variant != 0 || row.result == ballistics::Result::none) continue;
        findings.shots.push_back({row.speed, row.result == ballistics::Result::complete});
        findings.shot_names.push_back(row.folder);
    }
    for (const auto& [shot, where] : plan.range_shots) {
        findings.shots.push_back(shot);
        findings.shot_names.push_back(where);
    }
    for (std::size_t i = 0; i < plan.variants.size(); ++i) {
        const auto trials = campaign.trials(i);
        findings.limits.push_back(
            {ballistics::bracket_of(trials), static_cast<int>(trials.size()), campaign.failures()[i]});
    }
    findings.spread = spread_of(findings.limits);
    findings.zone = ballistics::mixed_zone(findings.shots);
    findings.mean = ballistics::mean_limit(findings.shots);
    for (const auto distribution : distributions)
        findings.fits.push_back(
            ballistics::fit(findings.shots, distribution, probabilities, plan.confidence));
    const auto through = perforations(campaign);
    findings.recht_ipson = ballistics::fit_recht_ipson(through);
    findings.lambert_jonas = ballistics::fit_lambert_jonas(through);
    return findings;
}

}  // namespace weavefront::app
