#include "run_head.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string_view>

#include "revision.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

std::string now_text() {
    const std::time_t now = std::time(nullptr);
    return fmt::format("{:%Y-%m-%d %H:%M:%S %z}", fmt::localtime(now));
}

std::string hosts_text(const parallel::Communicator& comm) {
    std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
    int length = 0;
    parallel::check(MPI_Get_processor_name(name.data(), &length));
    std::vector<std::pair<std::string, int>> hosts;  // in the order of ranks
    for (const auto& other : parallel::all_gather(comm, name)) {
        const auto host =
            std::ranges::find(hosts, std::string(other.data()), &std::pair<std::string, int>::first);
        if (host == hosts.end())
            hosts.emplace_back(other.data(), 1);
        else
            ++host->second;
    }
    std::vector<std::string> texts;
    for (const auto& [host, ranks] : hosts)
        texts.push_back(fmt::format("{} ({} rank{})", host, ranks, ranks == 1 ? "" : "s"));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// In quotes where a shell would not take it for one word.
std::string shell_word(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+%@";
    constexpr std::size_t whole = 10'000;  // characters
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return word;
    std::string quoted;
    for (const char c : scene::printable(word, whole))
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + quoted + "'";
}

/// As the system keeps it: words that end with zeros.
std::string command_line() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(shell_word(word));
    return words.empty() ? "unknown" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::vector<std::string> run_head(const parallel::Communicator& comm) {
    return {"  started       " + now_text(), "  hosts         " + hosts_text(comm),
            "  command       " + command_line(), fmt::format("  revision      {}", revision)};
}

std::string run_tail(double seconds) {
    const auto duration = seconds < 10 ? fmt::format("{:.2f} s", seconds) : io::duration_text(seconds);
    return fmt::format("  ended         {}, after {}", now_text(), duration);
}

}  // namespace weavefront::app
