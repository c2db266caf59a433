#include "machine_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "json_object.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

using partition::Machine;

struct Constant {
    const char* key;
    double Machine::*value;
    double unit;  ///< in SI
    double least;
};

// A second, in ns, for what takes nanoseconds: above, sums over all elements of a run may overflow.
constexpr double most = 1e9;

constexpr std::array<Constant, 13> constants{{{"reference_ns", &Machine::reference_time, 1e-9, 1e-6},
                                              {"crowding", &Machine::crowding, 1, 1},
                                              {"element_ns", &Machine::element, 1e-9, 0},
                                              {"node_ns", &Machine::node, 1e-9, 0},
                                              {"watch_ns", &Machine::watch, 1e-9, 0},
                                              {"touch_ns", &Machine::touch, 1e-9, 0},
                                              {"press_ns", &Machine::press, 1e-9, 0},
                                              {"decay", &Machine::decay, 1, 0},
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

/// Reads the members into a machine; notes what is wrong.
class Reader {
  public:
    Reader(const std::vector<JsonMember>& members, const std::string& name)
        : members_(members), name_(name) {}

    Machine read() {
        check_keys();
        Machine machine;
        if (const auto* found = member("machine")) {
            if (found->value.is_string())
                machine.name = found->value.get<std::string>();
            else
                note(*found, "a text");
        }
        if (const auto* found = member("ranks")) {
            constexpr std::uint64_t most_ranks = 1'000'000;
            const auto count = found->value.is_number_unsigned() ? found->value.get<std::uint64_t>() : 0;
            if (count < 1 || count > most_ranks)
                note(*found, fmt::format("a whole number from 1 to {}", most_ranks));
            machine.ranks = static_cast<int>(std::min(count, most_ranks));
        }
        for (const auto& [key, value, unit, least] : constants) {
            const auto* found = member(key);
            if (found == nullptr) continue;
            const double number = found->value.is_number() ? found->value.get<double>() : -1;
            if (!(number >= least && number <= most))
                note(*found, fmt::format("a number of at least {} and at most {}", least, most));
            machine.*value = number * unit;
        }
        findings_.raise();
        return machine;
    }

  private:
    void check_keys() {
        const auto known = keys();
        std::map<std::string, std::string> places;
        for (const auto& [key, where, value] : members_) {
            const auto [first, is_new] = places.try_emplace(key, where);
            if (!is_new) {
                findings_.add(fmt::format("{}: {}: found the key again, first at {}, allowed once", where,
                                          scene::printable(key), first->second));
            } else if (std::ranges::find(known, key) == known.end()) {
                const std::string hint = scene::nearest(key, known);
                findings_.add(fmt::format("{}: {}: found an unknown key, allowed {}{}", where,
                                          scene::printable(key), fmt::join(known, ", "),
                                          hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint)));
            }
        }
        for (const auto& key : known)
            if (!places.contains(key))
                findings_.add(fmt::format("{}:1:1: {}: found nothing, allowed are all of {}", name_, key,
                                          fmt::join(known, ", ")));
    }

    [[nodiscard]] const JsonMember* member(const std::string& key) const {
        const auto found = std::ranges::find(members_, key, &JsonMember::key);
        return found == members_.end() ? nullptr : &*found;
    }

    void note(const JsonMember& member, const std::string& allowed) {
        findings_.add(fmt::format("{}: {}: found {}, allowed {}", member.where, member.key,
                                  scene::printable(member.value.dump()), allowed));
    }

    const std::vector<JsonMember>& members_;
    const std::string& name_;
    scene::MessageList findings_;
};

}  // namespace

Machine parse_machine(const std::string& text, const std::string& name) {
    return Reader(parse_json_object(text, name), name).read();
}

std::string machine_text(const Machine& machine) {
    std::string text = fmt::format("{{\n  \"machine\": {},\n  \"ranks\": {}",
                                   nlohmann::json(machine.name).dump(), machine.ranks);
    for (const auto& [key, value, unit, least] : constants)
        text += fmt::format(",\n  \"{}\": {:.4g}", key, machine.*value / unit);
    return text + "\n}\n";
}

}  // namespace weavefront::app
