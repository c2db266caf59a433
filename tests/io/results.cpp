#include "weavefront/io/results.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scratch_directory.hpp"
#include "synthetic_model.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/read_results.hpp"

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
    const auto message =
        message_of<FileError>([&] { const Results results(model_.setup(path, frames), comm_); });
    EXPECT_NE(message.find(path.string() + " may grow to"), std::string::npos) << message;
    EXPECT_NE(message.find("with its 2000000000 frames, but only"), std::string::npos) << message;
    EXPECT_FALSE(std::filesystem::exists(path.string() + ".new"));
}

// A value that is not finite on one rank stops all of them, and the frame does not count.
TEST_F(ResultsTest, RefuseWhatIsNotFinite) {
    Results results(model_.setup(directory_ / "results.vtkhdf", 2), comm_);
    results.publish();
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
    results.publish();
    auto frame = model_.frame(0);
    frame.cell_data.pop_back();
    EXPECT_EQ(message_of<std::logic_error>([&] { results.write(frame); }),
              "the arrays of a frame are not those of the layout");
    results.write(model_.frame(0));
    EXPECT_EQ(results.frames(), 1);
}

TEST_F(ResultsTest, AppearUnderTheirNameWhenTheyArePublished) {
    const auto path = directory_ / "results.vtkhdf";
    {
        const Results unpublished(model_.setup(path, 1), comm_);
        EXPECT_TRUE(comm_.rank() != 0 || std::filesystem::exists(path.string() + ".new"));
        EXPECT_TRUE(comm_.rank() != 0 || !std::filesystem::exists(path));
    }
    EXPECT_TRUE(comm_.rank() != 0 || !std::filesystem::exists(path.string() + ".new"));
    Results results(model_.setup(path, 1), comm_);
    results.publish();
    EXPECT_TRUE(comm_.rank() != 0 || std::filesystem::exists(path));
    EXPECT_TRUE(comm_.rank() != 0 || !std::filesystem::exists(path.string() + ".new"));
}

TEST_F(ResultsTest, TakeTheRoomOfWhatWasWritten) {
    const auto size = [&](int room, int frames) {
        const auto path = directory_ / std::to_string(room);
        Results results(model_.setup(path, room), comm_);
        results.publish();
        for (int k = 0; k < frames; ++k) results.write(model_.frame(k));
        results.cut();
        EXPECT_EQ(results.frames(), frames);
        return comm_.rank() == 0 ? std::filesystem::file_size(path) : 0;
    };
    const auto exact = size(7, 7);
    EXPECT_EQ(size(1000, 7), exact);  // too much
    EXPECT_EQ(size(1, 7), exact);     // too little
}

TEST_F(ResultsTest, GoOnAfterTheirFirstFrames) {
    const auto path = directory_ / "results.vtkhdf";
    const auto frames = [&] { return ResultsReader(path).times(); };
    const auto time = [&](int k) { return model_.frame(k).time; };
    {
        Results results(model_.setup(path, 3), comm_);
        results.publish();
        for (int k = 0; k < 3; ++k) results.write(model_.frame(k));
    }
    EXPECT_EQ(
        message_of<FileError>([&] { const Results more(model_.setup(path, 3), 4, comm_); }),
        path.string() + " cannot be continued: it holds 3 frames, 4 were written before the checkpoint");
    Results results(model_.setup(path, 3), 1, comm_);
    EXPECT_EQ(frames(), (std::vector{time(0), time(1), time(2)}));  // until the run is certain to start
    EXPECT_FALSE(comm_.any(false));
    results.publish();
    EXPECT_EQ(frames(), std::vector{time(0)});
    EXPECT_FALSE(comm_.any(false));
    results.write(model_.frame(5));
    EXPECT_EQ(results.frames(), 2);
    EXPECT_EQ(frames(), (std::vector{time(0), time(5)}));
    EXPECT_FALSE(comm_.any(false));
}

TEST_F(ResultsTest, NoticeThatTheyWereMoved) {
    const auto path = directory_ / "results.vtkhdf";
    Results results(model_.setup(path, 3), comm_);
    results.publish();
    results.write(model_.frame(0));
    if (comm_.rank() == 0) std::filesystem::rename(path, directory_ / "elsewhere");
    const auto message = message_of<FileError>([&] { results.write(model_.frame(1)); });
    EXPECT_NE(message.find(path.string() + " is no longer there"), std::string::npos) << message;
    EXPECT_EQ(results.frames(), 1);
}

}  // namespace
}  // namespace weavefront::io
