#pragma once
/// @file
/// Energy that sliding has released in contact and not handed on yet.

#include <algorithm>
#include <cstdint>
#include <string>

namespace weavefront::contact {

/// The account of contacts of one kind, over all ranks. Points ahead may take what points behind have
/// released, up to the last step: contact then gives no energy, and a curved side that slides along a uniform
/// surface lacks no more than one step of it. Energies are integers of the fixed-point scale of the ledger,
/// so that every rank has the same.
class SlidingAccount {
  public:
    /// Part of the overlap by sliding that may press in the next step, judged by what the last step wanted.
    [[nodiscard]] double share() const {
        if (balance_ <= 0) return 0;
        return wanted_ <= balance_ ? 1 : static_cast<double>(balance_) / static_cast<double>(wanted_);
    }

    /// Books a step. @param released less what was taken @param wanted by points ahead; both summed over
    /// ranks
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
