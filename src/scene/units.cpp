#include "units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "utf8.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

constexpr std::array known_dimensions{length,  area,          mass,    duration,  rate,          speed,
                                      density, areal_density, modulus, viscosity, area_stiffness};

Unit parse_unit(ut_system* system, std::string_view text) {
    return {ut_parse(system, std::string(text).c_str(), UT_UTF8), &ut_free};
}

double to_double(std::string_view text) {
    double value = std::numeric_limits<double>::quiet_NaN();
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// number * 10^shift, rounded once.
double shifted(std::string_view number, int shift) {
    const std::size_t e = number.find_first_of("eE");
    int exponent = 0;
    if (e != number.npos) {
        const std::size_t digits = e + (number[e + 1] == '+' ? 2 : 1);
        std::from_chars(number.data() + digits, number.data() + number.size(), exponent);
    }
    return to_double(fmt::format("{}e{}", number.substr(0, e), exponent + shift));
}

double scaled(std::string_view number, double scale) {
    const int power = static_cast<int>(std::lround(std::log10(scale)));
    const double rounding = 1e-13;  // udunits2 multiplies a handful of factors, each rounded to 1.1e-16
    if (std::abs(scale / to_double(fmt::format("1e{}", power)) - 1) < rounding) return shifted(number, power);
    return to_double(number) * scale;
}

/// Every space of Unicode as the plain one: texts copied from a PDF have no-break and thin ones between
/// number and unit.
std::string with_plain_spaces(std::string_view text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, bytes] = first_character(text.substr(at));
        const std::size_t length = std::max<std::size_t>(bytes, 1);
        if (bytes > 0 && is_other_space(code))
            plain += ' ';
        else
            plain += text.substr(at, length);
        at += length;
    }
    return plain;
}

/// What is wrong with a sign that looks like a minus; empty: it is none.
std::string minus_lookalike(std::string_view text) {
    if (text.empty()) return {};
    const auto code = first_character(text).code;
    const bool dash = (code >= 0x2010 && code <= 0x2015) || code == 0x2212;
    return dash ? fmt::format("a dash U+{:04X} in place of the minus sign '-'",
                              static_cast<std::uint32_t>(code))
                : std::string();
}

// udunits2 does not know `deg`, and takes angles for plain numbers.
std::optional<double> read_angle(std::string_view number, std::string_view unit) {
    if (unit == "rad" || unit == "radian" || unit == "radians") return to_double(number);
    if (unit == "deg" || unit == "degree" || unit == "degrees" || unit == "°")
        return to_double(number) / 180 * std::numbers::pi;
    return std::nullopt;
}

// Units of the trade that udunits2 does not know, or takes for others (oz: a volume, mph: a brightness), and
// how it writes them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> of_the_trade{
    {{"oz", "avoirdupois_ounce"},
     {"gsm", "g/m^2"},
     {"fps", "ft/s"},
     {"mph", "mile/hour"},
     {"kph", "km/hour"},
     {"kmh", "km/hour"}}};

/// A unit with the first word that is of the trade as udunits2 writes it; empty: none is.
std::string written_out(std::string_view unit) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    for (auto first = std::ranges::find_if(unit, is_letter); first != unit.end();) {
        const auto last = std::find_if_not(first, unit.end(), is_letter);
        const auto* known = std::ranges::find(of_the_trade, std::string_view(first, last),
                                              [](const auto& pair) { return pair.first; });
        if (known != of_the_trade.end())
            return fmt::format("{}{}{}", std::string_view(unit.begin(), first), known->second,
                               std::string_view(last, unit.end()));
        first = std::find_if(last, unit.end(), is_letter);
    }
    return {};
}

std::string describe(ut_system* system, ut_unit* unit) {
    for (const Dimension& dimension : known_dimensions) {
        if (ut_are_convertible(unit, parse_unit(system, dimension.si).get()) != 0)
            return std::string(dimension.name);
    }
    std::array<char, 128> text{};
    const int size = ut_format(unit, text.data(), text.size(), UT_ASCII | UT_DEFINITION);
    return size > 0 && size < static_cast<int>(text.size()) ? fmt::format("a quantity in {}", text.data())
                                                            : "another quantity";
}

}  // namespace

Units::Units() : system_(nullptr, &ut_free_system) {
    ut_set_error_message_handler(&ut_ignore);
    system_.reset(ut_read_xml(nullptr));
    if (!system_)
        throw std::runtime_error(
            "the unit database of udunits2 cannot be read (package libudunits2-data; UDUNITS2_XML_PATH)");
}

const Units& shared_units() {
    static thread_local const Units units;
    return units;
}

Quantity Units::read(std::string_view text, const Dimension& wanted) const {
    const std::string plain = with_plain_spaces(text);
    if (plain != text) return read(plain, wanted);
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    if (const auto minus = minus_lookalike(text); !minus.empty()) return {.problem = minus};
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument) return {.problem = "not a number"};
    if (error == std::errc::result_out_of_range) return {.problem = "beyond the range of numbers"};
    if (!std::isfinite(value)) return {.problem = "not a finite number"};

    const std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.data()));
    const std::string_view unit = trimmed(text.substr(number.size()));
    if (unit.empty() && (wanted.si.empty() || value == 0)) return {.value = value};
    if (unit.empty()) return {.problem = "a number without a unit"};
    if (const auto radians = read_angle(number, unit)) {
        if (wanted.name == angle.name) return {.value = *radians};
        return {.problem = std::string(angle.name)};
    }
    Quantity quantity = convert(number, unit, wanted);
    quantity.unit = unit;
    if (quantity.problem.empty()) return quantity;
    if (unit[0] == ',' && quantity.nearest.empty()) {
        const std::string meant = fmt::format("{}.{}", number, unit.substr(1));
        if (read(meant, wanted).problem.empty()) quantity.nearest = meant;
    }
    if (const auto meant = written_out(unit);
        !meant.empty() && convert(number, meant, wanted).problem.empty())
        quantity.nearest = fmt::format("{} {}", number, meant);
    return quantity;
}

Quantity Units::convert(std::string_view number, std::string_view unit, const Dimension& wanted) const {
    constexpr std::string_view of_numbers = "0123456789.,+-";
    const bool second_number = of_numbers.find(unit[0]) != of_numbers.npos && !unit.starts_with("1/");
    const Unit from = parse_unit(system_.get(), unit);
    if (second_number || !from) return {.problem = fmt::format("'{}' is not a unit", printable(unit))};
    if (wanted.name == angle.name) return {.problem = describe(system_.get(), from.get())};

    const Unit to = parse_unit(system_.get(), wanted.si);
    if (ut_are_convertible(from.get(), to.get()) == 0)
        return {.problem = describe(system_.get(), from.get())};
    const Converter converter(ut_get_converter(from.get(), to.get()), &cv_free);
    const double scale = converter ? cv_convert_double(converter.get(), 1.0) : 0;
    const bool pure_scale = converter && cv_convert_double(converter.get(), 0.0) == 0 && scale > 0;
    if (!pure_scale) return {.problem = fmt::format("'{}' is not a scale from zero", printable(unit))};
    const double value = scaled(number, scale);
    if (!std::isfinite(value)) return {.problem = "beyond the range of numbers"};
    return {.value = value};
}

}  // namespace weavefront::scene
