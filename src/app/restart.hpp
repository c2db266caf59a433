#pragma once
/// @file
/// The checkpoint from which a run goes on.

#include <filesystem>
#include <string>
#include <vector>

#include "weavefront/io/checkpoint.hpp"
#include "weavefront/parallel/communicator.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::app {

/// A checkpoint that was found, and what was found on the way.
struct Restart {
    std::filesystem::path path;
    io::Checkpoint checkpoint;
    std::vector<std::string> passed_over;  ///< newer checkpoints, and why they are of no use
};

/// Where a run keeps its newest checkpoint.
std::filesystem::path checkpoint_in(const std::filesystem::path& folder);

/// Finds a checkpoint that is whole and of this scene.
/// @param wanted `auto`: the newest one in the folder that is whole; else a file
/// @throws scene::InputError on all ranks when there is none, or the scene differs in what has shaped the
/// past; io::FileError when the file that was named is not whole
/// @note Collective
Restart find_restart(const std::string& wanted, const std::filesystem::path& folder,
                     const scene::Scene& scene, const parallel::Communicator& comm);

}  // namespace weavefront::app
