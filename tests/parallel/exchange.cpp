/// Exchange of node values along links.

#include "weavefront/parallel/exchange.hpp"

#include <gtest/gtest.h>

#include <array>

namespace weavefront::test {
namespace {

using parallel::Communicator;
using parallel::Exchange;
using parallel::Link;
using Triple = std::array<std::int64_t, 3>;

/// Ranks in a row, each with nodes 0..3. Its nodes 2, 3 are the nodes 0, 1 of the next rank, listed back to front to show that the order
/// of a link, not of the indices, pairs them.
std::vector<Link> row(const Communicator& comm) {
    std::vector<Link> links;
    if (comm.rank() > 0) links.push_back({comm.rank() - 1, {1, 0}});
    if (comm.rank() + 1 < comm.size()) links.push_back({comm.rank() + 1, {3, 2}});
    return links;
}

Triple value(int rank, int node) { return {10 * rank + node, -rank, 1}; }

TEST(Exchange, SumsWhatTheOthersHeldBefore) {
    const Communicator comm(MPI_COMM_WORLD);
    Exchange<Triple> exchange(row(comm));
    for (int repeat = 0; repeat < 3; ++repeat) {
        std::vector<Triple> values;
        for (int node = 0; node < 4; ++node) values.push_back(value(comm.rank(), node));
        exchange.sum(comm, values);
        for (int node = 0; node < 4; ++node) {
            const int other = node < 2 ? comm.rank() - 1 : comm.rank() + 1, there = node < 2 ? node + 2 : node - 2;
            auto expected = value(comm.rank(), node);
            if (other >= 0 && other < comm.size())
                for (std::size_t i = 0; i < 3; ++i) expected[i] += value(other, there)[i];
            EXPECT_EQ(values[static_cast<std::size_t>(node)], expected);
        }
    }
}

TEST(Exchange, ANodeHeldByAllRanksEndsUpWithTheSumOfAll) {
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<Link> links;
    for (int r = 0; r < comm.size(); ++r)
        if (r != comm.rank()) links.push_back({r, {0}});
    Exchange<Triple> exchange(std::move(links));
    std::vector<Triple> values{{std::int64_t{1} << comm.rank(), 1, 0}};
    exchange.sum(comm, values);
    EXPECT_EQ(values[0], (Triple{(std::int64_t{1} << comm.size()) - 1, comm.size(), 0}));
}

TEST(Exchange, LeavesValuesFreeBetweenItsHalves) {
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<Link> links;
    for (int r = 0; r < comm.size(); ++r)
        if (r != comm.rank()) links.push_back({r, {0}});
    Exchange<Triple> exchange(std::move(links));
    std::vector<Triple> values{{1, comm.rank(), 0}};
    exchange.start(comm, values);
    values[0] = {1000, 0, 0};
    exchange.finish(values);
    EXPECT_EQ(values[0], (Triple{1000 + comm.size() - 1, comm.size() * (comm.size() - 1) / 2 - comm.rank(), 0}));
}

}  // namespace
}  // namespace weavefront::test
