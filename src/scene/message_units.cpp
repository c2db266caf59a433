#include "weavefront/scene/message_units.hpp"

#include <fmt/format.h>

#include <cmath>

namespace weavefront::scene {
namespace {

constexpr int digits_of_bound = 6;

/// Rounded to the digits of a bound by `round`, std::floor or std::ceil.
template <class Round>
std::string bound_text(double si, const MessageUnit& unit, Round round) {
    const double value = si / unit.si;
    if (value == 0 || !std::isfinite(value)) return text_of(si, unit, digits_of_bound);
    // What is short in decimals, as 0.1 mm, has none to round away.
    const double shift = std::pow(10, digits_of_bound - 1 - std::floor(std::log10(std::abs(value)))),
                 steps = value * shift;
    const double nearest = std::round(steps), rounding = 1e-9 * std::abs(steps);
    const double kept = std::abs(steps - nearest) <= rounding ? nearest : round(steps);
    return fmt::format("{:.{}g} {}", kept / shift, digits_of_bound, unit.name);
}

}  // namespace

std::string text_of(double si, const MessageUnit& unit, int digits) {
    return fmt::format("{:.{}g} {}", si / unit.si, digits, unit.name);
}

std::string at_most_text(double si, const MessageUnit& unit) {
    return bound_text(si, unit, [](double steps) { return std::floor(steps); });
}

std::string at_least_text(double si, const MessageUnit& unit) {
    return bound_text(si, unit, [](double steps) { return std::ceil(steps); });
}

}  // namespace weavefront::scene
