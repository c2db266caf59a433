#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <system_error>

#include "commands.hpp"
#include "launcher.hpp"
#include "outcome.hpp"
#include "picture.hpp"
#include "run_head.hpp"
#include "shared_text.hpp"
#include "study/measure.hpp"
#include "study/measured_values.hpp"
#include "study/study_check.hpp"
#include "study/study_entries.hpp"
#include "study/study_files.hpp"
#include "study/study_report.hpp"
#include "study/study_run.hpp"
#include "study/vocabulary.hpp"
#include "weavefront/io/output_directory.hpp"

namespace weavefront::app {

namespace {

void write_results(const scene::Study& study, const std::vector<StudyEntry>& entries,
                   const study::Columns& measured, const StudyOptions& options,
                   const std::optional<study::TextTable>& before, io::Log& log) {
    const std::vector<StudyRow> rows = measure_study(study, entries, options.output, measured);
    write_study_files(study, entries, rows, options.output);
    report_study(study, entries, rows, log);
    report_compared(study, rows, measured, log);
    if (before) check_against_table(study, options.output / "study.csv", *before, options.check, log);
}

/// @returns whether this is the rank that draws
bool compute(const StudyOptions& options) {
    const parallel::Environment environment(nullptr, nullptr);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    require_one_job(comm.size());
    const scene::Study study =
        scene::parse_study(shared_text(options.study, comm), options.study.string(), vocabulary);
    const std::vector<StudyEntry> entries = study_entries(study, shared_text(study.scene, comm));
    // Found at fault now rather than when everything has been computed.
    study::Columns measured;
    if (study.reference.kind == scene::Reference::Kind::file)
        measured =
            read_measured(study, entries, shared_text(study.reference.file, comm, scene::most_of_table));
    std::optional<study::TextTable> before;
    if (!options.check.empty()) before = table_of_before(study, entries, options.check, comm);
    const io::OutputDirectory kept(options.output, comm, io::Earlier::kept);
    io::Log log(options.output, comm);
    log.publish();
    const auto begin = std::chrono::steady_clock::now();
    for (const auto& line : run_head(comm)) log.record(line);
    log.info(fmt::format("Weavefront {}: study {}", WEAVEFRONT_VERSION, study.title));
    report_measured(study, entries, measured, log);
    run_study(study, entries, options.output, comm, log);
    if (comm.rank() == 0) write_results(study, entries, measured, options, before, log);
    log.record(run_tail(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return comm.rank() == 0;
}

}  // namespace

void study(StudyOptions options) {
    if (options.output.empty()) {
        // Studies are called study.yaml in a folder that says of what.
        std::error_code unknown;
        const std::filesystem::path whole = std::filesystem::absolute(options.study, unknown);
        options.output = std::filesystem::path("runs") /
                         (whole.stem() == "study" ? whole.parent_path().filename() : whole.stem());
    }
    if (compute(options) && !options.no_picture)
        run_at_end([folder = options.output] { draw_pictures("--study", folder); });
}

}  // namespace weavefront::app
