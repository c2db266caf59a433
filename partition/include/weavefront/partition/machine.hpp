#pragma once
/// @file
/// What the parts of a step take on a machine.

#include <string>

namespace weavefront::partition {

/// Constants of the cost model, measured by `weavefront partition SCENE --calibrate FILE`; all times in
/// seconds.
struct Machine {
    std::string name;
    int ranks = 1;  ///< that computed at once when it was measured
    double reference_time =
        0;                ///< of an element-step of a small scene just then: tells how fast the processor was
    double crowding = 1;  ///< time of a step with all of them computing over that of one alone
    double element = 0;   ///< kernel, sums and time step, per element and step
    double node = 0;      ///< integration, per node and step
    double watch = 0;     ///< per element and step for plies that may touch one another
    double touch = 0;     ///< more, per element and step, where they are near to touching
    double press = 0;     ///< more still, per element and step, where the projectile presses them together
    double decay =
        0;  ///< share of `touch` that is gone at the end of the run, when the projectile no longer pushes
    double search = 0;  ///< renewal of what may meet what, per element and renewal
    double searches_per_step =
        0;                 ///< renewals, for a projectile as fast as a hundredth of the wave in the yarns
    double latency = 0;    ///< per message to a neighbour
    double bandwidth = 0;  ///< bytes/s that a rank sends and receives at once
    double reduction = 0;  ///< of a few numbers over all ranks, per doubling of the ranks
};

/// The machine of partition/machine.json, on whose ratios the weights of columns rest.
const Machine& committed_machine();

}  // namespace weavefront::partition
