/// A table: a history of a run, measured values, the study.csv of before, the deformation path of a cell.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "deformation_path.hpp"
#include "require.hpp"
#include "scratch_file.hpp"
#include "study/measured_values.hpp"
#include "weavefront/study/curve.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::fuzz {
namespace {

void read_text_table(const ScratchFile& file) {
    try {
        const auto table = study::read_table(file.path());
        for (const auto& row : table.rows) require(row.size() == table.header.size(), "rows are whole");
    } catch (const scene::InputError& refusal) {
        require_messages(refusal);
    }
}

void read_history(const ScratchFile& file) {
    try {
        const auto columns = study::read_columns(file.path());
        for (const auto& [name, values] : columns)
            require(values.size() == columns.begin()->second.size(), "columns are of one length", name);
    } catch (const std::runtime_error& refusal) {
        require(std::string_view(refusal.what()).starts_with(file.path().string() + ":"),
                "messages have a place", refusal.what());
    }
}

void read_path(const ScratchFile& file) {
    try {
        for (const auto& row : app::read_deformation_path(file.path()))
            require(row.determinant() > 0 && std::isfinite(app::kinematics(row).cos_2theta),
                    "deformations can be computed with");
    } catch (const scene::InputError& refusal) {
        require_messages(refusal);
    }
}

/// A study of 60 us that compares an outcome and a history with the table.
void read_measured(const std::string& text) {
    scene::Study study;
    study.reference = {.kind = scene::Reference::Kind::file,
                       .choices = {},
                       .settings = {},
                       .closed_form = {},
                       .file = "measured.csv"};
    using Kind = scene::Measure::Kind;
    study.quantities.resize(2);
    study.quantities[0].name = study.quantities[0].of = "residual_velocity";
    study.quantities[1].name = study.quantities[1].of = "projectile_vz";
    study.quantities[1].kind = Kind::history;
    std::vector<app::StudyEntry> entries(1);
    entries[0].input.scene.time.end = 60e-6;
    try {
        const auto columns = app::read_measured(study, entries, text);
        for (const auto& [name, values] : columns)
            for (const double value : values) require(!std::isinf(value), "measured values are finite", name);
    } catch (const scene::InputError& refusal) {
        require_messages(refusal);
    }
}

}  // namespace
}  // namespace weavefront::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace weavefront;
    const fuzz::ScratchFile file(std::as_bytes(std::span(data, size)));
    fuzz::read_text_table(file);
    fuzz::read_history(file);
    fuzz::read_path(file);
    try {
        fuzz::read_measured(scene::read_text(file.path(), scene::most_of_table));
    } catch (const scene::InputError& refusal) {
        fuzz::require_messages(refusal);
    }
    return 0;
}
