#include "weavefront/io/block_exchange.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "agreement.hpp"
#include "weavefront/parallel/all_to_all.hpp"
#include "weavefront/parallel/item_type.hpp"

namespace weavefront::io {

namespace {

using parallel::check;

std::vector<int> starts_of(const std::vector<int>& counts) {
    std::vector<int> starts(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
    return starts;
}

void require_ascending_within(std::int64_t total, std::span<const std::int64_t> owned) {
    const bool ascending =
        std::adjacent_find(owned.begin(), owned.end(), std::greater_equal<>()) == owned.end();
    if (!ascending) throw std::logic_error("owned global ids are not ascending");
    if (!owned.empty() && (owned.front() < 0 || owned.back() >= total))
        throw std::logic_error("an owned global id lies outside 0.." + std::to_string(total - 1));
}

void require_each_once(std::span<const std::int64_t> position, std::int64_t count, std::int64_t first) {
    std::vector<bool> seen(static_cast<std::size_t>(count));
    for (const auto p : position) {
        if (seen[static_cast<std::size_t>(p)])
            throw std::logic_error("global id " + std::to_string(first + p) + " has two owners");
        seen[static_cast<std::size_t>(p)] = true;
    }
    const auto missing = std::find(seen.begin(), seen.end(), false);
    if (missing != seen.end())
        throw std::logic_error("global id " + std::to_string(first + (missing - seen.begin())) +
                               " has no owner");
}

}  // namespace

BlockExchange::BlockExchange(const parallel::Communicator& comm, const Blocks& blocks,
                             std::span<const std::int64_t> owned)
    : comm_(&comm), blocks_(blocks), first_(blocks.begin(comm.rank())) {
    const auto total = blocks.total, count = blocks.begin(comm.rank() + 1) - first_;

    Agreement agreement(comm);
    agreement.attempt([&] { require_ascending_within(total, owned); });
    agreement.settle<std::logic_error>();
    agree_on_counts(owned);
    agree_on_positions(owned);
    agreement.attempt([&] { require_each_once(position_, count, first_); });
    agreement.settle<std::logic_error>();
}

void BlockExchange::agree_on_counts(std::span<const std::int64_t> owned) {
    const int ranks = comm_->size();
    send_counts_.assign(static_cast<std::size_t>(ranks), 0);
    receive_counts_.assign(static_cast<std::size_t>(ranks), 0);
    for (const auto id : owned) ++send_counts_[static_cast<std::size_t>(blocks_.rank_of(id))];
    check(MPI_Alltoall(send_counts_.data(), 1, MPI_INT, receive_counts_.data(), 1, MPI_INT, comm_->get()));
    send_starts_ = starts_of(send_counts_);
    receive_starts_ = starts_of(receive_counts_);
}

void BlockExchange::agree_on_positions(std::span<const std::int64_t> owned) {
    position_.resize(static_cast<std::size_t>(std::reduce(receive_counts_.begin(), receive_counts_.end())));
    check(MPI_Alltoallv(owned.data(), send_counts_.data(), send_starts_.data(), MPI_INT64_T, position_.data(),
                        receive_counts_.data(), receive_starts_.data(), MPI_INT64_T, comm_->get()));
    for (auto& p : position_) p -= first_;
}

void BlockExchange::exchange(std::span<const std::byte> values, std::span<std::byte> block,
                             std::size_t item) const {
    if (values.size() != owned() * item)
        throw std::invalid_argument("expected " + std::to_string(owned()) + " items of " +
                                    std::to_string(item) + " bytes, got " + std::to_string(values.size()) +
                                    " bytes");
    // Ascending ids meet ascending blocks: what goes to one rank is contiguous already.
    std::vector<std::byte> arrived(block.size());
    const parallel::ItemType type(item);
    check(MPI_Alltoallv(values.data(), send_counts_.data(), send_starts_.data(), type.get(), arrived.data(),
                        receive_counts_.data(), receive_starts_.data(), type.get(), comm_->get()));
    const auto place = [&](auto size) {
        for (std::size_t i = 0; i < position_.size(); ++i)
            std::memcpy(block.data() + static_cast<std::size_t>(position_[i]) * size,
                        arrived.data() + i * size, size);
    };
    // Sizes that are known when this is compiled are copied without a call.
    if (item == sizeof(double))
        place(std::integral_constant<std::size_t, sizeof(double)>());
    else if (item == 3 * sizeof(double))
        place(std::integral_constant<std::size_t, 3 * sizeof(double)>());
    else
        place(item);
}

RaggedValues BlockExchange::to_block(const RaggedValues& owned) const {
    RaggedValues block;
    block.counts = to_block<std::int32_t>(owned.counts);
    std::vector<std::vector<double>> outgoing(send_counts_.size());
    auto next = owned.values.begin();
    for (std::size_t r = 0, item = 0; r < send_counts_.size(); ++r) {
        std::ptrdiff_t values = 0;
        for (int i = 0; i < send_counts_[r]; ++i) values += owned.counts[item++];
        outgoing[r].assign(next, next + values);
        next += values;
    }
    std::vector<std::size_t> begins(block.counts.size() + 1, 0);
    std::inclusive_scan(block.counts.begin(), block.counts.end(), begins.begin() + 1, std::plus<>(),
                        std::size_t{0});
    block.values.resize(begins.back());
    std::size_t arrived = 0;
    const auto incoming = parallel::all_to_all(*comm_, outgoing);
    for (std::size_t r = 0; r < incoming.size(); ++r) {
        auto from = incoming[r].begin();
        for (int i = 0; i < receive_counts_[r]; ++i) {
            const auto item = static_cast<std::size_t>(position_[arrived++]);
            std::copy_n(from, block.counts[item],
                        block.values.begin() + static_cast<std::ptrdiff_t>(begins[item]));
            from += block.counts[item];
        }
    }
    return block;
}

}  // namespace weavefront::io
