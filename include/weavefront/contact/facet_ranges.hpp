#pragma once
/// @file
/// Lists of facets that take little room.

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace weavefront::contact {

/// Facets with consecutive local indices. There are several for every element of a rank, so they are packed.
struct [[gnu::packed]] FacetRange {
    std::int32_t begin;
    std::uint8_t count;

    static constexpr std::uint8_t longest = std::numeric_limits<std::uint8_t>::max();
};
static_assert(sizeof(FacetRange) == 5);

/// The facets of some runs, one after the other.
class FacetRanges {
  public:
    class Iterator {
      public:
        explicit Iterator(const FacetRange* run) : run_(run) {}
        std::int32_t operator*() const { return run_->begin + within_; }
        Iterator& operator++() {
            if (++within_ == run_->count) ++run_, within_ = 0;
            return *this;
        }
        bool operator==(const Iterator&) const = default;

      private:
        const FacetRange* run_;
        std::int32_t within_ = 0;
    };

    explicit FacetRanges(std::span<const FacetRange> runs) : runs_(runs) {}

    [[nodiscard]] Iterator begin() const { return Iterator(runs_.data()); }
    [[nodiscard]] Iterator end() const { return Iterator(runs_.data() + runs_.size()); }
    [[nodiscard]] bool empty() const { return runs_.empty(); }

    /// Calls `visit` with those of the first 32 facets whose bits are set, in their order, until it returns
    /// false.
    template <class Visit>
    void visit_some(std::uint32_t slots, const Visit& visit) const {
        for (const auto& run : runs_) {
            if (slots == 0) return;
            const auto within = run.count < 32 ? slots & ((std::uint32_t{1} << run.count) - 1) : slots;
            for (auto rest = within; rest != 0; rest &= rest - 1)
                if (!visit(run.begin + std::countr_zero(rest))) return;
            slots = run.count < 32 ? slots >> run.count : 0;
        }
    }
    [[nodiscard]] std::int32_t back() const { return runs_.back().begin + runs_.back().count - 1; }

  private:
    std::span<const FacetRange> runs_;
};

/// A list of facets for each of some others.
class FacetLists {
  public:
    /// Ends the list to which `add` adds; the next one begins.
    void end_list() { first_.push_back(static_cast<std::int32_t>(runs_.size())); }

    void add(std::int32_t facet) {
        const bool new_list = static_cast<std::int32_t>(runs_.size()) == first_.back();
        if (!new_list && runs_.back().count < FacetRange::longest &&
            facet == runs_.back().begin + runs_.back().count)
            ++runs_.back().count;
        else
            runs_.push_back({facet, 1});
    }

    void reserve(std::size_t lists) { first_.reserve(lists + 1); }
    void shrink_to_fit() { runs_.shrink_to_fit(); }

    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
    [[nodiscard]] FacetRanges of(std::int32_t list) const {
        const auto l = static_cast<std::size_t>(list);
        return FacetRanges(std::span(runs_).subspan(static_cast<std::size_t>(first_[l]),
                                                    static_cast<std::size_t>(first_[l + 1] - first_[l])));
    }

  private:
    std::vector<std::int32_t> first_{0};  ///< run of each list
    std::vector<FacetRange> runs_;
};

}  // namespace weavefront::contact
