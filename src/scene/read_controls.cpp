#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"

namespace weavefront::scene {
namespace {

constexpr Range safety_factor{0, false, 1.2, " greater than 0 and at most 1.2"};
constexpr double most_frames = 1e6;

}  // namespace

Scene::Time read_time(Section& section) {
    Scene::Time time;
    time.end = section.quantity("end", duration, positive);
    time.safety = section.quantity("safety", ratio, safety_factor, time.safety);
    time.stop = section.choice("stop", stop_names, time.stop);
    section.unavailable({"subcycling"});
    return time;
}

Scene::Limits read_limits(Section& section) {
    return {.energy_error = section.quantity("energy_error", ratio, positive, 0.05)};
}

Output read_output(Section& section, double end) {
    Output output;
    output.interval = section.quantity("interval", duration, non_negative);
    output.history = section.quantity("history", duration, positive);
    output.fields =
        section.choices("fields", field_names, {Field::displacement, Field::stress, Field::broken});
    std::ranges::sort(output.fields);
    const auto at_most_end = [&](std::string_view key) {
        return fmt::format("at most {}, time.end", at_most_text(end, section.unit_of(key, duration)));
    };
    section.refuse_if(output.interval > end, "interval", at_most_end("interval"));
    section.refuse_if(output.interval > 0 && end / output.interval > most_frames, "interval",
                      fmt::format("0 or at least {}, a millionth of time.end",
                                  at_least_text(end / most_frames, section.unit_of("interval", duration))));
    section.refuse_if(output.history > end, "history", at_most_end("history"));
    section.options_of_run({"checkpoint"});
    return output;
}

}  // namespace weavefront::scene
