#include "study_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace weavefront::app {

void report_study(const scene::Study& study, std::span<const StudyEntry> entries,
                  std::span<const StudyRow> rows, io::Log& log) {
    std::size_t width = 8;
    for (const StudyEntry& entry : entries) width = std::max(width, entry.variant.name.size());
    std::string header = fmt::format("{:<{}}  {:<8}", "variant", width, "outcome");
    for (const scene::Measure& measure : study.quantities)
        header += fmt::format("  {:>{}}", measure.name, std::max<std::size_t>(measure.name.size(), 11));
    log.info(header + "   (errors; values where there is no reference)");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::string line = fmt::format("{:<{}}  {:<8}", entries[i].variant.name, width, rows[i].outcome);
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            const auto shown = rows[i].errors[q] ? rows[i].errors[q] : rows[i].values[q];
            line += fmt::format("  {:>{}}", shown ? fmt::format("{:.4g}", *shown) : "-",
                                std::max<std::size_t>(study.quantities[q].name.size(), 11));
        }
        log.info(line);
    }
}

}  // namespace weavefront::app
