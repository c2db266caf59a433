#pragma once
/// @file
/// Lists of facets as ranges of local indices.

#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "weavefront/mesh/adjacency_list.hpp"

namespace weavefront::contact {

/// Facets with consecutive local indices. A rank has several ranges for each of its elements, so they are
/// packed.
struct [[gnu::packed]] FacetRange {
    std::int32_t begin;
    std::uint8_t count;

    static constexpr std::uint8_t longest = std::numeric_limits<std::uint8_t>::max();
};
static_assert(sizeof(FacetRange) == 5);

/// The facets of several ranges, one after the other.
class FacetRanges {
  public:
    class Iterator {
      public:
        explicit Iterator(const FacetRange* range) : range_(range) {}
        std::int32_t operator*() const { return range_->begin + within_; }
        Iterator& operator++() {
            if (++within_ == range_->count) ++range_, within_ = 0;
            return *this;
        }
        bool operator==(const Iterator&) const = default;

      private:
        const FacetRange* range_;
        std::int32_t within_ = 0;
    };

    explicit FacetRanges(std::span<const FacetRange> ranges) : ranges_(ranges) {}

    [[nodiscard]] Iterator begin() const { return Iterator(ranges_.data()); }
    [[nodiscard]] Iterator end() const { return Iterator(ranges_.data() + ranges_.size()); }
    [[nodiscard]] bool empty() const { return ranges_.empty(); }

    /// Visits, in order, those of the first 32 facets whose bits are set in `slots`, until `visit` returns
    /// false.
    template <class Visit>
    void visit_some(std::uint32_t slots, const Visit& visit) const {
        for (const auto& range : ranges_) {
            if (slots == 0) return;
            const auto within = range.count < 32 ? slots & ((std::uint32_t{1} << range.count) - 1) : slots;
            for (auto rest = within; rest != 0; rest &= rest - 1)
                if (!visit(range.begin + std::countr_zero(rest))) return;
            slots = range.count < 32 ? slots >> range.count : 0;
        }
    }
    /// The last facet. @pre not empty
    [[nodiscard]] std::int32_t back() const { return ranges_.back().begin + ranges_.back().count - 1; }

  private:
    std::span<const FacetRange> ranges_;
};

/// Many lists of facets, built one after the other.
class FacetLists {
  public:
    /// Appends a facet to the present list.
    void add(std::int32_t facet) {
        const auto present = ranges_.open_row();
        const bool continues = !present.empty() && present.back().count < FacetRange::longest &&
                               facet == present.back().begin + present.back().count;
        if (continues)
            ++present.back().count;
        else
            ranges_.push_back({facet, 1});
    }
    /// Ends the present list and begins the next one.
    void end_list() { ranges_.end_row(); }

    void reserve(std::size_t lists) { ranges_.reserve_rows(lists); }
    void shrink_to_fit() { ranges_.shrink_to_fit(); }

    [[nodiscard]] std::size_t size() const { return ranges_.rows(); }
    [[nodiscard]] FacetRanges of(std::int32_t list) const { return FacetRanges(ranges_[list]); }

  private:
    mesh::AdjacencyList<FacetRange> ranges_;  ///< by list
};

}  // namespace weavefront::contact
