#include "machine_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

using partition::Machine;

struct Constant {
    const char* key;
    double Machine::*value;
    double unit;  ///< in SI
    double least;
};

constexpr std::array<Constant, 13> constants{{{"pace_ns", &Machine::pace, 1e-9, 1e-6},
                                              {"crowding", &Machine::crowding, 1, 1},
                                              {"element_ns", &Machine::element, 1e-9, 0},
                                              {"node_ns", &Machine::node, 1e-9, 0},
                                              {"watch_ns", &Machine::watch, 1e-9, 0},
                                              {"touch_ns", &Machine::touch, 1e-9, 0},
                                              {"press_ns", &Machine::press, 1e-9, 0},
                                              {"relief", &Machine::relief, 1, 0},
                                              {"search_ns", &Machine::search, 1e-9, 0},
                                              {"searches_per_step", &Machine::searches_per_step, 1, 0},
                                              {"latency_us", &Machine::latency, 1e-6, 0},
                                              {"bandwidth_GB_per_s", &Machine::bandwidth, 1e9, 1e-6},
                                              {"reduction_us", &Machine::reduction, 1e-6, 0}}};

std::vector<std::string> keys() {
    std::vector<std::string> all{"machine", "ranks"};
    for (const auto& constant : constants) all.emplace_back(constant.key);
    return all;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) { throw scene::InputError({name + ": " + what}); }

void check_keys(const nlohmann::json& json, const std::string& name) {
    const auto known = keys();
    if (!json.is_object()) refuse(name, fmt::format("allowed is a JSON object with keys {}", fmt::join(known, ", ")));
    for (const auto& [key, value] : json.items()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        const std::string hint = scene::nearest(key, known);
        refuse(name, fmt::format("{}: found an unknown key, allowed {}{}", key, fmt::join(known, ", "),
                                 hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint)));
    }
    for (const auto& key : known)
        if (!json.contains(key)) refuse(name, fmt::format("{}: found nothing, allowed are all of {}", key, fmt::join(known, ", ")));
}

}  // namespace

Machine parse_machine(const std::string& text, const std::string& name) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded()) refuse(name, "not JSON");
    check_keys(json, name);
    Machine machine;
    if (!json["machine"].is_string()) refuse(name, "machine: allowed is a text");
    machine.name = json["machine"].get<std::string>();
    if (!json["ranks"].is_number_unsigned() || json["ranks"].get<std::uint64_t>() < 1 || json["ranks"].get<std::uint64_t>() > 1'000'000)
        refuse(name, fmt::format("ranks: found {}, allowed a whole number from 1 to 1000000", json["ranks"].dump()));
    machine.ranks = json["ranks"].get<int>();
    for (const auto& [key, value, unit, least] : constants) {
        if (!json[key].is_number() || !(json[key].get<double>() >= least))
            refuse(name, fmt::format("{}: found {}, allowed a number of at least {}", key, json[key].dump(), least));
        machine.*value = json[key].get<double>() * unit;
    }
    return machine;
}

std::string machine_text(const Machine& machine) {
    std::string text = fmt::format("{{\n  \"machine\": {},\n  \"ranks\": {}", nlohmann::json(machine.name).dump(), machine.ranks);
    for (const auto& [key, value, unit, least] : constants) text += fmt::format(",\n  \"{}\": {:.4g}", key, machine.*value / unit);
    return text + "\n}\n";
}

}  // namespace weavefront::app
