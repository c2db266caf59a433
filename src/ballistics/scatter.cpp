#include "weavefront/ballistics/scatter.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "weavefront/ballistics/response.hpp"

namespace weavefront::ballistics {

namespace {

struct Written {
    double number;
    std::string unit;
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<Written> written_of(std::string_view text) {
    text = trimmed(text);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    return Written{number, std::string(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))))};
}

/// Mixes the bits of a number: splitmix64 of G. L. Steele, D. Lea and C. H. Flood (2014).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
}

/// Above 0 and below 1.
double uniform_draw(const std::string& path, std::uint64_t seed, std::int64_t shot) {
    std::uint64_t bits = mixed(seed);
    for (const char c : path) bits = mixed(bits ^ static_cast<unsigned char>(c));
    bits = mixed(bits ^ static_cast<std::uint64_t>(shot));
    return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
}

constexpr auto allowed = "allowed PATH=normal(MEAN, DEVIATION), PATH=uniform(LOW, HIGH) or PATH=seed";

}  // namespace

std::variant<ScatterLaw, std::string> scatter_law_of(const std::string& text) {
    const auto wrong = [&](std::string_view why) {
        return fmt::format("found '{}', {}{}", text, allowed, why);
    };
    const auto equals = text.find('=');
    if (equals == text.npos || equals == 0) return wrong("");
    ScatterLaw law;
    law.path = trimmed(std::string_view(text).substr(0, equals));
    const auto value = trimmed(std::string_view(text).substr(equals + 1));
    if (value == "seed") {
        law.kind = ScatterLaw::Kind::seed;
        return law;
    }
    const auto open = value.find('('), comma = value.find(',');
    if (open == value.npos || comma == value.npos || comma < open || value.back() != ')') return wrong("");
    const auto name = trimmed(value.substr(0, open));
    if (name != "normal" && name != "uniform") return wrong("");
    law.kind = name == "normal" ? ScatterLaw::Kind::normal : ScatterLaw::Kind::uniform;
    const auto first = written_of(value.substr(open + 1, comma - open - 1));
    const auto second = written_of(value.substr(comma + 1, value.size() - comma - 2));
    if (!first || !second) return wrong(": numbers with their unit");
    if (first->unit != second->unit) return wrong(": both values in the same unit");
    law.first = first->number;
    law.second = second->number;
    law.unit = first->unit;
    if (law.kind == ScatterLaw::Kind::normal && !(law.second > 0)) return wrong(": a DEVIATION above 0");
    if (law.kind == ScatterLaw::Kind::uniform && !(law.second > law.first)) return wrong(": LOW below HIGH");
    return law;
}

std::string drawn_setting(const ScatterLaw& law, std::uint64_t seed, std::int64_t shot) {
    if (law.kind == ScatterLaw::Kind::seed)
        return fmt::format("{}={}", law.path, seed + static_cast<std::uint64_t>(shot));
    const double u = uniform_draw(law.path, seed, shot);
    const double value = law.kind == ScatterLaw::Kind::normal
                             ? law.first + law.second * deviations_at(Distribution::normal, u)
                             : law.first + (law.second - law.first) * u;
    // Ten digits: the last bits of a quantile may differ between machines.
    return fmt::format("{}={:.10g}{}{}", law.path, value, law.unit.empty() ? "" : " ", law.unit);
}

}  // namespace weavefront::ballistics
