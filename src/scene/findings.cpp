#include "findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
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

void Findings::take(Findings& other) {
    std::ranges::move(other.findings_, std::back_inserter(findings_));
    other.findings_.clear();
}

std::vector<std::string> Findings::messages() const {
    std::vector<Finding> sorted = findings_;
    std::ranges::stable_sort(sorted, {}, [](const Finding& finding) { return std::tuple(finding.line, finding.column); });
    std::vector<std::string> messages;
    for (Finding& finding : sorted) messages.push_back(std::move(finding.text));
    return messages;
}

void Findings::raise() const {
    if (!findings_.empty()) throw InputError(messages());
}

}  // namespace weavefront::scene
