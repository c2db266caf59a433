#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace weavefront::stability {

namespace {

/// Two digits, and all before the point.
std::string percent(double share) {
    if (share == 0) return "0";
    return share < 1 ? fmt::format("{:.2g} %", share * 100) : fmt::format("{:.0f} %", share * 100);
}

std::string outcome_of(const Result& result) {
    switch (result.outcome) {
        case Outcome::stopped:
            return "guard: " + result.message;
        case Outcome::refused:
            return "refused: " + result.message;
        case Outcome::crashed:
            return "crashed: " + result.message;
        case Outcome::endless:
            return fmt::format("no end in sight at t = {:.3g} us", result.time * 1e6);
        case Outcome::finished:
            break;
    }
    if (result.broken_yarns == 0) return "finished";
    return fmt::format("finished, {} broken, {} eroded", result.broken_yarns, result.eroded_elements);
}

std::string expectation_of(const Case& trial) {
    switch (trial.expected) {
        case Expected::finish:
            return "finish";
        case Expected::guard:
            return "guard: " + trial.reason;
        case Expected::either:
            break;
    }
    return "either: " + trial.reason;
}

std::ofstream open(const std::filesystem::path& file) {
    std::ofstream out(file);
    if (!out) throw std::runtime_error("cannot write " + file.string());
    return out;
}

std::string quoted(std::string text) {
    std::ranges::replace(text, '"', '\'');
    return '"' + text + '"';
}

/// The part of a markdown row that both formulations have.
std::string numbers_of(const Row& row) {
    const auto& r = row.result;
    return fmt::format("{} | {} | {} | {} | {} | {}{}", r.steps, percent(r.energy_error), percent(r.given),
                       percent(r.given_by_single), percent(r.hourglass_share),
                       row.ok ? "" : "NOT OK: ", outcome_of(r));
}

}  // namespace

bool is_as_expected(const Case& trial, const std::string& formulation, const Result& result,
                    const Result* same) {
    if (!result.finite) return false;
    if (result.outcome != Outcome::finished && result.outcome != Outcome::stopped) return false;
    if (same && (same->bits != result.bits || same->steps != result.steps)) return false;
    if (formulation != "consistent") return true;
    const bool closes = result.outcome == Outcome::finished && result.energy_error < energy_tolerance &&
                        result.given < energy_tolerance;
    if (trial.expected == Expected::finish) return closes;
    if (trial.expected == Expected::guard) return result.outcome == Outcome::stopped;
    return closes || result.outcome == Outcome::stopped;
}

std::string text_of(const Row& row, std::size_t width) {
    const auto& r = row.result;
    return fmt::format(
        "{:<{}}  {:<10}  {:>7}  {:>9}  {:>9}  {:>9}  {:>9}  {:>5.1f} s  {:<6}  {}", row.trial.name, width,
        row.formulation, r.steps, percent(r.energy_error), percent(r.given), percent(r.given_by_single),
        percent(r.hourglass_share), r.seconds, row.ok ? "ok" : "NOT OK",
        outcome_of(r) +
            (row.trial.expected == Expected::finish ? "" : " [" + expectation_of(row.trial) + "]") +
            (r.finite ? "" : " NOT FINITE"));
}

void write_csv(const std::filesystem::path& file, const std::vector<Row>& rows) {
    auto out = open(file);
    out << "family,case,what,formulation,steps,time,energy_error,given,given_by_single,hourglass_share,"
           "outcome,expected,ok\n";
    for (const auto& row : rows) {
        const auto& r = row.result;
        out << fmt::format("{},{},{},{},{},{:.9g},{:.3g},{:.3g},{:.3g},{:.3g},{},{},{}\n", row.trial.family,
                           row.trial.name, quoted(row.trial.what), row.formulation, r.steps, r.time,
                           r.energy_error, r.given, r.given_by_single, r.hourglass_share,
                           quoted(outcome_of(r)), quoted(expectation_of(row.trial)),
                           row.ok ? "ok" : "NOT OK");
    }
}

void write_markdown(const std::filesystem::path& file, const std::vector<Row>& rows) {
    auto out = open(file);
    out << "| case | what | expected | steps | error | given | by single | hourglass | outcome "
           "| paper: steps | error | given | by single | hourglass | outcome |\n";
    out << "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const auto& row : rows) {
        if (row.formulation != "consistent") continue;
        const auto paper = std::ranges::find_if(rows, [&](const Row& other) {
            return other.formulation == "paper" && other.trial.name == row.trial.name;
        });
        out << fmt::format("| `{}` | {} | {} | {} | {} |\n", row.trial.name, row.trial.what,
                           expectation_of(row.trial), numbers_of(row),
                           paper == rows.end() ? " | | | | |" : numbers_of(*paper));
    }
}

}  // namespace weavefront::stability
