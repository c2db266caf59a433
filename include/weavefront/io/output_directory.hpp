#pragma once
/// @file
/// The directory a run writes to.

#include <filesystem>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Keeps a directory to one run for as long as it lives, where the file system knows locks.
class OutputDirectory {
  public:
    /// Creates the directory with its parents where it does not exist yet, makes sure that it can be written to, and removes the
    /// summary of an earlier run: whoever finds one finds that of a run that has ended.
    /// @param path  the same on all ranks
    /// @param comm  ranks of the run
    /// @throws FileError on all ranks when rank 0 cannot create it, must not write to it or finds another run there
    /// @note Collective
    OutputDirectory(const std::filesystem::path& path, const parallel::Communicator& comm);
    ~OutputDirectory();
    OutputDirectory(const OutputDirectory&) = delete;
    OutputDirectory& operator=(const OutputDirectory&) = delete;

    /// Whether an earlier run had ended there; on rank 0.
    [[nodiscard]] bool replaces() const { return replaces_; }

  private:
    int lock_ = -1;  // descriptor of the directory, on rank 0
    bool replaces_ = false;
};

}  // namespace weavefront::io
