#pragma once
/// @file
/// What `v50` is asked for, read and checked.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "criterion.hpp"
#include "range_shots.hpp"
#include "speed_unit.hpp"
#include "weavefront/ballistics/limit_search.hpp"
#include "weavefront/ballistics/neyer_design.hpp"
#include "weavefront/ballistics/scatter.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// The scene as it stands, or with another mesh or contact stiffness.
struct V50Variant {
    std::string label;  ///< `scene`, `mesh 2 mm`, `stiffness x 0.5`
    std::vector<std::string> settings;
};

/// The first variant is the scene as it stands.
struct V50Plan {
    std::string scene_text, scene_name;
    std::map<std::filesystem::path, std::string> files;  ///< that the scene names, read once
    std::vector<std::string> settings;  ///< of every shot: those of `v50`, then those of the user
    std::array<double, 3> direction{};  ///< of the shot, unit vector
    std::int64_t plies = 0;
    double projectile_mass = 0;  ///< kg
    std::string velocity_key;    ///< of the scene
    int columns = 1;             ///< of elements: the most ranks that a shot can use
    std::string title;
    ballistics::SearchPlan search;
    ballistics::NeyerPlan design;
    std::vector<ballistics::ScatterLaw> scatter;  ///< empty: the limit of a scene without scatter is searched
    std::uint64_t seed = 1;
    int count = 0;   ///< shots with scatter
    int groups = 1;  ///< of ranks, which shoot side by side
    double confidence = 0.95;
    Criterion criterion;
    SpeedUnit unit;
    std::vector<V50Variant> variants;
    std::vector<RangeShot> range_shots;
    CheckpointPlan checkpoints;

    /// What `--set` would take for one shot.
    [[nodiscard]] std::vector<std::string> settings_of(std::size_t variant, int number, double speed) const;
    /// The scene of one shot. @throws scene::InputError
    [[nodiscard]] scene::Scene scene_of(std::size_t variant, int number, double speed) const;
};

/// Reads options, scene and shots of a range.
/// @throws scene::InputError on all ranks with every finding in the options; or with those in the scene
/// @note Collective
V50Plan read_v50_plan(const V50Options& options, const parallel::Communicator& comm);

}  // namespace weavefront::app
