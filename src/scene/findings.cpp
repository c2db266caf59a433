#include "findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {

namespace {

constexpr std::size_t most_shown = 20, most_kept = 1000;

// Characters of a message, which lists a hundred names at most.
constexpr std::size_t most_of_message = 3000;

std::vector<std::string> first_of(const std::vector<std::string>& messages, std::size_t more) {
    const auto count = std::min(messages.size(), most_shown);
    std::vector<std::string> first(messages.begin(), messages.begin() + static_cast<std::ptrdiff_t>(count));
    if (more += messages.size() - count; more > 0) first.push_back(fmt::format("and {} more", more));
    return first;
}

}  // namespace

InputError::InputError(std::vector<std::string> messages, std::size_t more)
    : std::runtime_error(fmt::format("{}", fmt::join(first_of(messages, more), "\n"))),
      messages_(std::move(messages)),
      more_(more) {}

std::vector<std::string> InputError::shown() const { return first_of(messages_, more_); }

void MessageList::add(const std::string& message) {
    if (messages_.size() < most_kept)
        messages_.push_back(printable(message, most_of_message));
    else
        ++more_;
}

void MessageList::raise() const {
    if (!messages_.empty()) throw InputError(messages_, more_);
}

bool Findings::full() const { return findings_.size() >= most_kept; }

void Findings::add(const Location& where, std::string_view path, std::string_view what) {
    if (silent_) return;
    if (full()) return count(1);
    const std::string_view separator = path.empty() ? "" : ": ";
    findings_.push_back(
        {where.line, where.column,
         printable(fmt::format("{}: {}{}{}", where.text, path, separator, what), most_of_message)});
}

void Findings::add(const Location& where, std::string_view path, std::string_view found,
                   std::string_view allowed, std::string_view hint) {
    const std::string question = hint.empty() ? "" : fmt::format(", did you mean '{}'?", hint);
    add(where, path, fmt::format("found {}, allowed {}{}", found, allowed, question));
}

void Findings::take(Findings& other) {
    std::ranges::move(other.findings_, std::back_inserter(findings_));
    more_ += other.more_;
    other = {};
}

std::vector<std::string> Findings::messages() const {
    std::vector<Finding> sorted = findings_;
    std::ranges::stable_sort(sorted, {},
                             [](const Finding& finding) { return std::tuple(finding.line, finding.column); });
    std::vector<std::string> messages;
    for (Finding& finding : sorted) messages.push_back(std::move(finding.text));
    return messages;
}

void Findings::raise() const {
    if (!findings_.empty()) throw InputError(messages(), more_);
}

}  // namespace weavefront::scene
