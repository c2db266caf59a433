#include <fmt/format.h>
#include <fmt/ranges.h>

#include "findings.hpp"

namespace weavefront::app {

namespace {

std::string interval_text(const ballistics::Estimate& estimate, double unit) {
    const auto end = [&](const std::optional<double>& value) {
        return value ? fmt::format("{:.2f}", *value / unit) : std::string("open");
    };
    return fmt::format("{:.2f} ({} to {})", estimate.value / unit, end(estimate.lower), end(estimate.upper));
}

std::string limit_text(const SpeedUnit& unit, const VariantLimit& limit) {
    const auto& [low, high] = limit.bracket;
    std::string text = low && high ? unit.text(*low, *high)
                       : low       ? "above " + unit.text(*low)
                       : high      ? "below " + unit.text(*high)
                                   : "unknown";
    text += fmt::format(", {} shots", limit.shots);
    return limit.failure.empty() ? text : text + ": " + limit.failure;
}

void report_fit(const SpeedUnit& unit, const ballistics::Fit& fit, io::Log& log) {
    log.info(fmt::format("  {:<13} V50 {}, sigma {}, V05 {}, V95 {} {} ({:.4g} % intervals)",
                         ballistics::name_of(fit.response.distribution),
                         interval_text(fit.speed_at(0.5), unit.si), interval_text(fit.sigma, unit.si),
                         interval_text(fit.speed_at(0.05), unit.si),
                         interval_text(fit.speed_at(0.95), unit.si), unit.name, fit.confidence * 100));
}

void report_statistics(const V50Plan& plan, const V50Findings& findings, io::Log& log) {
    if (findings.zone && findings.zone->exists())
        log.info("  mixed results " +
                 plan.unit.text(findings.zone->lowest_complete, findings.zone->highest_partial));
    if (const auto* refusal = std::get_if<std::string>(&findings.fits.front())) {
        log.info("  S-curve       " + *refusal);
    } else {
        for (const auto& fit : findings.fits)
            if (const auto* found = std::get_if<ballistics::Fit>(&fit)) report_fit(plan.unit, *found, log);
    }
    if (findings.mean)
        log.info(fmt::format("  MIL-STD-662F  V50 {}, {} partial and {} complete penetrations within {}",
                             plan.unit.text(findings.mean->v50), findings.mean->shots.size() / 2,
                             findings.mean->shots.size() / 2, plan.unit.text(findings.mean->spread)));
    else
        log.info(
            "  MIL-STD-662F  no arithmetic V50: fewer than three partial and three complete penetrations "
            "within " +
            plan.unit.text(ballistics::most_spread));
}

void report_curves(const V50Plan& plan, const V50Findings& findings, io::Log& log) {
    if (findings.recht_ipson)
        log.info(fmt::format("  Recht-Ipson   V50 {}, off the residual velocities by {}",
                             plan.unit.text(findings.recht_ipson->v50),
                             plan.unit.text(findings.recht_ipson->deviation)));
    if (findings.lambert_jonas)
        log.info(fmt::format("  Lambert-Jonas V50 {}, a = {:.4f}, p = {:.3f}, off by {}",
                             plan.unit.text(findings.lambert_jonas->v50), findings.lambert_jonas->a,
                             findings.lambert_jonas->p, plan.unit.text(findings.lambert_jonas->deviation)));
}

}  // namespace

void report_v50(const V50Plan& plan, const V50Findings& findings, io::Log& log) {
    log.info(fmt::format("Ballistic limit: complete means {}", plan.criterion.text));
    if (plan.scatter.empty())
        for (std::size_t i = 0; i < findings.limits.size(); ++i)
            log.info(fmt::format("  {:<13} {}", i == 0 ? "limit" : plan.variants[i].label,
                                 limit_text(plan.unit, findings.limits[i])));
    if (findings.spread)
        log.info(fmt::format("  spread        {} over {} variants of mesh and contact stiffness",
                             plan.unit.text(*findings.spread), findings.limits.size()));
    report_statistics(plan, findings, log);
    report_curves(plan, findings, log);
}

}  // namespace weavefront::app
