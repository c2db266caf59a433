#pragma once
/// @file
/// An HDF5 file that all ranks write together.

#include <span>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// Opens an existing file for writing by all ranks. @throws FileError @note Collective
H5File open_by_all(const std::string& path, const parallel::Communicator& comm);

/// Rows of a dataset that begin at `first`, `length` values of `memory_type` in all; see the template.
void write_rows(const H5Dataset& dataset, std::int64_t first, std::size_t length, hid_t memory_type,
                const void* values, const std::string& doing);

/// Writes this rank's rows of a dataset.
/// @param first   row at which they begin
/// @param values  whole rows, one after the other; may be empty
/// @param doing   file and action, for messages
/// @throws FileError
/// @note Collective
template <class T>
void write_rows(const H5Dataset& dataset, std::int64_t first, std::span<const T> values,
                const std::string& doing) {
    write_rows(dataset, first, values.size(), native_type<T>(), values.data(), doing);
}

/// Rows that follow the last block of the global order, appended on the rank that holds it: so each rank
/// still writes one piece.
template <class T>
std::vector<T> with_rows_of_last_rank(const parallel::Communicator& comm, std::vector<T> block,
                                      const std::vector<T>& rows) {
    if (comm.rank() == comm.size() - 1) block.insert(block.end(), rows.begin(), rows.end());
    return block;
}

}  // namespace weavefront::io
