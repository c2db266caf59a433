#pragma once
/// @file
/// Failures agreed by all ranks before anyone leaves a collective path.

#include <exception>
#include <string>
#include <utility>

#include "weavefront/parallel/failure.hpp"

namespace weavefront::io {

/// Collects the first failure of this rank and shares it: after `settle` either all ranks go on or all throw
/// the same.
class Agreement {
  public:
    explicit Agreement(const parallel::Communicator& comm) : comm_(&comm) {}

    /// Runs `action`, keeping the text of what it throws. What is collective inside is called by every rank,
    /// so nothing is skipped after an earlier failure.
    template <class Action>
    void attempt(Action&& action) {
        try {
            action();
        } catch (const std::exception& failure) {
            if (failure_.empty()) failure_ = parallel::text_of(failure);
        }
    }

    /// The same on one rank only.
    template <class Action>
    void attempt_on_root(Action&& action) {
        if (comm_->rank() == 0) attempt(action);
    }

    /// @throws Error on all ranks, with the text of the lowest rank that failed since the last call
    /// @note Collective
    template <class Error>
    void settle() {
        const auto text = parallel::first_failure(*comm_, std::exchange(failure_, {}));
        if (!text.empty()) throw Error(text);
    }

  private:
    const parallel::Communicator* comm_;
    std::string failure_;
};

}  // namespace weavefront::io
