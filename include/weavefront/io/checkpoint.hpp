#pragma once
/// @file
/// Checkpoints: the state of a run as an HDF5 file, from which any number of ranks goes on.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/state/table.hpp"
#include "weavefront/state/values.hpp"

namespace weavefront::io {

/// What a checkpoint holds.
struct CheckpointContent {
    std::string scene;                             ///< the resolved scene
    std::string version;                           ///< of Weavefront
    state::Values values;                          ///< the same on all ranks
    state::Table nodes, elements;                  ///< of this rank, each item on one rank
    std::int64_t all_nodes = 0, all_elements = 0;  ///< of all ranks
};

/// Writes a checkpoint, in the global order of its items. The file takes its name when all of it is on the
/// disk and was read back. The one before is kept under `previous_checkpoint`.
/// @throws FileError on all ranks; checkpoints of before stay as they are
/// @note Collective
void write_checkpoint(const std::filesystem::path& path, CheckpointContent content,
                      const parallel::Communicator& comm);

/// Makes the checkpoint from which a run goes on the newest one of its folder: `previous_checkpoint` is
/// moved, any other file is copied. A newer one, which is damaged or of rows that are cut, is replaced.
/// Afterwards the next checkpoint may move the newest one without a moment at which none can be used.
/// @param path of the newest checkpoint of the folder
/// @throws FileError on all ranks
/// @note Collective
void adopt_checkpoint(const std::filesystem::path& from, const std::filesystem::path& path,
                      const parallel::Communicator& comm);

/// Where the checkpoint before the newest one is kept.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

/// A checkpoint that was found whole.
class Checkpoint {
  public:
    /// Reads all of the file and compares its checksum.
    /// @throws FileError on all ranks when the file cannot be read, is cut or was changed
    /// @note Collective
    Checkpoint(const std::filesystem::path& path, const parallel::Communicator& comm);
    ~Checkpoint();
    Checkpoint(Checkpoint&&) noexcept;
    Checkpoint& operator=(Checkpoint&&) noexcept;

    [[nodiscard]] const std::string& scene() const;
    [[nodiscard]] const std::string& version() const;
    [[nodiscard]] const state::Values& values() const;

    /// State of some nodes or elements. @param ids global, ascending; other ranks may ask for the same ones
    /// @throws FileError on all ranks
    /// @note Collective
    [[nodiscard]] state::Table nodes(std::span<const std::int64_t> ids) const;
    [[nodiscard]] state::Table elements(std::span<const std::int64_t> ids) const;

  private:
    class File;
    std::unique_ptr<File> file_;
};

}  // namespace weavefront::io
