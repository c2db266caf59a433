#pragma once
/// @file
/// Rows of datasets in a file that all ranks write together.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "descriptor.hpp"
#include "hdf5_handle.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Place of a contiguous dataset in its file. Ranks write there by calls of the system: each learns of its
/// own failure and none waits. In MPI-IO and in HDF5 upon it other ranks wait for one that cannot write.
class DatasetRows {
  public:
    DatasetRows() = default;
    /// @param file   open for reading by this process
    /// @param path   of the file, for messages
    /// @param memory HDF5 type of the values in memory, which must be that in the file
    DatasetRows(const H5File& file, const std::string& path, const std::string& name, hid_t memory);

    /// Writes this rank's rows. @param first row at which they begin
    /// @param values whole rows, one after the other; may be empty
    /// @throws FileError
    template <class T>
    void write(const Descriptor& file, std::int64_t first, std::span<const T> values) const {
        file.write(std::as_bytes(values), offset_ + first * row_bytes_);
    }
    template <class T>
    void write(const Descriptor& file, std::int64_t first, const std::vector<T>& values) const {
        write(file, first, std::span<const T>(values));
    }

    /// Copies the first rows of the same dataset in another file, without the format between. @throws
    /// FileError
    void copy(const Descriptor& from, const DatasetRows& source, const Descriptor& to,
              std::int64_t rows) const;

  private:
    std::int64_t offset_ = 0, row_bytes_ = 0;
};

/// Rows that follow the last block of the global order, appended on the rank that holds it: so each rank
/// still writes one piece.
template <class T>
std::vector<T> with_rows_of_last_rank(const parallel::Communicator& comm, std::vector<T> block,
                                      const std::vector<T>& rows) {
    if (comm.rank() == comm.size() - 1) block.insert(block.end(), rows.begin(), rows.end());
    return block;
}

}  // namespace weavefront::io
