#pragma once
/// @file
/// The account of energy that sliding releases and takes.

#include <algorithm>
#include <cstdint>
#include <string>

namespace weavefront::contact {

/// Account of one kind of contact over all ranks. Points that sliding closes may take the energy that opening
/// points have released up to the last step. So contact never creates energy. A curved side that slides along
/// a uniform surface lacks at most one step of its energy. Energies are integers of the ledger's fixed-point
/// scale, the same on every rank.
class SlidingAccount {
  public:
    /// Part of the overlap caused by sliding that may press in the next step, from the demand of the last
    /// one.
    [[nodiscard]] double sliding_share() const {
        if (balance_ <= 0) return 0;
        return wanted_ <= balance_ ? 1 : static_cast<double>(balance_) / static_cast<double>(wanted_);
    }

    /// Books a step.
    /// @param released energy released less energy taken, summed over ranks
    /// @param wanted   energy that closing points would have taken, summed over ranks
    void book(std::int64_t released, std::int64_t wanted) {
        balance_ += released;
        wanted_ = wanted;
    }

    template <class Archive>
    void state(Archive& archive, const std::string& name) {
        archive(name + ".balance", balance_);
        archive(name + ".wanted", wanted_);
    }

  private:
    std::int64_t balance_ = 0, wanted_ = 0;
};

}  // namespace weavefront::contact
