#pragma once
/// @file
/// From the scattered ownership of a partition to contiguous blocks of the global order, in which files are
/// written.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Moves values from the ranks that own them to blocks of the global order: of N items, rank r of R holds [r
/// N / R, (r + 1) N / R). Who sends what is agreed once, at construction.
class BlockExchange {
  public:
    /// @param comm   ranks among which the items are spread; must outlive this object
    /// @param total  number of items N
    /// @param owned  global ids of the items of this rank, ascending; every id in [0, N) is owned by exactly
    /// one rank
    /// @throws std::logic_error on all ranks when the ids are not such a partition
    /// @note Collective
    BlockExchange(const parallel::Communicator& comm, std::int64_t total,
                  std::span<const std::int64_t> owned);

    /// First global id of the block of this rank.
    [[nodiscard]] std::int64_t first() const { return first_; }
    /// Number of items in the block of this rank.
    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(position_.size()); }

    /// Number of items that this rank owns.
    [[nodiscard]] std::size_t owned() const {
        return static_cast<std::size_t>(send_starts_.back() + send_counts_.back());
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

  private:
    void agree_on_counts(std::span<const std::int64_t> owned);
    void agree_on_positions(std::span<const std::int64_t> owned);
    void exchange(std::span<const std::byte> values, std::span<std::byte> block, std::size_t item) const;

    const parallel::Communicator* comm_;
    std::int64_t total_;
    std::int64_t first_;
    std::vector<int> send_counts_, send_starts_, receive_counts_,
        receive_starts_;                  // in items, one entry a rank
    std::vector<std::int64_t> position_;  // within the block, of the items in the order in which they arrive
};

}  // namespace weavefront::io
