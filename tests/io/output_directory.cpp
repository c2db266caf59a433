#include "weavefront/io/output_directory.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::io {
namespace {

std::string this_host() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

class OutputDirectoryTest : public testing::Test {
  protected:
    const parallel::Communicator comm_{MPI_COMM_WORLD};
    const ScratchDirectory directory_{comm_};

    /// Writes a file on the first rank before any goes on.
    void put(const std::string& name, const std::string& text = "of before") const {
        if (comm_.rank() == 0) {
            std::filesystem::create_directories((directory_ / name).parent_path());
            std::ofstream(directory_ / name) << text;
        }
        MPI_Barrier(comm_.get());
    }
    [[nodiscard]] bool is_there(const std::string& name) const {
        return comm_.any(comm_.rank() == 0 &&
                         std::filesystem::exists(std::filesystem::symlink_status(directory_ / name)));
    }
    [[nodiscard]] std::string refusal(Earlier earlier) const {
        return message_of<scene::InputError>(
            [&] { const OutputDirectory refused(directory_ / "run", comm_, earlier); });
    }
    [[nodiscard]] std::string fault(Earlier earlier = Earlier::refused) const {
        return message_of<FileError>(
            [&] { const OutputDirectory refused(directory_ / "run", comm_, earlier); });
    }
};

TEST_F(OutputDirectoryTest, IsCreatedWithItsParentsAndGoesWhereNothingWasWritten) {
    {
        const OutputDirectory kept(directory_ / "a/run", comm_);
        EXPECT_TRUE(is_there("a/run"));
    }
    EXPECT_FALSE(is_there("a/run"));
    {
        const OutputDirectory kept(directory_ / "a/run", comm_);
        put("a/run/history.csv");
    }
    EXPECT_TRUE(is_there("a/run/history.csv"));
    EXPECT_FALSE(is_there("a/run/run.lock"));
}

TEST_F(OutputDirectoryTest, RefusesAnythingOfARunByItsName) {
    for (const char* name : {"results.vtkhdf", "history.csv", "summary.json", "run.log", "results.vtkhdf.new",
                             "history.csv.new"}) {
        put(std::string("run/") + name);
        const auto message = refusal(Earlier::refused);
        EXPECT_NE(message.find(std::string("holds a run already (") + name + "): --overwrite replaces it"),
                  std::string::npos)
            << message;
        EXPECT_TRUE(is_there(std::string("run/") + name));
        if (comm_.rank() == 0) std::filesystem::remove(directory_ / "run" / name);
        MPI_Barrier(comm_.get());
    }
    put("run/notes.txt");
    EXPECT_EQ(refusal(Earlier::refused), "");
}

TEST_F(OutputDirectoryTest, KeepsAnEarlierRunUntilItIsCleared) {
    for (const char* name :
         {"results.vtkhdf", "history.csv", "summary.json", "run.log", "results.vtkhdf.new", "notes.txt"})
        put(std::string("run/") + name);
    OutputDirectory directory(directory_ / "run", comm_, Earlier::replaced);
    for (const char* name : {"results.vtkhdf", "history.csv", "summary.json", "run.log"})
        EXPECT_TRUE(is_there(std::string("run/") + name));
    EXPECT_FALSE(is_there("run/results.vtkhdf.new")) << "of a run that was killed";
    const auto there = directory.clear();
    EXPECT_EQ(there.size(), comm_.rank() == 0 ? 4U : 0U);
    for (const char* name : {"results.vtkhdf", "history.csv", "summary.json", "run.log"})
        EXPECT_FALSE(is_there(std::string("run/") + name));
    EXPECT_TRUE(is_there("run/notes.txt"));
}

TEST_F(OutputDirectoryTest, OfAStudyKeepsItsFilesButIsNoneOfARun) {
    put("run/study.csv");
    put("run/run.log");
    put("run/study.json.new");
    EXPECT_EQ(refusal(Earlier::kept), "");
    EXPECT_TRUE(is_there("run/study.csv") && is_there("run/run.log"));
    EXPECT_FALSE(is_there("run/study.json.new"));
    put("run/history.csv");
    EXPECT_NE(refusal(Earlier::kept).find("holds a run already (history.csv)"), std::string::npos);
}

TEST_F(OutputDirectoryTest, RefusesLinksInPlaceOfFiles) {
    put("target", "precious");
    put("run/notes.txt");
    for (const char* name : {"history.csv", "results.vtkhdf.new"}) {
        if (comm_.rank() == 0)
            std::filesystem::create_symlink(directory_ / "target", directory_ / "run" / name);
        MPI_Barrier(comm_.get());
        for (const auto earlier : {Earlier::refused, Earlier::replaced, Earlier::kept})
            EXPECT_EQ(fault(earlier),
                      (directory_ / "run" / name).string() +
                          " cannot be written: it is a link, allowed is a regular file or none");
        EXPECT_TRUE(comm_.rank() != 0 || std::filesystem::remove(directory_ / "run" / name));
        MPI_Barrier(comm_.get());
    }
    EXPECT_TRUE(comm_.rank() != 0 || content(directory_ / "target") == "precious");
}

TEST_F(OutputDirectoryTest, FailsOnAllRanksBelowAFile) {
    put("file");
    const auto message = message_of<FileError>([&] { OutputDirectory(directory_ / "file/run", comm_); });
    EXPECT_EQ(message, "output directory " + (directory_ / "file/run").string() +
                           " cannot be created: Not a directory");
}

TEST_F(OutputDirectoryTest, IsKeptToOneRun) {
    const OutputDirectory kept(directory_ / "run", comm_);
    const auto expected = "run is in use by another run: process " + std::to_string(::getpid()) + " on " +
                          this_host() + " since 20";
    EXPECT_NE(comm_.broadcast(fault(Earlier::replaced)).find(comm_.broadcast(expected)), std::string::npos)
        << fault();
}

TEST_F(OutputDirectoryTest, NamesTheOtherHostOfARun) {
    put("run/run.lock", "host elsewhere\nprocess 7\nticks 8\nstarted 2026-01-02T03:04:05Z\n");
    EXPECT_NE(fault().find("run is in use by another run: process 7 on elsewhere since 2026-01-02T03:04:05Z, "
                           "which cannot be seen from"),
              std::string::npos)
        << fault();
    EXPECT_TRUE(is_there("run/run.lock"));
}

TEST_F(OutputDirectoryTest, TakesOverFromARunThatHasEnded) {
    const auto lock = [](pid_t process, const std::string& ticks) {
        return "host " + this_host() + "\nprocess " + std::to_string(process) + "\nticks " + ticks +
               "\nstarted 2026-01-02T03:04:05Z\n";
    };
    const auto child = ::fork();
    if (child == 0) {
        ::pause();
        ::_exit(0);
    }
    std::string ticks;
    std::ifstream fields("/proc/" + std::to_string(child) + "/stat");
    for (int i = 1; i <= 22; ++i) fields >> ticks;  // there is no space in the name of this program
    put("run/run.lock", lock(child, ticks));
    EXPECT_NE(fault().find("is in use by another run: process"), std::string::npos) << fault();
    ::kill(child, SIGKILL);
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT);
    // Until its parent asks how it ended, its number stands in the list of processes.
    EXPECT_EQ(fault(), "");
    ::waitpid(child, nullptr, 0);
    put("run/run.lock", lock(child, ticks));
    EXPECT_EQ(fault(), "");
    // A process with the number of the run, but not the run.
    put("run/run.lock", lock(1, "8"));
    EXPECT_EQ(fault(), "");
}

TEST_F(OutputDirectoryTest, DoesNotGuessAtALockThatSaysNothing) {
    put("run/run.lock", "");
    EXPECT_NE(fault().find("run.lock does not say by which; remove it when there is none"), std::string::npos)
        << fault();
}

}  // namespace
}  // namespace weavefront::io
