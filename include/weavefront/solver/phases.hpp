#pragma once
/// @file
/// Wall time by phase of the step.

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

namespace weavefront::solver {

enum class Phase : std::size_t { setup, elements, contact, halo, integrate, search, ledger, output };

inline constexpr std::array<std::string_view, 8> phase_names{"setup",     "elements", "contact", "halo",
                                                             "integrate", "search",   "ledger",  "output"};

/// Seconds spent in each phase on this rank.
using PhaseSeconds = std::array<double, phase_names.size()>;

/// Adds its lifetime to one phase.
class Timed {
  public:
    Timed(PhaseSeconds& seconds, Phase phase)
        : seconds_(seconds[static_cast<std::size_t>(phase)]), start_(Clock::now()) {}
    ~Timed() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
    Timed(const Timed&) = delete;
    Timed& operator=(const Timed&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& seconds_;
    Clock::time_point start_;
};

}  // namespace weavefront::solver
