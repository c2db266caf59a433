#include "findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "weavefront/scene/read.hpp"

namespace weavefront::scene {

InputError::InputError(std::vector<std::string> messages)
    : std::runtime_error(fmt::format("{}", fmt::join(messages, "\n"))), messages_(std::move(messages)) {}

void Findings::add(const Location& where, std::string_view path, std::string_view what) {
    if (silent_) return;
    const std::string_view separator = path.empty() ? "" : ": ";
    findings_.push_back({where.line, where.column, fmt::format("{}: {}{}{}", where.text, path, separator, what)});
}

void Findings::add(const Location& where, std::string_view path, std::string_view found, std::string_view allowed, std::string_view hint) {
    const std::string question = hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint);
    add(where, path, fmt::format("found {}, allowed {}{}", found, allowed, question));
}

void Findings::raise() {
    if (findings_.empty()) return;
    const auto position = [](const Finding& finding) { return std::tuple(finding.line, finding.column); };
    std::ranges::stable_sort(findings_, {}, position);
    std::vector<std::string> messages;
    for (Finding& finding : findings_) messages.push_back(std::move(finding.text));
    throw InputError(std::move(messages));
}

}  // namespace weavefront::scene
