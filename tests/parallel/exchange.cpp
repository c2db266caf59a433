/// Exchange of node values along neighbours.

#include "weavefront/parallel/exchange.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <chrono>
#include <csignal>
#include <numeric>
#include <thread>

namespace weavefront::test {
namespace {

using parallel::Communicator;
using parallel::Exchange;
using parallel::Neighbour;
using parallel::SendList;
using Triple = std::array<std::int64_t, 3>;

/// Ranks in a row, each with nodes 0..3. Its nodes 2, 3 are the nodes 0, 1 of the next rank, listed back to
/// front to show that the order of a neighbour, not of the indices, pairs them.
std::vector<Neighbour> row(const Communicator& comm) {
    std::vector<Neighbour> neighbours;
    if (comm.rank() > 0) neighbours.push_back({comm.rank() - 1, {1, 0}});
    if (comm.rank() + 1 < comm.size()) neighbours.push_back({comm.rank() + 1, {3, 2}});
    return neighbours;
}

Triple value(int rank, int node) { return {10 * rank + node, -rank, 1}; }

TEST(Exchange, AddsTheValuesOfOtherRanksFromBeforeTheCall) {
    const Communicator comm(MPI_COMM_WORLD);
    Exchange<Triple> exchange(row(comm));
    for (int repeat = 0; repeat < 3; ++repeat) {
        std::vector<Triple> values;
        for (int node = 0; node < 4; ++node) values.push_back(value(comm.rank(), node));
        exchange.sum(comm, values);
        for (int node = 0; node < 4; ++node) {
            const int other = node < 2 ? comm.rank() - 1 : comm.rank() + 1,
                      there = node < 2 ? node + 2 : node - 2;
            auto expected = value(comm.rank(), node);
            if (other >= 0 && other < comm.size())
                for (std::size_t i = 0; i < 3; ++i) expected[i] += value(other, there)[i];
            EXPECT_EQ(values[static_cast<std::size_t>(node)], expected);
        }
    }
}

TEST(Exchange, ANodeHeldByAllRanksEndsUpWithTheSumOfAll) {
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<Neighbour> neighbours;
    for (int r = 0; r < comm.size(); ++r)
        if (r != comm.rank()) neighbours.push_back({r, {0}});
    Exchange<Triple> exchange(std::move(neighbours));
    std::vector<Triple> values{{std::int64_t{1} << comm.rank(), 1, 0}};
    exchange.sum(comm, values);
    EXPECT_EQ(values[0], (Triple{(std::int64_t{1} << comm.size()) - 1, comm.size(), 0}));
}

TEST(Exchange, LeavesValuesFreeBetweenItsHalves) {
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<Neighbour> neighbours;
    for (int r = 0; r < comm.size(); ++r)
        if (r != comm.rank()) neighbours.push_back({r, {0}});
    Exchange<Triple> exchange(std::move(neighbours));
    std::vector<Triple> values{{1, comm.rank(), 0}};
    exchange.start(comm, values);
    values[0] = {1000, 0, 0};
    exchange.finish(values);
    EXPECT_EQ(values[0],
              (Triple{1000 + comm.size() - 1, comm.size() * (comm.size() - 1) / 2 - comm.rank(), 0}));
}

/// All with all, rank r with rank s over (r + s) `size` + 1 nodes, which only these two hold.
std::vector<Neighbour> all_with_all(const Communicator& comm, std::int32_t size) {
    std::vector<Neighbour> neighbours;
    std::int32_t node = 0;
    for (int r = 0; r < comm.size(); ++r) {
        if (r == comm.rank()) continue;
        std::vector<std::int32_t> nodes(
            static_cast<std::size_t>(size) * static_cast<std::size_t>(r + comm.rank()) + 1);
        std::iota(nodes.begin(), nodes.end(), node);
        node = nodes.back() + 1;
        neighbours.emplace_back(r, nodes);
    }
    return neighbours;
}

/// All with all over nodes 0 to 11 of each, which are the same for all. Rank r holds those from 3 r on, three
/// of its own; it sends what it has of the others where it is not zero.
std::vector<Neighbour> with_ghosts(const Communicator& comm) {
    const auto sent_by = [](int rank) {
        SendList list;
        for (std::int32_t n = 0; n < 12; ++n) list.nodes.push_back((n + 3 * rank) % 12);
        list.dense_count = 3;
        return list;
    };
    std::vector<Neighbour> neighbours;
    for (int r = 0; r < comm.size(); ++r)
        if (r != comm.rank()) neighbours.emplace_back(r, sent_by(comm.rank()), sent_by(r));
    return neighbours;
}

TEST(Exchange, SumsSparseValues) {
    const Communicator comm(MPI_COMM_WORLD);
    parallel::SharedMemoryExchange shared_memory(comm);
    Exchange<Triple> by_messages(with_ghosts(comm)), in_memory(with_ghosts(comm));
    in_memory.use(comm, shared_memory);
    // What rank r has of node n in a turn: nothing, something in one component, or in all.
    const auto value = [](int rank, int node, int turn) {
        const int kind = (rank + node + turn) % 4;
        return kind == 0   ? Triple{}
               : kind == 1 ? Triple{0, 0, -turn - 1}
               : kind == 2 ? Triple{rank - 7, 0, 0}
                           : Triple{turn, node, 1 << rank};
    };
    for (int turn = 0; turn < 12; ++turn) {
        std::vector<Triple> values, expected(12);
        for (int node = 0; node < 12; ++node) {
            values.push_back(value(comm.rank(), node, turn));
            for (int r = 0; r < comm.size(); ++r)
                for (std::size_t i = 0; i < 3; ++i)
                    expected[static_cast<std::size_t>(node)][i] += value(r, node, turn)[i];
        }
        auto same = values;
        by_messages.sum(comm, values);
        in_memory.sum(comm, same);
        EXPECT_EQ(values, expected) << turn;
        EXPECT_EQ(same, expected) << turn;
    }
}

// Small and large, so that room is made anew and used again; many turns, with ranks that come late.
TEST(Exchange, SumsAreTheSameThroughSharedMemoryAndMessages) {
    const Communicator comm(MPI_COMM_WORLD);
    parallel::SharedMemoryExchange shared_memory(comm);
    for (const std::int32_t size : {1, 1000, 3, 2000}) {
        const auto neighbours = all_with_all(comm, size);
        Exchange<Triple> by_messages(neighbours), in_memory(neighbours);
        in_memory.use(comm, shared_memory);
        const std::size_t nodes =
            neighbours.empty() ? 1 : static_cast<std::size_t>(neighbours.back().out.nodes.back()) + 1;
        const auto values = [&](int turn) {
            std::vector<Triple> all;
            for (std::size_t n = 0; n < nodes; ++n)
                all.push_back({static_cast<std::int64_t>(n) + 1000 * turn, comm.rank(), turn * turn});
            return all;
        };
        constexpr int turns = 20;
        std::vector<std::vector<Triple>> sums;
        for (int turn = 0; turn < turns; ++turn) {
            auto& sum = sums.emplace_back(values(turn));
            in_memory.start(comm, sum);
            // This rank's messages are there and so may be those of the next turn before it has read any.
            if (turn % comm.size() == comm.rank()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            in_memory.finish(sum);
        }
        for (int turn = 0; turn < turns; ++turn) {
            auto expected = values(turn);
            by_messages.sum(comm, expected);
            EXPECT_TRUE(sums[static_cast<std::size_t>(turn)] == expected) << size << ' ' << turn;
        }
    }
}

// The last rank cannot have its memory: all send messages, which say the same.
TEST(Exchange, FallsBackToMessagesWithoutSharedMemory) {
    const Communicator comm(MPI_COMM_WORLD);
    parallel::SharedMemoryExchange shared_memory(comm);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{comm.rank() == comm.size() - 1 ? 64 : before.rlim_cur, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Exchange<Triple> exchange(with_ghosts(comm)), by_messages(with_ghosts(comm));
    exchange.use(comm, shared_memory);
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(shared_memory.is_refused(), comm.size() > 1);
    for (int r = 0; r < comm.size(); ++r) EXPECT_FALSE(shared_memory.on_this_host(r));
    for (int turn = 0; turn < 3; ++turn) {
        std::vector<Triple> values;
        for (int node = 0; node < 12; ++node) values.push_back({node, comm.rank(), turn});
        auto expected = values;
        by_messages.sum(comm, expected);
        exchange.sum(comm, values);
        EXPECT_EQ(values, expected);
    }
}

TEST(SharedMemoryExchange, ReachTheOtherRanksOfTheHost) {
    const Communicator comm(MPI_COMM_WORLD);
    const parallel::SharedMemoryExchange shared_memory(comm);
    for (int r = 0; r < comm.size(); ++r) EXPECT_EQ(shared_memory.on_this_host(r), r != comm.rank());
}

}  // namespace
}  // namespace weavefront::test
