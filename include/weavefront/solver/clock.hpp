#pragma once
/// @file
/// Time of the central-difference scheme.

#include <cstdint>

namespace weavefront::solver {

/// Positions and forces stand at the times t(n), velocities in the middle of the steps.
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
