#pragma once
/// @file
/// What happens to a projectile during the run.

#include <optional>
#include <string>

#include "weavefront/body/rigid_body.hpp"
#include "weavefront/contact/projectile_on_frame.hpp"
#include "weavefront/solver/passages.hpp"

namespace weavefront::solver {

/// One projectile's forces of the present step, its events, and its motion at the start. All ranks have the
/// same.
struct Shot {
    body::RigidBody initial;
    body::Wrench wrench = {};             ///< of fabric and frame on the projectile
    contact::FromFrame from_frame = {};   ///< the frame's part
    bool touched = false;                 ///< whether any force ever acted on the projectile
    double last_touched = 0;              ///< when it did last, s
    std::optional<double> turned_back{};  ///< when the projectile first moved away from the target, s
    Passages passages;

    /// @param name of the projectile
    template <class Archive>
    void state(Archive& archive, const std::string& name) {
        archive(name + ".touched", touched);
        archive(name + ".last_touched", last_touched);
        archive(name + ".turned_back", turned_back);
        passages.state(archive, name + ".passages");
    }
};

}  // namespace weavefront::solver
