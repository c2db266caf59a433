#pragma once
/// @file
/// State of few facets among many.

#include <cstdint>
#include <utility>
#include <vector>

namespace weavefront::contact {

/// A `Memory` for each facet that has one. Each other facet takes four bytes.
template <class Memory>
class FacetMemory {
  public:
    explicit FacetMemory(std::int32_t facets) : slots_(static_cast<std::size_t>(facets), -1) {}

    /// Memory of a facet; null: none.
    [[nodiscard]] Memory* find(std::int32_t facet) {
        return slot(facet) < 0 ? nullptr : &memories_[static_cast<std::size_t>(slot(facet))];
    }
    [[nodiscard]] const Memory* find(std::int32_t facet) const {
        return slot(facet) < 0 ? nullptr : &memories_[static_cast<std::size_t>(slot(facet))];
    }

    /// Memory of a facet; a new one where it has none.
    [[nodiscard]] Memory& take(std::int32_t facet) {
        if (slot(facet) < 0) {
            if (free_.empty()) {
                free_.push_back(static_cast<std::int32_t>(memories_.size()));
                memories_.emplace_back();
            }
            slots_[static_cast<std::size_t>(facet)] = free_.back();
            free_.pop_back();
        }
        return memories_[static_cast<std::size_t>(slot(facet))];
    }

    /// Drops the memory of a facet, if it has one.
    void forget(std::int32_t facet) {
        if (slot(facet) < 0) return;
        memories_[static_cast<std::size_t>(slot(facet))] = {};
        free_.push_back(std::exchange(slots_[static_cast<std::size_t>(facet)], -1));
    }

  private:
    [[nodiscard]] std::int32_t slot(std::int32_t facet) const {
        return slots_[static_cast<std::size_t>(facet)];
    }

    std::vector<std::int32_t> slots_;  ///< by facet; -1: no memory
    std::vector<Memory> memories_;
    std::vector<std::int32_t> free_;  ///< slots without a facet
};

}  // namespace weavefront::contact
