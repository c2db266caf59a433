#include "weavefront/io/block_exchange.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace weavefront::io {
namespace {

std::vector<std::int64_t> scattered(std::int64_t total, const parallel::Communicator& comm) {
    std::vector<std::int64_t> owned;
    for (std::int64_t id = 0; id < total; ++id)
        if (static_cast<int>(id * 7919 % 101 % comm.size()) == comm.rank()) owned.push_back(id);
    return owned;
}

// Totals below, at and beyond the rank count, so that some blocks are empty.
TEST(BlockExchange, BringsEveryValueToItsPlace) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    for (const std::int64_t total : {1, 2, 3, 4, 5, 97}) {
        const auto owned = scattered(total, comm);
        const BlockExchange exchange(comm, total, owned);
        EXPECT_EQ(exchange.first(), total * comm.rank() / comm.size());
        EXPECT_EQ(exchange.first() + exchange.count(), total * (comm.rank() + 1) / comm.size());
        std::vector<double> values;
        for (const auto id : owned)
            values.insert(values.end(), {static_cast<double>(id), static_cast<double>(-id)});
        const auto block = exchange.to_block<double>(values, 2);
        ASSERT_EQ(static_cast<std::int64_t>(block.size()), 2 * exchange.count());
        for (std::size_t i = 0; i < block.size() / 2; ++i) {
            const auto id = static_cast<double>(exchange.first() + static_cast<std::int64_t>(i));
            EXPECT_EQ(block[2 * i], id);
            EXPECT_EQ(block[2 * i + 1], -id);
        }
    }
}

std::string refusal(const parallel::Communicator& comm, std::int64_t total,
                    const std::vector<std::int64_t>& owned) {
    try {
        const BlockExchange exchange(comm, total, owned);
    } catch (const std::logic_error& failure) {
        return failure.what();
    }
    return "";
}

TEST(BlockExchange, RefusesWhatIsNoPartitionOnAllRanks) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    const auto on_first = [&](std::vector<std::int64_t> ids) {
        return comm.rank() == 0 ? ids : std::vector<std::int64_t>{};
    };
    EXPECT_EQ(refusal(comm, 4, on_first({0, 1, 3})), "global id 2 has no owner");
    EXPECT_EQ(refusal(comm, 4, on_first({1, 0, 2, 3})), "owned global ids are not ascending");
    EXPECT_EQ(refusal(comm, 4, on_first({0, 1, 2, 3, 4})), "an owned global id lies outside 0..3");
    if (comm.size() > 1) {
        EXPECT_EQ(refusal(comm, 1, {0}), "global id 0 has two owners");
    }
}

}  // namespace
}  // namespace weavefront::io
