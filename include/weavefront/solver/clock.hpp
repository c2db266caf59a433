#pragma once
/// @file
/// Time of the central-difference scheme.

#include <cstdint>

namespace weavefront::solver {

/// Positions x and forces f stand at the times t_n, velocities v in the middle of the steps:
///
///     v(n+1/2) = v(n-1/2) + (dt(n-1) + dt(n))/2 f(n)/m
///     x(n+1)   = x(n) + dt(n) v(n+1/2)
///     v(n)     = v(n-1/2) + dt(n-1)/2 f(n)/m
struct Clock {
    double time = 0;         ///< t_n, s
    double dt = 0;           ///< from this state to the next, s
    double last_dt = 0;      ///< from the last state to this one, s
    std::int64_t steps = 0;  ///< n

    /// From the middle of the last step to the middle of this one, s.
    [[nodiscard]] double velocity_step() const { return (last_dt + dt) / 2; }

    void advance() {
        time += dt;
        last_dt = dt;
        ++steps;
    }

    template <class Archive>
    void state(Archive& archive) {
        archive("clock.time", time);
        archive("clock.dt", dt);
        archive("clock.last_dt", last_dt);
        archive("clock.steps", steps);
    }
};

}  // namespace weavefront::solver
