#include "checkpoint_blocks.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::io {

namespace {

/// Names of the columns of all ranks, ascending. @note Collective
std::vector<std::string> names_of_all(const state::Table& table, const parallel::Communicator& comm) {
    std::string mine;
    for (const auto& column : table.columns) mine += column.name + '\n';
    std::vector<std::vector<char>> outgoing(static_cast<std::size_t>(comm.size()),
                                            std::vector<char>(mine.begin(), mine.end()));
    std::set<std::string> names;
    for (const auto& text : parallel::all_to_all(comm, outgoing)) {
        std::istringstream lines(std::string(text.begin(), text.end()));
        for (std::string name; std::getline(lines, name);) names.insert(name);
    }
    return {names.begin(), names.end()};
}

/// How many values each item of all ranks has; -1: they differ. @note Collective
std::int32_t values_per_item(const std::vector<std::int32_t>& counts, const parallel::Communicator& comm) {
    constexpr auto none = std::numeric_limits<std::int32_t>::max();
    const auto [least, most] = std::ranges::minmax_element(counts);
    std::array<std::int64_t, 2> extremes{none, none};  // of the counts, of the negative counts
    if (!counts.empty()) extremes = {*least, -std::int64_t{*most}};
    comm.min(extremes);
    return extremes[0] == -extremes[1] ? static_cast<std::int32_t>(extremes[0]) : -1;
}

std::vector<std::size_t> begins_of(const std::vector<std::int32_t>& counts) {
    std::vector<std::size_t> begins(counts.size() + 1, 0);
    for (std::size_t i = 0; i < counts.size(); ++i)
        begins[i + 1] = begins[i] + static_cast<std::size_t>(counts[i]);
    return begins;
}

}  // namespace

std::uint64_t checksum_of(const RaggedValues& block, const Blocks& blocks, std::int64_t first,
                          const parallel::Communicator& comm) {
    std::vector<std::int64_t> checksums(static_cast<std::size_t>(blocks.grains()), 0);
    const auto begins = begins_of(block.counts);
    for (std::size_t item = 0; item < block.counts.size();) {
        const auto end = std::min(item + static_cast<std::size_t>(items_of_grain), block.counts.size());
        const auto of_counts = XXH3_64bits(&block.counts[item], (end - item) * sizeof(std::int32_t));
        const auto of_grain = XXH3_64bits_withSeed(block.values.data() + begins[item],
                                                   (begins[end] - begins[item]) * sizeof(double), of_counts);
        const auto grain = (first + static_cast<std::int64_t>(item)) / items_of_grain;
        checksums[static_cast<std::size_t>(grain)] = std::bit_cast<std::int64_t>(of_grain);
        item = end;
    }
    comm.sum(checksums);
    return XXH3_64bits(checksums.data(), checksums.size() * sizeof(std::int64_t));
}

std::vector<ColumnBlock> column_blocks(state::Table& table, const Blocks& blocks,
                                       const parallel::Communicator& comm) {
    const BlockExchange exchange(comm, blocks, table.ids);
    std::vector<ColumnBlock> columns;
    for (const auto& name : names_of_all(table, comm)) {
        RaggedValues owned{std::vector<std::int32_t>(table.ids.size(), 0), {}};
        const auto found = std::ranges::find(table.columns, name, &state::Column::name);
        if (found != table.columns.end()) owned = {std::move(found->counts), std::move(found->values)};
        auto& column = columns.emplace_back();
        column.name = name;
        column.block = exchange.to_block(owned);
        column.per_item = values_per_item(column.block.counts, comm);
        column.checksum = checksum_of(column.block, blocks, exchange.first(), comm);
        const auto sizes = parallel::all_gather(comm, static_cast<std::int64_t>(column.block.values.size()));
        column.first_value = std::accumulate(sizes.begin(), sizes.begin() + comm.rank(), std::int64_t{0});
        column.all_values = std::accumulate(sizes.begin(), sizes.end(), std::int64_t{0});
    }
    return columns;
}

RaggedValues from_blocks(const RaggedValues& block, const Blocks& blocks, std::span<const std::int64_t> ids,
                         const parallel::Communicator& comm) {
    const auto ranks = static_cast<std::size_t>(comm.size());
    std::vector<std::vector<std::int64_t>> wanted(ranks);
    for (const auto id : ids) wanted[static_cast<std::size_t>(blocks.rank_of(id))].push_back(id);
    const auto asked = parallel::all_to_all(comm, wanted);
    const auto begins = begins_of(block.counts);
    const auto first = blocks.begin(comm.rank());
    std::vector<std::vector<std::int32_t>> counts(ranks);
    std::vector<std::vector<double>> values(ranks);
    for (std::size_t r = 0; r < ranks; ++r)
        for (const auto id : asked[r]) {
            const auto item = static_cast<std::size_t>(id - first);
            counts[r].push_back(block.counts[item]);
            values[r].insert(values[r].end(),
                             block.values.begin() + static_cast<std::ptrdiff_t>(begins[item]),
                             block.values.begin() + static_cast<std::ptrdiff_t>(begins[item + 1]));
        }
    RaggedValues result;
    for (const auto& part : parallel::all_to_all(comm, counts))
        result.counts.insert(result.counts.end(), part.begin(), part.end());
    for (const auto& part : parallel::all_to_all(comm, values))
        result.values.insert(result.values.end(), part.begin(), part.end());
    return result;
}

}  // namespace weavefront::io
