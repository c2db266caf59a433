#pragma once
/// @file
/// Times of the parts of a step on a machine.

#include <string>

namespace weavefront::partition {

/// Constants of the cost model, measured by `weavefront partition SCENE --calibrate FILE`; all times in
/// seconds.
struct Machine {
    std::string name;
    int ranks = 1;              ///< ranks that computed at the same time during the measurement
    double reference_time = 0;  ///< time of an element-step of a small scene during the measurement: the
                                ///< speed of the processor then
    double crowding = 1;        ///< time of a step on all ranks at once over the time on one rank alone
    double element = 0;         ///< element kernel, force sums and time step, per element and step
    double node = 0;            ///< integration, per node and step
    double watch = 0;           ///< contact between plies, per element and step, everywhere
    double touch = 0;           ///< additional, per element and step, where plies are near contact
    double press = 0;  ///< additional, per element and step, where the projectile presses plies together
    double decay =
        0;  ///< part of `touch` that is lost by the end of the run, when the projectile no longer pushes
    double search = 0;  ///< search for candidates, per element and search
    double searches_per_step =
        0;                 ///< searches per step for a projectile of a hundredth of the yarns' wave speed
    double latency = 0;    ///< per message to a neighbour
    double bandwidth = 0;  ///< bytes/s that a rank sends and receives at the same time
    double reduction = 0;  ///< reduction of a few numbers over all ranks, per doubling of the ranks
};

/// The machine of partition/machine.json, from which the costs of columns are computed.
const Machine& committed_machine();

}  // namespace weavefront::partition
