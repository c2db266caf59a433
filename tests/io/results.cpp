#include "weavefront/io/results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scratch_directory.hpp"
#include "synthetic_model.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/output_directory.hpp"

namespace weavefront::io {
namespace {

class ResultsTest : public testing::Test {
  protected:
    const parallel::Communicator comm_{MPI_COMM_WORLD};
    const ScratchDirectory directory_{comm_};
    const SyntheticModel model_{.projectile = true, .rank = comm_.rank(), .ranks = comm_.size()};
};

TEST_F(ResultsTest, FailOnAllRanksWhereTheyCannotBeCreated) {
    const auto path = directory_ / "missing/results.vtkhdf";
    const auto message = message_of<FileError>([&] { const Results results(model_.setup(path, 1), comm_); });
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

TEST_F(ResultsTest, FailBeforeAnythingIsWrittenWhereTheDiskCannotHoldThem) {
    constexpr int frames = 2'000'000'000;
    const auto path = directory_ / "results.vtkhdf";
    const auto message = message_of<FileError>([&] { const Results results(model_.setup(path, frames), comm_); });
    EXPECT_NE(message.find(path.string() + " may grow to"), std::string::npos) << message;
    EXPECT_NE(message.find("with its 2000000000 frames, but only"), std::string::npos) << message;
    EXPECT_FALSE(std::filesystem::exists(path.string() + ".new"));
}

// A value that is not finite on one rank stops all of them, and the frame does not count.
TEST_F(ResultsTest, RefuseWhatIsNotFinite) {
    Results results(model_.setup(directory_ / "results.vtkhdf", 2), comm_);
    auto frame = model_.frame(0);
    if (model_.owns(0)) frame.point_data[1].values[0] = std::nan("");
    const auto message = message_of<NotFinite>([&] { results.write(frame); });
    EXPECT_NE(message.find("velocity would get a value that is not a number"), std::string::npos) << message;
    EXPECT_EQ(results.frames(), 0);
    results.write(model_.frame(0));
    EXPECT_EQ(results.frames(), 1);
}

TEST_F(ResultsTest, RefuseOtherArraysThanTheirLayout) {
    Results results(model_.setup(directory_ / "results.vtkhdf", 1), comm_);
    auto frame = model_.frame(0);
    frame.cell_data.pop_back();
    EXPECT_EQ(message_of<std::logic_error>([&] { results.write(frame); }), "the arrays of a frame are not those of the layout");
    results.write(model_.frame(0));
    EXPECT_NE(message_of<std::logic_error>([&] { results.write(model_.frame(0)); }).find("no room for more than 1 frames"),
              std::string::npos);
}

TEST_F(ResultsTest, OutputDirectoryIsCreatedWithItsParents) {
    for (int run = 0; run < 2; ++run) {
        const OutputDirectory kept(directory_ / "a/b", comm_);
        if (comm_.rank() == 0) std::ofstream(directory_ / "a/b/summary.json") << "{}";
        const auto message = message_of<FileError>([&] { OutputDirectory(directory_ / "a/b", comm_); });
        EXPECT_NE(message.find("a/b is in use by another run"), std::string::npos) << message;
        EXPECT_TRUE(comm_.rank() != 0 || std::filesystem::exists(directory_ / "a/b/summary.json"));
    }
    {
        const OutputDirectory kept(directory_ / "a/b", comm_);
        EXPECT_TRUE(comm_.rank() != 0 || !std::filesystem::exists(directory_ / "a/b/summary.json")) << "of the run before";
    }
    if (comm_.rank() == 0) {
        EXPECT_TRUE(std::filesystem::is_directory(directory_ / "a/b"));
    }
}

TEST_F(ResultsTest, OutputDirectoryFailsOnAllRanksBelowAFile) {
    if (comm_.rank() == 0) std::ofstream(directory_ / "file") << "text";
    const auto message = message_of<FileError>([&] { OutputDirectory(directory_ / "file/run", comm_); });
    EXPECT_EQ(message, "output directory " + (directory_ / "file/run").string() + " cannot be created: Not a directory");
}

}  // namespace
}  // namespace weavefront::io
