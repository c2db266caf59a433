#pragma once
/// @file
/// How a run ends early.

#include <cstdint>
#include <stdexcept>
#include <string>

namespace weavefront::solver {

/// What the guard found; it decides which element a diagnosis names.
enum class Fault : std::uint8_t {
    force,       ///< a force or an energy of a step not finite, or out of range
    energy_sum,  ///< the closure error
    internal,    ///< yarns have given energy
    friction,    ///< friction has given energy
    contact,     ///< contact has given energy
    not_finite   ///< a value of the state
};

/// The physics or numerics guard stopped the run; thrown on all ranks alike. The positions are still those of
/// the last good step.
class GuardStop : public std::runtime_error {
  public:
    explicit GuardStop(const std::string& text, Fault fault = Fault::not_finite)
        : std::runtime_error(text), fault_(fault) {}

    [[nodiscard]] Fault fault() const { return fault_; }

  private:
    Fault fault_;
};

}  // namespace weavefront::solver
