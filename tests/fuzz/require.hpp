#pragma once
/// @file
/// What every reader promises, whatever it reads.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::fuzz {

/// Ends the program, which the fuzzer takes for a finding, unless `promise` holds.
inline void require(bool promise, std::string_view what, std::string_view about = {}) {
    if (promise) return;
    std::fprintf(stderr, "broken promise: %s: %s\n", std::string(what).c_str(), std::string(about).c_str());
    std::abort();
}

/// Whether a message begins with `file:line:column: ` or `--set PATH=VALUE: `, or says why a file cannot be
/// read.
inline bool has_place(const std::string& message) {
    const auto skip_digits = [&](std::size_t at) {
        return std::min(message.find_first_not_of("0123456789", at), message.size());
    };
    const auto line = message.find(':') + 1, after_line = skip_digits(line);
    const bool numbered = line > 1 && after_line > line && message[after_line] == ':' &&
                          message.compare(skip_digits(after_line + 1), 2, ": ") == 0;
    return numbered || message.starts_with("--set ") || message.find(": cannot be read: ") != message.npos;
}

/// A refusal has a message, and each message is one line of text of bounded length with a place.
inline void require_messages(const scene::InputError& refusal) {
    constexpr std::size_t longest = 4000;
    require(!refusal.messages().empty(), "a refusal has a message");
    for (const std::string& message : refusal.shown()) {
        std::size_t at = 0;
        require(message.size() < longest, "messages are short", message);
        require(scene::fault_of_text(message, at).empty() && message.find_first_of("\n\t\r") == message.npos,
                "messages are one line of text", message);
    }
    for (const std::string& message : refusal.messages())
        require(has_place(message), "messages have a place", message);
}

}  // namespace weavefront::fuzz
