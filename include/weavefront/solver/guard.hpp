#pragma once
/// @file
/// How a run ends early.

#include <stdexcept>

namespace weavefront::solver {

/// The physics or numerics guard stopped the run; thrown on all ranks alike. The positions are still those of
/// the last good step.
class GuardStop : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace weavefront::solver
