#pragma once
/// @file
/// Fields that few packs need.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "weavefront/shell/aligned_vector.hpp"
#include "weavefront/simd/pack.hpp"

namespace weavefront::shell {

/// Some fields of those packs in which any lane differs from the idle value; the others take no room.
class PackBlocks {
  public:
    /// @param fields of a pack; without any nothing is stored and nothing may be asked for
    PackBlocks(std::int32_t packs, int fields, double idle)
        : block_(static_cast<std::size_t>(fields) * simd::pack_width),
          idle_(idle),
          slots_(static_cast<std::size_t>(fields > 0 ? packs : 0), -1) {}

    /// Field after field of a pack, 64-byte aligned; null: all idle.
    [[nodiscard]] const double* find(std::int32_t pack) const {
        const auto slot = slots_[static_cast<std::size_t>(pack)];
        return slot < 0 ? nullptr : blocks_.data() + static_cast<std::size_t>(slot) * block_;
    }

    /// The same, to be written to: a pack that has none gets one.
    double* take(std::int32_t pack) {
        auto& slot = slots_[static_cast<std::size_t>(pack)];
        if (slot < 0) {
            if (free_.empty()) {
                free_.push_back(static_cast<std::int32_t>(blocks_.size() / block_));
                blocks_.resize(blocks_.size() + block_);
            }
            slot = free_.back();
            free_.pop_back();
            std::fill_n(
                blocks_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(slot) * block_),
                block_, idle_);
        }
        return blocks_.data() + static_cast<std::size_t>(slot) * block_;
    }

    /// Makes a pack idle.
    void give_back(std::int32_t pack) {
        auto& slot = slots_[static_cast<std::size_t>(pack)];
        if (slot < 0) return;
        free_.push_back(slot);
        slot = -1;
    }

    /// Whether any pack has a block.
    [[nodiscard]] bool any() const { return blocks_.size() > free_.size() * block_; }

    [[nodiscard]] int fields() const { return static_cast<int>(block_) / simd::pack_width; }
    [[nodiscard]] double get(std::int32_t pack, int field, int lane) const {
        const double* block = find(pack);
        return block ? block[field * simd::pack_width + lane] : idle_;
    }
    void set(std::int32_t pack, int field, int lane, double value) {
        if (find(pack) || value != idle_) take(pack)[field * simd::pack_width + lane] = value;
    }
    [[nodiscard]] std::size_t bytes() const {
        return blocks_.size() * sizeof(double) + slots_.size() * sizeof(std::int32_t);
    }

  private:
    std::size_t block_;  ///< doubles
    double idle_;
    std::vector<std::int32_t> slots_;  ///< by pack, or -1
    std::vector<std::int32_t> free_;   ///< slots
    AlignedVector<double> blocks_;
};

}  // namespace weavefront::shell
