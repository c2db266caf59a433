#pragma once
/// @file
/// A file that HDF5 writes in memory and that is then copied to the disk.

#include <string>

#include "descriptor.hpp"
#include "hdf5_handle.hpp"

namespace weavefront::io {

/// An empty file that no disk holds. HDF5 does not survive a full disk while it creates the structure of a
/// file: it crashes when the program ends. So it creates the structure here, and the copy reports the error.
class FileInMemory {
  public:
    /// @param shown  path in messages. @throws FileError where the system gives no memory
    explicit FileInMemory(const std::string& shown);
    ~FileInMemory();
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;

    /// Makes it an HDF5 file, to be filled and closed. @throws FileError
    [[nodiscard]] H5File create_hdf5() const;
    /// Copies what was written and the size. What was never written takes no room on the disk.
    /// @throws FileError
    void copy_to(const Descriptor& file) const;

  private:
    [[nodiscard]] std::string path() const;

    std::string shown_;
    int number_;
};

}  // namespace weavefront::io
