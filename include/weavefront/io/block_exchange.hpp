#pragma once
/// @file
/// From the scattered ownership of a partition to contiguous blocks of the global order, in which files are
/// written.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Blocks of the global order: of N items in whole grains, rank r of R holds those of the grains [r G / R,
/// (r + 1) G / R), G the number of grains.
struct Blocks {
    std::int64_t total = 0, grain = 1;
    int ranks = 1;

    [[nodiscard]] std::int64_t grains() const { return (total + grain - 1) / grain; }
    [[nodiscard]] std::int64_t begin(int rank) const {
        return std::min(total, grains() * rank / ranks * grain);
    }
    /// The rank whose block holds an item.
    [[nodiscard]] int rank_of(std::int64_t item) const {
        return static_cast<int>(((item / grain + 1) * ranks - 1) / grains());
    }
};

/// Items that hold different numbers of values.
struct RaggedValues {
    std::vector<std::int32_t> counts;  ///< of each item
    std::vector<double> values;        ///< item after item
};

/// Moves values from the ranks that own them to blocks of the global order. Who sends what is agreed once, at
/// construction.
class BlockExchange {
  public:
    /// @param comm   ranks among which the items are spread; must outlive this object
    /// @param total  number of items N
    /// @param owned  global ids of the items of this rank, ascending; every id in [0, N) is owned by exactly
    /// one rank
    /// @throws std::logic_error on all ranks when the ids are not such a partition
    /// @note Collective
    BlockExchange(const parallel::Communicator& comm, std::int64_t total, std::span<const std::int64_t> owned)
        : BlockExchange(comm, {total, 1, comm.size()}, owned) {}
    /// The same with blocks of whole grains.
    BlockExchange(const parallel::Communicator& comm, const Blocks& blocks,
                  std::span<const std::int64_t> owned);

    /// First global id of the block of this rank.
    [[nodiscard]] std::int64_t first() const { return first_; }
    /// Number of items in the block of this rank.
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(position_.size()); }

    /// Number of items that this rank owns.
    [[nodiscard]] std::size_t owned() const {
        return static_cast<std::size_t>(send_starts_.back()) + static_cast<std::size_t>(send_counts_.back());
    }

    /// Values of the block of this rank.
    /// @param values      `components` values for every owned item, in the order of `owned`
    /// @param components  values of an item
    /// @return `components` values for every item of the block, by ascending global id
    /// @throws std::invalid_argument when `values` has another size (on this rank)
    /// @note Collective
    template <class T>
    [[nodiscard]] std::vector<T> to_block(std::span<const T> values, int components = 1) const {
        const auto width = static_cast<std::size_t>(components);
        std::vector<T> block(position_.size() * width);
        exchange(std::as_bytes(values), std::as_writable_bytes(std::span<T>(block)), sizeof(T) * width);
        return block;
    }

    /// The same of items that hold different numbers of values. @note Collective
    [[nodiscard]] RaggedValues to_block(const RaggedValues& owned) const;

  private:
    void agree_on_counts(std::span<const std::int64_t> owned);
    void agree_on_positions(std::span<const std::int64_t> owned);
    void exchange(std::span<const std::byte> values, std::span<std::byte> block, std::size_t item) const;

    const parallel::Communicator* comm_;
    Blocks blocks_;
    std::int64_t first_;
    std::vector<int> send_counts_, send_starts_, receive_counts_,
        receive_starts_;                  // in items, one entry a rank
    std::vector<std::int64_t> position_;  // within the block, of the items in the order in which they arrive
};

}  // namespace weavefront::io
