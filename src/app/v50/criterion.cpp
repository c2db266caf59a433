#include "criterion.hpp"

#include <fmt/format.h>

#include "weavefront/scene/quantity.hpp"
#include "weavefront/solver/outcome.hpp"

namespace weavefront::app {

std::variant<Criterion, std::string> criterion_of(const std::string& text) {
    const std::string witness = "witness";
    if (text == "perforated") return Criterion{};
    if (text == "any-ply") return Criterion{Criterion::Kind::any_ply, 0, text};
    if (text.starts_with(witness)) {
        const auto speed = scene::speed_of(text.substr(witness.size()));
        if (const auto* found = std::get_if<scene::WrittenSpeed>(&speed); found && found->si >= 0)
            return Criterion{Criterion::Kind::witness, found->si, text};
    }
    return fmt::format(
        "found '{}', allowed 'perforated', 'any-ply' or 'witness SPEED', such as 'witness 30 m/s'", text);
}

ballistics::Result result_of(const Criterion& criterion, const std::string& verdict,
                             std::int64_t plies_perforated, double residual) {
    using ballistics::Result;
    const bool is_perforated = verdict == solver::name_of(solver::Verdict::perforated);
    const bool is_stopped = verdict == solver::name_of(solver::Verdict::stopped);
    if (criterion.kind == Criterion::Kind::any_ply && plies_perforated > 0) return Result::complete;
    if (is_perforated)
        return criterion.kind == Criterion::Kind::witness && residual < criterion.least_residual
                   ? Result::partial
                   : Result::complete;
    return is_stopped ? Result::partial : Result::none;
}

}  // namespace weavefront::app
