#include "weavefront/io/history.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <limits>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {
namespace {

const char* const header =
    "time,projectile_x,projectile_y,projectile_z,projectile_vx,projectile_vy,projectile_vz,contact_fx,"
    "contact_fy,contact_fz,kinetic_fabric,"
    "kinetic_projectile,internal,hourglass,contact,friction,damping,external,eroded,energy_error,broken_"
    "yarns,eroded_elements,"
    "max_displacement,time_step,back_face_deflection,penetration,penetration_x,penetration_y,penetration_ply,"
    "debris_elements,debris_mass,"
    "debris_displacement";

// Every column has a value of its own, so an exchange of two shows.
HistoryRow numbered_row() {
    return {.time = 0.1,
            .projectiles = {{{2, 3, 4}, {5, 6, 7}, {8, 9, 10}, {}}},
            .kinetic_fabric = 11,
            .kinetic_projectile = 12,
            .internal = 13,
            .hourglass = 14,
            .contact = 15,
            .friction = 16,
            .damping = 17,
            .external = 18,
            .eroded = 19,
            .energy_error = 20,
            .broken_yarns = 9007199254740993,  // not a double
            .eroded_elements = 22,
            .max_displacement = 23,
            .time_step = 24,
            .back_face_deflection = 25,
            .penetration = 26,
            .penetration_at = {27, 28},
            .penetration_ply = 29,
            .debris_elements = 30,
            .debris_mass = 31,
            .debris_displacement = 32};
}

const char* const numbered_line =
    "0.10000000000000001,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,9007199254740993,22,23,24,25,26,27,"
    "28,29,30,31,32";

TEST(History, HoldsTheColumnsInTheirOrderAtFullPrecision) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    History history(directory / "history.csv", HistoryRow(), comm);
    history.publish();
    history.write(numbered_row());
    history.write(numbered_row());
    // Read while the table is open: a row counts once it is written.
    if (comm.rank() == 0) {
        EXPECT_EQ(content(directory / "history.csv"),
                  std::string(header) + "\n" + numbered_line + "\n" + numbered_line + "\n");
        EXPECT_EQ(history.hash(), sha256_of_file(directory / "history.csv"));
    }
}

TEST(History, HasColumnsOfRotationWhereTheProjectileTurns) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    auto row = numbered_row();
    row.projectiles.front().rotation = Rotation{{33, 34, 35, 36}, {37, 38, 39}, {40, 41, 42}};
    History history(directory / "history.csv", row, comm);
    history.publish();
    history.write(row);
    if (comm.rank() == 0) {
        EXPECT_EQ(content(directory / "history.csv"),
                  std::string(header) +
                      ",projectile_qw,projectile_qx,projectile_qy,projectile_qz,projectile_wx,projectile_wy,"
                      "projectile_wz,contact_mx,contact_my,contact_mz\n" +
                      numbered_line + ",33,34,35,36,37,38,39,40,41,42\n");
    }
}

TEST(History, HasAColumnOfContactFrictionWhereAContactHasIt) {
    auto row = numbered_row();
    row.projectiles.front().rotation = Rotation{{33, 34, 35, 36}, {37, 38, 39}, {40, 41, 42}};
    row.contact_friction = 43;
    EXPECT_TRUE(history_header(row).ends_with(",contact_mz,contact_friction"));
    EXPECT_TRUE(history_line(row).ends_with(",42,43"));
}

TEST(History, EndsWithTheColumnsOfFurtherProjectiles) {
    auto row = numbered_row();
    row.contact_friction = 33;
    row.projectiles.push_back({{34, 35, 36}, {37, 38, 39}, {40, 41, 42}, {}});
    row.projectiles.push_back(
        {{43, 44, 45}, {46, 47, 48}, {49, 50, 51}, Rotation{{52, 53, 54, 55}, {56, 57, 58}, {59, 60, 61}}});
    EXPECT_EQ(history_header(row),
              std::string(header) +
                  ",contact_friction,projectile2_x,projectile2_y,projectile2_z,projectile2_vx,projectile2_vy,"
                  "projectile2_vz,contact2_fx,contact2_fy,contact2_fz,projectile3_x,projectile3_y,"
                  "projectile3_z,projectile3_vx,projectile3_vy,projectile3_vz,contact3_fx,contact3_fy,"
                  "contact3_fz,projectile3_qw,projectile3_qx,projectile3_qy,projectile3_qz,projectile3_wx,"
                  "projectile3_wy,projectile3_wz,contact3_mx,contact3_my,contact3_mz");
    EXPECT_EQ(history_line(row),
              std::string(numbered_line) +
                  ",33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,48,49,50,51,52,53,54,55,56,57,58,59,60,61");
}

TEST(History, AppearsUnderItsNameWithItsHeader) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    const auto path = directory / "history.csv";
    if (comm.rank() == 0) std::ofstream(path) << "of an earlier run";
    MPI_Barrier(comm.get());
    { const History unpublished(path, HistoryRow(), comm); }
    EXPECT_TRUE(comm.rank() != 0 || content(path) == "of an earlier run");
    History history(path, HistoryRow(), comm);
    history.publish();
    EXPECT_TRUE(comm.rank() != 0 || content(path) == std::string(header) + "\n");
    EXPECT_TRUE(comm.rank() != 0 || !std::filesystem::exists(path.string() + ".new"));
}

// The file system takes half of a row, as a full one may.
TEST(History, HoldsWholeRowsWhenTheDiskIsFull) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    History history(directory / "history.csv", HistoryRow(), comm);
    history.publish();
    const auto one_row = std::string(header) + "\n" + numbered_line + "\n";
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{one_row.size() + 20, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    history.write(numbered_row());
    EXPECT_THROW(history.write(numbered_row()), FileError);
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    if (comm.rank() == 0) {
        EXPECT_EQ(content(directory / "history.csv"), one_row);
    }
}

TEST(History, RefusesWhatIsNotFinite) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    History history(directory / "history.csv", HistoryRow(), comm);
    history.publish();
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        auto row = numbered_row();
        row.hourglass = value;
        EXPECT_NE(message_of<NotFinite>([&] { history.write(row); }).find("column hourglass"),
                  std::string::npos);
    }
    if (comm.rank() == 0) {
        EXPECT_EQ(content(directory / "history.csv"), std::string(header) + "\n");
    }
}

TEST(History, FailsOnAllRanksWhereItCannotBeCreated) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    const auto path = directory / "missing/history.csv";
    const auto message = message_of<FileError>([&] { const History history(path, HistoryRow(), comm); });
    EXPECT_EQ(message, path.string() + " cannot be written: No such file or directory");
}

TEST(History, NoticesThatItWasMoved) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const ScratchDirectory directory(comm);
    const auto path = directory / "history.csv";
    History history(path, HistoryRow(), comm);
    history.publish();
    history.require_in_place();
    if (comm.rank() == 0) std::filesystem::remove(path);
    const auto message = message_of<FileError>([&] { history.require_in_place(); });
    EXPECT_NE(message.find(path.string() + " is no longer there"), std::string::npos) << message;
}

}  // namespace
}  // namespace weavefront::io
