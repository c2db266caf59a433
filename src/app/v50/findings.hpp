#pragma once
/// @file
/// What the shots of `v50` say.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "campaign.hpp"
#include "v50_plan.hpp"
#include "weavefront/ballistics/fit.hpp"
#include "weavefront/ballistics/mean_limit.hpp"
#include "weavefront/ballistics/residual_velocity.hpp"

namespace weavefront::app {

/// The limit of one variant.
struct VariantLimit {
    ballistics::Bracket bracket;
    int shots = 0;
    std::string failure;  ///< why the bracket is not as narrow as asked for; empty: it is

    /// Middle of the bracket, m/s; none: it has an open end
    [[nodiscard]] std::optional<double> middle() const;
};

struct V50Findings {
    std::vector<ballistics::Shot> shots;  ///< of the scene as it stands, then of the range
    std::vector<std::string> shot_names;  ///< folders, or file:line
    std::vector<VariantLimit> limits;     ///< one a variant
    std::optional<double> spread;         ///< of the limits of all variants, m/s; none: one variant
    std::optional<ballistics::MixedZone> zone;
    std::optional<ballistics::MeanLimit> mean;
    std::vector<std::variant<ballistics::Fit, std::string>> fits;  ///< normal, logistic; or why there is none
    std::optional<ballistics::ResidualCurve> recht_ipson, lambert_jonas;
};

V50Findings find_v50(const V50Plan& plan, const Campaign& campaign);

/// The closing lines of the log.
void report_v50(const V50Plan& plan, const V50Findings& findings, io::Log& log);

/// Text of v50.json. SI units.
std::string json_of_v50(const V50Plan& plan, const Campaign& campaign, const V50Findings& findings);

}  // namespace weavefront::app
