/// Prints the stability table; exit status 1 when a row is not as expected.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base_scene.hpp"
#include "cases.hpp"
#include "table.hpp"

namespace weavefront::stability {

namespace {

struct Options {
    bool reduced = false;
    std::vector<std::string> names, overrides;
    std::string formulation = "both";
    std::filesystem::path csv, markdown;
};

bool is_named(const Case& trial, const Options& options) {
    return std::ranges::find(options.names, trial.name) != options.names.end();
}

/// The cases asked for, and those whose bits they must have.
std::vector<Case> wanted(const Options& options) {
    const auto all = all_cases();
    std::vector<Case> chosen;
    for (const auto& trial : all) {
        const bool model = std::ranges::any_of(
            all, [&](const Case& copy) { return copy.same_as == trial.name && is_named(copy, options); });
        if (options.names.empty() ? options.reduced && !trial.reduced : !model && !is_named(trial, options))
            continue;
        chosen.push_back(trial);
        auto& overrides = chosen.back().overrides;
        overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
    }
    return chosen;
}

/// Runs the chosen cases, a line each as they end.
std::vector<Row> rows_of(const Options& options, const parallel::Communicator& comm) {
    std::vector<Row> rows;
    for (const auto& trial : wanted(options)) {
        for (const std::string formulation : {"consistent", "paper"}) {
            if (options.formulation != "both" && options.formulation != formulation) continue;
            Row row{trial, formulation, run(trial, base_scene, formulation, comm), true};
            const auto same = std::ranges::find_if(rows, [&](const Row& other) {
                return other.trial.name == trial.same_as && other.formulation == formulation;
            });
            row.ok =
                is_as_expected(trial, formulation, row.result, same == rows.end() ? nullptr : &same->result);
            fmt::print("{}\n", text_of(row, 20));
            std::fflush(stdout);
            rows.push_back(row);
        }
    }
    return rows;
}

int print_table(const Options& options) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    fmt::print("{:<20}  {:<10}  {:>7}  {:>9}  {:>9}  {:>9}  {:>9}  {:>7}\n", "case", "", "steps", "error",
               "given", "by single", "hourglass", "wall");
    const auto rows = rows_of(options, comm);
    if (!options.csv.empty()) write_csv(options.csv, rows);
    if (!options.markdown.empty()) write_markdown(options.markdown, rows);
    const auto bad = std::ranges::count_if(rows, [](const Row& row) { return !row.ok; });
    fmt::print("{} rows, {} not as expected\n", rows.size(), bad);
    return rows.empty() || bad > 0 ? 1 : 0;
}

}  // namespace

}  // namespace weavefront::stability

int main(int argc, char** argv) {
    weavefront::stability::Options options;
    CLI::App app("The hard cases: largest energy error, hourglass share and outcome of each");
    app.add_flag("--reduced", options.reduced, "Only the cases of the test");
    app.add_option("--case", options.names, "Only these cases");
    app.add_option("--formulation", options.formulation, "Only this one")
        ->check(CLI::IsMember({"paper", "consistent", "both"}));
    app.add_option("--set", options.overrides,
                   "Override a value of the cases' scenes, PATH=VALUE; may be given several times");
    app.add_option("--csv", options.csv, "Write the table here, a row a case and formulation");
    app.add_option("--markdown", options.markdown, "Write the table here, a row a case");
    CLI11_PARSE(app, argc, argv);
    return weavefront::stability::print_table(options);
}
