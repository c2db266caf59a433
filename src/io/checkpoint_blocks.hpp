#pragma once
/// @file
/// The columns of a table in blocks of the global order, as a checkpoint holds them.

#include <cstdint>
#include <string>
#include <vector>

#include "weavefront/io/block_exchange.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/state/table.hpp"

namespace weavefront::io {

/// Items whose values share a checksum: blocks hold whole grains, so checksums do not depend on the ranks.
inline constexpr std::int64_t items_of_grain = 4096;

/// One column of all ranks, of which this rank has a block.
struct ColumnBlock {
    std::string name;
    RaggedValues block;
    std::int64_t first_value = 0, all_values = 0;  ///< before this block, of all ranks
    std::int32_t per_item = -1;  ///< how many values each item has; -1: not all have as many
    std::uint64_t checksum = 0;  ///< XXH3 of those of the grains
};

/// XXH3 of a column, from that of each grain. @param first global id of the block's first item @note
/// Collective
std::uint64_t checksum_of(const RaggedValues& block, const Blocks& blocks, std::int64_t first,
                          const parallel::Communicator& comm);

/// All columns that any rank has, by name.
/// @param table of this rank, each item on one rank; its columns are used up one after the other, for their
/// memory
/// @note Collective
std::vector<ColumnBlock> column_blocks(state::Table& table, const Blocks& blocks,
                                       const parallel::Communicator& comm);

/// Values of some items from the blocks of all ranks. @param ids global, ascending @note Collective
RaggedValues from_blocks(const RaggedValues& block, const Blocks& blocks, std::span<const std::int64_t> ids,
                         const parallel::Communicator& comm);

}  // namespace weavefront::io
