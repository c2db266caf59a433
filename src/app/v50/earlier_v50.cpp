#include "earlier_v50.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "shared_text.hpp"
#include "shot_table.hpp"
#include "weavefront/io/output_directory.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {

namespace {

bool holds_v50(const std::filesystem::path& table, const parallel::Communicator& comm) {
    bool is_there = false;
    parallel::on_root(comm, [&] { is_there = std::filesystem::exists(table); });
    return comm.any(is_there);
}

/// Names of the folders of an earlier table; only those that this program gives.
std::vector<std::string> folders_in(const std::string& text, const std::string& name) {
    const auto table = study::parse_table(text, name);
    std::vector<std::string> folders;
    for (const auto& row : table.rows)
        for (const auto& cell : row)
            if (cell.starts_with("shot_") && cell.find('/') == cell.npos) folders.push_back(cell);
    return folders;
}

void remove_earlier(const std::filesystem::path& folder, const parallel::Communicator& comm) {
    const auto table = folder / "v50.csv";
    for (const auto& name : folders_in(shared_text(table, comm, scene::most_of_table), table.string())) {
        bool is_there = false;
        parallel::on_root(comm, [&] { is_there = std::filesystem::is_directory(folder / name); });
        if (!comm.any(is_there)) continue;
        io::OutputDirectory(folder / name, comm, io::Earlier::replaced).clear();
        parallel::on_root(comm, [&] {
            std::error_code other_files;  // the folder stays
            std::filesystem::remove(folder / name, other_files);
        });
    }
    parallel::on_root(comm, [&] {
        std::filesystem::remove(folder / "v50.json");
        std::filesystem::remove(table);
    });
}

/// Shots of another scene would be mixed with those to come.
void require_same_scene(const V50Plan& plan, const std::filesystem::path& folder,
                        const parallel::Communicator& comm) {
    const auto table = folder / "v50.csv";
    std::string difference;
    for (const auto& row :
         planned_shots(plan, shared_text(table, comm, scene::most_of_table), table.string())) {
        const auto hash = plan.scene_of(row.variant, row.number, row.speed).hash;
        if (comm.rank() != 0) continue;
        std::ifstream file(folder / row.folder / "summary.json");
        const auto summary = nlohmann::json::parse(file, nullptr, false);
        if (difference.empty() && summary.is_object() && summary.value("scene_hash", hash) != hash)
            difference = fmt::format(
                "--restart: found {} of another scene or other options, allowed the command that was "
                "interrupted: --overwrite begins anew",
                (folder / row.folder).string());
    }
    difference = comm.broadcast(difference);
    if (!difference.empty()) throw scene::InputError({difference});
}

}  // namespace

void settle_earlier_v50(const V50Options& options, const V50Plan& plan, const parallel::Communicator& comm) {
    const bool is_there = holds_v50(options.output / "v50.csv", comm);
    const auto folder = options.output.string();
    if (!options.restart.empty()) {
        if (!is_there) throw scene::InputError({folder + " holds no v50 that could go on"});
        return require_same_scene(plan, options.output, comm);
    }
    if (!is_there) return;
    if (!options.overwrite)
        throw scene::InputError({folder +
                                 " holds a v50 already: --restart auto goes on with it, --overwrite replaces "
                                 "it, --output names another folder"});
    remove_earlier(options.output, comm);
}

}  // namespace weavefront::app
