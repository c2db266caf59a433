#pragma once
/// @file
/// The directory a run writes to.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

class RunLock;

/// What is done with files of before.
enum class Earlier {
    refused,    ///< of a run: there must be none
    replaced,   ///< of a run: they stay until `clear`
    continued,  ///< of a run, which goes on with them; there must be some
    kept,       ///< of a study or of `v50`, which goes on from them; those of a run are refused
};

/// Keeps a directory to one run, one study or one `v50`, for as long as it lives.
class OutputDirectory {
  public:
    /// Creates the directory with its parents where it does not exist yet and makes sure that it can be
    /// written to. Files of before are not touched; temporary ones that a killed run has left are removed,
    /// but for `refused`.
    /// @param path  the same on all ranks
    /// @param comm  ranks of the run; must outlive this object
    /// @throws scene::InputError on all ranks, naming them, when there are files of an earlier run that are
    /// refused; FileError when rank 0 cannot create the directory, must not write to it, finds another run
    /// there, or anything but a regular file in the place of one of its own
    /// @note Collective
    OutputDirectory(const std::filesystem::path& path, const parallel::Communicator& comm,
                    Earlier earlier = Earlier::refused);
    /// Removes the directory again where it was created and nothing was written to it.
    ~OutputDirectory();
    OutputDirectory(const OutputDirectory&) = delete;
    OutputDirectory& operator=(const OutputDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Removes the summary of an earlier part of the run, which goes on. @throws FileError on all ranks
    /// @note Collective
    void remove_summary();

    /// Removes what an earlier run has left, for a new one that is certain to start. @throws FileError on all
    /// ranks
    /// @return names of what was there, on rank 0
    /// @note Collective
    std::vector<std::string> clear();

  private:
    std::filesystem::path path_;
    const parallel::Communicator& comm_;
    bool is_created_ = false;
    std::unique_ptr<RunLock> lock_;  // on rank 0
};

}  // namespace weavefront::io
