#pragma once
/// @file
/// A folder kept to one run, on any file system.

#include <filesystem>

namespace weavefront::io {

/// The file run.lock in a folder, with host, process and start of the run that keeps the folder. A lock whose
/// process is gone from this host is taken over.
class RunLock {
  public:
    /// @throws FileError naming the run that keeps the folder
    explicit RunLock(const std::filesystem::path& folder);
    /// Gives the folder free, where it is still the one that was locked.
    ~RunLock();
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace weavefront::io
