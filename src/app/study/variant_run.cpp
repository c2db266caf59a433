#include "variant_run.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "deformation_path.hpp"
#include "impact.hpp"
#include "stop.hpp"
#include "test_curves.hpp"
#include "versions.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/io/read_results.hpp"
#include "weavefront/io/sha256.hpp"
#include "weavefront/io/summary.hpp"
#include "weavefront/mesh/panel.hpp"

namespace weavefront::app {

namespace {

double element_steps(const scene::Scene& scene) {
    const double elements = static_cast<double>(mesh::make_panel(scene).elements());
    return elements * scene.time.end /
           (scene.time.safety * scene.target->mesh.center);  // steps in proportion to end over size
}

void write_curve(scene::Compute compute, const scene::Case& variant, io::OutputDirectory& folder,
                 const parallel::Communicator& comm) {
    const TestCurve curve = compute == scene::Compute::yarn ? yarn_curve(variant) : cell_curve(variant);
    folder.clear();
    curve.table.write(folder.path() / "history.csv");
    io::Summary summary;
    summary.status = "finished";
    summary.reason = "end of the path reached";
    summary.versions = library_versions();
    summary.scene_hash = variant.hash;
    summary.title = variant.scene.title;
    summary.elements = summary.nodes = 1;
    summary.steps = summary.element_steps = curve.steps;
    summary.nanoseconds_per_element_step = curve.seconds * 1e9 / static_cast<double>(curve.steps);
    summary.history_sha256 = io::sha256_of(curve.table.text());
    io::write_summary(folder.path() / "summary.json", summary, comm);
}

}  // namespace

study::Job job_of(scene::Compute compute, const scene::Case& variant) {
    if (compute == scene::Compute::yarn) return {static_cast<double>(variant.yarn.steps), 1};
    if (compute == scene::Compute::cell) return {static_cast<double>(variant.cell.refinement), 1};
    return {element_steps(variant.scene), columns_of(variant.scene)};
}

void compute_variant(scene::Compute compute, const scene::Case& variant, const std::filesystem::path& path,
                     const parallel::Communicator& comm) {
    io::OutputDirectory folder(path, comm, io::Earlier::replaced);
    if (compute != scene::Compute::impact) return write_curve(compute, variant, folder, comm);
    try {
        // Of a variant that the guard stops summary.json says so.
        const auto ending = Impact(variant.scene, folder, comm, {.terminal = io::Terminal::silent}).run();
        if (ending.kind == Ending::Kind::interrupted) throw Interrupted(ending.reason);
    } catch (const GuardStop&) {
        return;  // before its first step
    }
}

bool is_computed(scene::Compute compute, const scene::Case& variant, const std::filesystem::path& folder) {
    std::ifstream file(folder / "summary.json");
    const auto summary = nlohmann::json::parse(file, nullptr, false);
    const auto says = [](const nlohmann::json& part, const char* key, const std::string& text) {
        return part.is_object() && part.contains(key) && part[key] == text;
    };
    if (!says(summary, "scene_hash", variant.hash) || says(summary, "status", "interrupted")) return false;
    if (!summary.contains("versions") || !says(summary["versions"], "weavefront", WEAVEFRONT_VERSION))
        return false;
    // What was cut or changed since has another checksum; of results it would take too long to compute, but a
    // cut file does not open.
    const auto history = io::sha256_of_file(folder / "history.csv");
    if (history.empty() || !says(summary, "history_sha256", history)) return false;
    return compute != scene::Compute::impact || io::is_results_file(folder / "results.vtkhdf");
}

}  // namespace weavefront::app
