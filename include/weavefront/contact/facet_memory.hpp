#pragma once
/// @file
/// What few of many facets remember.

#include <cstdint>
#include <utility>
#include <vector>

namespace weavefront::contact {

/// A `Memory` of each facet that has one; the others take hardly any room.
template <class Memory>
class FacetMemory {
  public:
    explicit FacetMemory(std::int32_t facets) : places_(static_cast<std::size_t>(facets), -1) {}

    /// That of a facet; null: none.
    [[nodiscard]] Memory* find(std::int32_t facet) {
        return place(facet) < 0 ? nullptr : &memories_[static_cast<std::size_t>(place(facet))];
    }
    [[nodiscard]] const Memory* find(std::int32_t facet) const {
        return place(facet) < 0 ? nullptr : &memories_[static_cast<std::size_t>(place(facet))];
    }

    /// That of a facet; a fresh one where it has none.
    [[nodiscard]] Memory& take(std::int32_t facet) {
        if (place(facet) < 0) {
            if (free_.empty()) {
                free_.push_back(static_cast<std::int32_t>(memories_.size()));
                memories_.emplace_back();
            }
            places_[static_cast<std::size_t>(facet)] = free_.back();
            free_.pop_back();
        }
        return memories_[static_cast<std::size_t>(place(facet))];
    }

    void forget(std::int32_t facet) {
        if (place(facet) < 0) return;
        memories_[static_cast<std::size_t>(place(facet))] = {};
        free_.push_back(std::exchange(places_[static_cast<std::size_t>(facet)], -1));
    }

  private:
    [[nodiscard]] std::int32_t place(std::int32_t facet) const { return places_[static_cast<std::size_t>(facet)]; }

    std::vector<std::int32_t> places_;  ///< of each facet, or -1
    std::vector<Memory> memories_;
    std::vector<std::int32_t> free_;  ///< places
};

}  // namespace weavefront::contact
