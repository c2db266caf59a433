#pragma once
/// @file
/// Where the elements of a part stand among its groups.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weavefront::solver {

/// Where an element stands among the groups.
struct ElementSlot {
    std::int32_t group = 0, index = 0;
};

/// The places of elements; those of a ply follow one another.
class ElementSlots {
  public:
    /// Appends consecutive elements that stand one after the other from `first` on.
    void append(std::int32_t elements, const ElementSlot& first) {
        runs_.push_back({size_, first});
        size_ += static_cast<std::size_t>(elements);
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] ElementSlot operator[](std::size_t element) const {
        const auto run = std::ranges::upper_bound(runs_, element, {}, &Run::first) - 1;
        return {run->slot.group, run->slot.index + static_cast<std::int32_t>(element - run->first)};
    }

  private:
    struct Run {
        std::size_t first;  ///< element
        ElementSlot slot;
    };
    std::vector<Run> runs_;
    std::size_t size_ = 0;
};

}  // namespace weavefront::solver
