#pragma once
/// @file
/// What is read from HDF5 files of others. Objects may be of any type and extents there: HDF5 would write an
/// array into the place of a number.

#include <cstdint>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace weavefront::io {

/// An attribute that is one integer. @param doing file and action, for messages @throws FileError
std::int64_t number_in(const H5Attribute& attribute, const std::string& doing);

/// An attribute that is one text of fixed length. @throws FileError
std::string text_in(const H5Attribute& attribute, const std::string& doing);

/// Extents of a dataset of one or two dimensions.
struct Extents2 {
    std::int64_t rows, columns;
};

/// @throws FileError when it has more dimensions, or fewer values in the file than its extents tell
Extents2 extents_of(const H5Dataset& dataset, const std::string& doing);

/// Rows of a dataset as values of `memory_type`; see the template. @param values room for them
void read_rows(const H5Dataset& dataset, std::int64_t first, std::int64_t count, hid_t memory_type,
               void* values, const std::string& doing);

/// How many values some rows have. @throws FileError when the dataset has no such rows
std::size_t values_in_rows(const H5Dataset& dataset, std::int64_t first, std::int64_t count,
                           const std::string& doing);

/// Rows of a dataset of one or two dimensions, all their columns. @throws FileError
template <class T>
std::vector<T> read_rows(const H5Dataset& dataset, std::int64_t first, std::int64_t count,
                         const std::string& doing) {
    std::vector<T> values(values_in_rows(dataset, first, count, doing));
    if (!values.empty()) read_rows(dataset, first, count, native_type<T>(), values.data(), doing);
    return values;
}

}  // namespace weavefront::io
