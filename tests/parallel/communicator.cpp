/// Reductions, broadcasts and messages among all ranks.

#include "weavefront/parallel/communicator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/parallel/on_root.hpp"

namespace weavefront::test {
namespace {

using parallel::Communicator;

TEST(Communicator, Reduces) {
    const Communicator comm(MPI_COMM_WORLD);
    const auto n = static_cast<std::int64_t>(comm.size());
    constexpr std::int64_t large = std::int64_t{1} << 60;  // beyond what a double holds to the unit
    std::vector<std::int64_t> sums{comm.rank() + 1, comm.rank() == 0 ? large + 1 : 0};
    comm.sum(sums);
    EXPECT_EQ(sums, (std::vector<std::int64_t>{n * (n + 1) / 2, large + 1}));
    EXPECT_EQ(comm.min(comm.rank() - 0.5), -0.5);
    EXPECT_EQ(comm.max(comm.rank() - 0.5), static_cast<double>(n) - 1.5);
    std::vector<std::int64_t> least{comm.rank(), -comm.rank()};
    comm.min(least);
    EXPECT_EQ(least, (std::vector<std::int64_t>{0, 1 - n}));
}

TEST(Communicator, AnyIsTrueOnAllRanksIfTrueOnOne) {
    const Communicator comm(MPI_COMM_WORLD);
    EXPECT_FALSE(comm.any(false));
    for (int r = 0; r < comm.size(); ++r) EXPECT_TRUE(comm.any(r == comm.rank()));
}

TEST(Communicator, BroadcastsFromRankZero) {
    const Communicator comm(MPI_COMM_WORLD);
    const std::string text("zero\0inside", 11);
    EXPECT_EQ(comm.broadcast(comm.rank() == 0 ? text : "what the others say is longer than that"), text);
    EXPECT_EQ(comm.broadcast(std::string(comm.rank() == 0 ? "" : "x")), "");
    std::vector<std::int32_t> values;
    if (comm.rank() == 0) values = {3, -1, 4};
    comm.broadcast(values);
    EXPECT_EQ(values, (std::vector<std::int32_t>{3, -1, 4}));
}

TEST(OnRoot, AFailureOnRankZeroIsThrownOnAllRanks) {
    const Communicator comm(MPI_COMM_WORLD);
    int calls = 0;
    parallel::on_root(comm, [&] { ++calls; });
    EXPECT_EQ(calls, comm.rank() == 0 ? 1 : 0);
    const auto fail = [] { throw std::invalid_argument("no such thing"); };
    EXPECT_EQ(parallel::failure_on_root(comm, fail), "no such thing");
    EXPECT_THROW(parallel::on_root(comm, fail), std::runtime_error);
}

TEST(Communicator, ReportsTheMessageOfAnMpiError) {
    EXPECT_NO_THROW(parallel::check(MPI_SUCCESS));
    EXPECT_THROW(parallel::check(MPI_ERR_RANK), std::runtime_error);
}

/// What rank `from` tells rank `to`: as many items as their ranks say, so that lengths differ and some are
/// empty.
std::vector<std::int64_t> message(int from, int to) {
    return std::vector<std::int64_t>(static_cast<std::size_t>((2 * from + 3 * to) % 4), 100 * from + to);
}

TEST(AllToAll, DeliversEachMessageToItsRank) {
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<std::vector<std::int64_t>> outgoing;
    for (int r = 0; r < comm.size(); ++r) outgoing.push_back(message(comm.rank(), r));
    const auto incoming = parallel::all_to_all(comm, outgoing);
    ASSERT_EQ(incoming.size(), outgoing.size());
    for (int r = 0; r < comm.size(); ++r)
        EXPECT_EQ(incoming[static_cast<std::size_t>(r)], message(r, comm.rank()));
}

TEST(AllGather, IsInRankOrder) {
    const Communicator comm(MPI_COMM_WORLD);
    const auto values =
        parallel::all_gather(comm, std::array<double, 2>{comm.rank() + 0.5, -1.0 * comm.rank()});
    ASSERT_EQ(values.size(), static_cast<std::size_t>(comm.size()));
    for (int r = 0; r < comm.size(); ++r)
        EXPECT_EQ(values[static_cast<std::size_t>(r)], (std::array<double, 2>{r + 0.5, -1.0 * r}));
}

}  // namespace
}  // namespace weavefront::test
