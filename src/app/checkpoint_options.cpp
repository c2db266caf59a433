#include "checkpoint_options.hpp"

#include <fmt/format.h>

#include <sstream>
#include <variant>

#include "weavefront/scene/quantity.hpp"

namespace weavefront::app {
namespace {

std::string read_duration(const std::string& text, std::optional<double>& seconds,
                          const std::string& example) {
    const auto read = scene::duration_of(text);
    if (const auto* problem = std::get_if<std::string>(&read)) return *problem + example;
    if (!(std::get<double>(read) > 0))
        return fmt::format("found '{}', allowed a time above 0{}", text, example);
    seconds = std::get<double>(read);
    return {};
}

}  // namespace

std::string read_checkpoint_interval(const std::string& text, CheckpointPlan& plan) {
    std::istringstream words(text);
    std::int64_t count = 0;
    std::string unit, rest;
    if (words >> count >> unit && (unit == "steps" || unit == "step") && !(words >> rest)) {
        if (count <= 0) return fmt::format("found '{}', allowed at least 1 step", text);
        plan.steps = count;
        return {};
    }
    return read_duration(text, plan.interval, ", such as '10 min' or '5000 steps'");
}

std::string read_walltime(const std::string& text, CheckpointPlan& plan) {
    return read_duration(text, plan.walltime, ", such as '2 h'");
}

}  // namespace weavefront::app
