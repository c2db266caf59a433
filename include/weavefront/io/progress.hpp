#pragma once
/// @file
/// How far a run is and how long it will take.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "weavefront/io/log.hpp"

namespace weavefront::io {

/// Wall time left, from how fast the simulated time went lately.
class RemainingTime {
  public:
    /// @param end     simulated time at which the run ends, s
    /// @param window  wall time over which the rate is taken, s
    explicit RemainingTime(double end, double window = 30) : end_(end), window_(window) {}

    /// @param time  simulated time reached, s
    /// @param wall  wall clock, s
    void add(double time, double wall);
    /// Wall time left, s; empty until there is a rate.
    [[nodiscard]] std::optional<double> left() const;

  private:
    struct Sample {
        double time, wall;
    };
    double end_, window_;
    std::deque<Sample> samples_;  // the window and one sample before it
};

/// Shows the progress of a run: on a terminal a bar that is redrawn in place, elsewhere (and in run.log) a
/// line at every 10 %.
class Progress {
  public:
    using Clock = std::function<double()>;  ///< wall clock, s

    /// @param log    takes the lines; must outlive this object
    /// @param end    simulated time at which the run ends, s
    /// @param clock  empty: the system's steady clock
    Progress(Log& log, double end, Clock clock = {});

    /// Cheap enough for every step.
    /// @param time        simulated time reached, s
    /// @param step        steps done
    /// @param projectile  what to say of the projectile, e.g. "projectile 212.4 m/s"
    void update(double time, std::int64_t step, std::string_view projectile);
    /// Ends the bar where it stands.
    void finish();

  private:
    [[nodiscard]] double fraction(double time) const;
    [[nodiscard]] std::string line(double time, std::int64_t step, std::string_view projectile) const;

    Log& log_;
    double end_;
    Clock clock_;
    RemainingTime remaining_;
    double drawn_at_;
    int tenths_ = 0;
};

/// A duration as a reader says it: "8 s", "3 min 20 s", "2 h 05 min".
/// @param seconds  >= 0
std::string duration_text(double seconds);

}  // namespace weavefront::io
