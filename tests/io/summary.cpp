#include "weavefront/io/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {
namespace {

Summary sample() {
    return {.status = "stopped",
            .reason = "energy \"error\"",
            .versions = {{"weavefront", "1.2.3"}},
            .scene_hash = "0123456789abcdef",
            .title = "Tïtle",
            .ranks = 2,
            .elements = 3,
            .nodes = 4,
            .steps = 5,
            .time = 0.1,
            .wall_seconds = {{.name = "elements", .min = 1, .mean = 2, .max = 3}},
            .element_steps = 15,
            .nanoseconds_per_element_step = 250.5,
            .outcome = ShotOutcome{.verdict = "stopped",
                                   .decided_at = 9.5e-5,
                                   .plies_perforated = 1,
                                   .peak_back_face_deflection = 0.0139,
                                   .deepest_penetration = 2e-4,
                                   .deepest_at = {1e-3, 2e-3, 3e-3},
                                   .deepest_ply = 1,
                                   .deepest_time = 6e-5},
            .residual_velocity = -12.25,
            .projectiles = {},
            .max_displacement = 0.0141,
            .back_face_deflection = 0.0139,
            .energy_error = 1e-4,
            .broken_yarns = 7,
            .eroded_elements = 8,
            .first_break = {2.5e-5, std::nullopt},
            .left_out = {"friction"},
            .history_sha256 = "ab12",
            .results_sha256 = "cd34"};
}

TEST(Summary, HoldsEveryKey) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    write_summary(directory / "summary.json", sample(), comm);
    if (comm.rank() != 0) return;
    const auto expected = nlohmann::json::parse(R"({
        "status": "stopped", "reason": "energy \"error\"", "versions": {"weavefront": "1.2.3"}, "scene_hash": "0123456789abcdef",
        "title": "Tïtle", "ranks": 2, "elements": 3, "nodes": 4, "steps": 5, "time": 0.1,
        "wall_seconds": {"elements": {"min": 1.0, "mean": 2.0, "max": 3.0}}, "element_steps": 15,
        "nanoseconds_per_element_step": 250.5, "outcome": {"verdict": "stopped", "decided_at": 9.5e-5, "plies_perforated": 1,
        "peak_back_face_deflection": 0.0139, "deepest_penetration": 2e-4, "deepest_at": [1e-3, 2e-3, 3e-3], "deepest_ply": 1,
        "deepest_time": 6e-5}, "residual_velocity": -12.25, "max_displacement": 0.0141,
        "back_face_deflection": 0.0139, "energy_error": 1e-4, "broken_yarns": 7, "eroded_elements": 8, "first_break": [2.5e-5, null], "left_out": ["friction"],
        "history_sha256": "ab12",
        "results_sha256": "cd34"})");
    EXPECT_EQ(nlohmann::json::parse(content(directory / "summary.json")), expected);
    EXPECT_FALSE(std::filesystem::exists(directory / "summary.json.new"));
}

TEST(Summary, ListsSeveralProjectiles) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    auto summary = sample();
    summary.projectiles = {{"perforated", 1e-5, 8, 120.5}, {"still moving", std::nullopt, 0, -3}};
    write_summary(directory / "summary.json", summary, comm);
    if (comm.rank() != 0) return;
    EXPECT_EQ(nlohmann::json::parse(content(directory / "summary.json"))["projectiles"],
              nlohmann::json::parse(R"([
        {"verdict": "perforated", "decided_at": 1e-5, "plies_perforated": 8, "residual_velocity": 120.5},
        {"verdict": "still moving", "decided_at": null, "plies_perforated": 0, "residual_velocity": -3.0}])"));
}

TEST(Summary, SaysNullWithoutAProjectile) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    auto summary = sample();
    summary.residual_velocity.reset();
    summary.outcome.reset();
    write_summary(directory / "summary.json", summary, comm);
    if (comm.rank() == 0) {
        const auto json = nlohmann::json::parse(content(directory / "summary.json"));
        EXPECT_TRUE(json["residual_velocity"].is_null());
        EXPECT_TRUE(json["outcome"].is_null());
    }
}

TEST(Summary, KeepsTheOldFileRatherThanWriteWhatIsNotFinite) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    write_summary(directory / "summary.json", sample(), comm);
    const auto before = content(directory / "summary.json");
    auto summary = sample();
    summary.wall_seconds[0].mean = std::nan("");
    EXPECT_EQ(message_of<NotFinite>([&] { write_summary(directory / "summary.json", summary, comm); }),
              "summary: mean is not finite");
    if (comm.rank() == 0) {
        EXPECT_EQ(content(directory / "summary.json"), before);
    }
}

TEST(Summary, IsWrittenWhateverBytesAPathIsMadeOf) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    auto summary = sample();
    summary.reason = "Zw\xf6lf.csv cannot be written";  // Latin-1
    write_summary(directory / "summary.json", summary, comm);
    if (comm.rank() == 0) {
        EXPECT_EQ(nlohmann::json::parse(content(directory / "summary.json"))["reason"],
                  "Zw\ufffdlf.csv cannot be written");
    }
}

TEST(Summary, FailsOnAllRanksWhereItCannotBeCreated) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    const auto path = directory / "missing/summary.json";
    EXPECT_EQ(message_of<FileError>([&] { write_summary(path, sample(), comm); }),
              path.string() + " cannot be written: No such file or directory");
}

}  // namespace
}  // namespace weavefront::io
