#include "weavefront/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {
namespace {

// More than two grains, so that several ranks hold some.
constexpr std::int64_t all_nodes = 9000, all_elements = 30;

bool is_mine(std::int64_t id, const parallel::Communicator& comm) {
    return static_cast<int>(id * 7919 % 101 % comm.size()) == comm.rank();
}

/// Each node has x; each third element has as many points as its id tells.
CheckpointContent content_of(const parallel::Communicator& comm) {
    CheckpointContent content;
    content.scene = "title: x\n";
    content.version = "1.2";
    content.all_nodes = all_nodes, content.all_elements = all_elements;
    content.values.push_back({"time", std::vector{0.25, -std::numeric_limits<double>::infinity()}});
    content.values.push_back({"steps", std::vector{std::int64_t{1} << 60}});
    content.values.push_back({"none", std::vector<double>()});
    content.values.push_back({"text", std::string("abc")});
    auto& x = content.nodes.columns.emplace_back(state::Column{"x", {}, {}});
    for (std::int64_t id = 0; id < all_nodes; ++id) {
        if (!is_mine(id, comm)) continue;
        content.nodes.ids.push_back(id);
        x.counts.push_back(1);
        x.values.push_back(0.1 * static_cast<double>(id));
    }
    for (std::int64_t id = 0; id < all_elements; ++id)
        if (is_mine(id, comm)) content.elements.ids.push_back(id);
    state::Column points{"contact.overlap", {}, {}};
    for (const auto id : content.elements.ids) {
        points.counts.push_back(id % 3 == 0 ? static_cast<std::int32_t>(id) : 0);
        points.values.insert(points.values.end(), static_cast<std::size_t>(points.counts.back()),
                             static_cast<double>(id));
    }
    // A column is on the ranks that have something for it.
    if (!points.values.empty()) content.elements.columns.push_back(std::move(points));
    return content;
}

class Checkpoints : public ::testing::Test {
  protected:
    /// The first rank removes the folder: not before all have looked.
    void TearDown() override { EXPECT_FALSE(comm_.any(false)); }

    const parallel::Communicator comm_{MPI_COMM_WORLD};
    const ScratchDirectory scratch_{comm_};
    const std::filesystem::path path_ = scratch_ / "checkpoint.h5";
};

TEST_F(Checkpoints, GiveBackWhatWasWrittenToAnyRank) {
    write_checkpoint(path_, content_of(comm_), comm_);
    const Checkpoint read(path_, comm_);
    EXPECT_EQ(read.scene(), "title: x\n");
    EXPECT_EQ(read.version(), "1.2");
    state::ValueReader values(read.values(), comm_);
    std::vector<double> time, none{1};
    std::int64_t steps = 0;
    std::string text;
    values("time", time), values("steps", steps), values("none", none), values("text", text);
    EXPECT_EQ(time, (std::vector{0.25, -std::numeric_limits<double>::infinity()}));
    EXPECT_EQ(steps, std::int64_t{1} << 60);
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(text, "abc");

    // Every rank asks for what it likes, two of them for the same.
    std::vector<std::int64_t> ids;
    for (std::int64_t id = comm_.rank() / 2; id < all_nodes; id += 7) ids.push_back(id);
    const auto nodes = read.nodes(ids);
    ASSERT_EQ(nodes.columns.size(), 1U);
    for (std::size_t i = 0; i < ids.size(); ++i)
        ASSERT_EQ(nodes.columns[0].values[i], 0.1 * static_cast<double>(ids[i]));
    const std::vector<std::int64_t> wanted{2, 3, 9, 28};
    const auto elements = read.elements(wanted);
    ASSERT_EQ(elements.columns.size(), 1U);
    EXPECT_EQ(elements.columns[0].name, "contact.overlap");
    EXPECT_EQ(elements.columns[0].counts, (std::vector<std::int32_t>{0, 3, 9, 0}));
    EXPECT_EQ(elements.columns[0].values, (std::vector<double>{3, 3, 3, 9, 9, 9, 9, 9, 9, 9, 9, 9}));
}

TEST_F(Checkpoints, KeepTheOneBefore) {
    auto earlier = content_of(comm_);
    earlier.scene = "title: earlier\n";
    write_checkpoint(path_, earlier, comm_);
    write_checkpoint(path_, content_of(comm_), comm_);
    EXPECT_EQ(Checkpoint(path_, comm_).scene(), "title: x\n");
    EXPECT_EQ(Checkpoint(previous_checkpoint(path_), comm_).scene(), "title: earlier\n");
}

TEST_F(Checkpoints, StayWhereTheNextCannotBeWritten) {
    write_checkpoint(path_, content_of(comm_), comm_);
    const auto before = content(path_);
    if (comm_.rank() == 0) std::filesystem::create_directory(scratch_ / "checkpoint.h5.new");
    EXPECT_THROW(write_checkpoint(path_, content_of(comm_), comm_), FileError);
    EXPECT_TRUE(content(path_) == before);
    EXPECT_FALSE(std::filesystem::exists(previous_checkpoint(path_)));
}

TEST_F(Checkpoints, FromWhichARunGoesOnAreTheNewestOfTheFolder) {
    const auto other = scratch_ / "other.h5";
    auto of_other = content_of(comm_);
    of_other.scene = "title: other\n";
    write_checkpoint(other, of_other, comm_);
    auto earlier = content_of(comm_);
    earlier.scene = "title: earlier\n";
    write_checkpoint(path_, earlier, comm_);
    write_checkpoint(path_, content_of(comm_), comm_);
    const auto scene = [&] { return Checkpoint(path_, comm_).scene(); };

    adopt_checkpoint(path_, path_, comm_);
    EXPECT_EQ(scene(), "title: x\n");
    EXPECT_EQ(Checkpoint(previous_checkpoint(path_), comm_).scene(), "title: earlier\n");
    adopt_checkpoint(previous_checkpoint(path_), path_, comm_);
    EXPECT_EQ(scene(), "title: earlier\n");
    EXPECT_FALSE(std::filesystem::exists(previous_checkpoint(path_)));
    adopt_checkpoint(other, path_, comm_);
    EXPECT_EQ(scene(), "title: other\n");
    EXPECT_EQ(Checkpoint(other, comm_).scene(), "title: other\n");
}

TEST_F(Checkpoints, RefuseIdsBeyondTheirItems) {
    write_checkpoint(path_, content_of(comm_), comm_);
    const Checkpoint read(path_, comm_);
    const std::vector<std::int64_t> ids{all_elements};
    EXPECT_THROW((void)read.elements(comm_.rank() == 0 ? ids : std::vector<std::int64_t>{}), FileError);
}

TEST_F(Checkpoints, OfOneRankAndOfManyAreAlike) {
    write_checkpoint(path_, content_of(comm_), comm_);
    const auto alone = parallel::Communicator(MPI_COMM_SELF);
    const auto other = scratch_ / "of_one.h5";
    if (comm_.rank() == 0) {
        write_checkpoint(other, content_of(alone), alone);
        EXPECT_TRUE(content(path_) == content(other));
    }
}

}  // namespace
}  // namespace weavefront::io
