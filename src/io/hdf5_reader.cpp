#include "hdf5_reader.hpp"

#include <fmt/format.h>

#include <array>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

[[noreturn]] void refuse(const std::string& doing, const std::string& reason) {
    throw FileError(fmt::format("{} failed: {}", doing, reason));
}

/// @param kind what an attribute holds, in messages
H5Type type_of_one(const H5Attribute& attribute, H5T_class_t of_class, const char* kind,
                   const std::string& doing) {
    H5Type type(checked(H5Aget_type(attribute.get()), doing));
    const H5Space space(checked(H5Aget_space(attribute.get()), doing));
    if (H5Tget_class(type.get()) != of_class || H5Tis_variable_str(type.get()) > 0 ||
        H5Sget_simple_extent_npoints(space.get()) != 1)
        refuse(doing, fmt::format("it is not one {}", kind));
    return type;
}

}  // namespace

std::int64_t number_in(const H5Attribute& attribute, const std::string& doing) {
    const auto type = type_of_one(attribute, H5T_INTEGER, "integer", doing);
    std::int64_t value = 0;
    checked(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), doing);
    return value;
}

std::string text_in(const H5Attribute& attribute, const std::string& doing) {
    const auto type = type_of_one(attribute, H5T_STRING, "text of fixed length", doing);
    std::string value(H5Tget_size(type.get()), '\0');
    checked(H5Aread(attribute.get(), type.get(), value.data()), doing);
    return value.substr(0, value.find('\0'));
}

Extents2 extents_of(const H5Dataset& dataset, const std::string& doing) {
    const H5Space space(checked(H5Dget_space(dataset.get()), doing));
    const auto dimensions = checked(H5Sget_simple_extent_ndims(space.get()), doing);
    if (dimensions < 1 || dimensions > 2)
        refuse(doing, fmt::format("it has {} dimensions, allowed are 1 and 2", dimensions));
    std::array<hsize_t, 2> extents{0, 1};
    checked(H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr), doing);
    // Values that nobody has written take no room in the file, but would in memory.
    const H5Type type(checked(H5Dget_type(dataset.get()), doing));
    const auto [rows, columns] = extents;
    const hsize_t stored = H5Dget_storage_size(dataset.get()) / H5Tget_size(type.get());
    if (rows > 0 && columns > 0 && rows > stored / columns)
        refuse(doing, fmt::format("it holds {} values, by its extents {} x {}", stored, rows, columns));
    return {static_cast<std::int64_t>(rows), static_cast<std::int64_t>(columns)};
}

std::size_t values_in_rows(const H5Dataset& dataset, std::int64_t first, std::int64_t count,
                           const std::string& doing) {
    const auto [rows, columns] = extents_of(dataset, doing);
    if (first < 0 || count < 0 || first > rows || count > rows - first)
        refuse(doing, fmt::format("it has {} rows, not {} from {}", rows, count, first));
    return count == 0 ? 0 : static_cast<std::size_t>(count * columns);
}

void read_rows(const H5Dataset& dataset, std::int64_t first, std::int64_t count, hid_t memory_type,
               void* values, const std::string& doing) {
    const H5Space space(checked(H5Dget_space(dataset.get()), doing));
    const auto dimensions = static_cast<int>(checked(H5Sget_simple_extent_ndims(space.get()), doing));
    const std::array<hsize_t, 2> start{static_cast<hsize_t>(first), 0},
        extents{static_cast<hsize_t>(count), static_cast<hsize_t>(extents_of(dataset, doing).columns)};
    checked(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, extents.data(), nullptr),
            doing);
    const H5Space memory(checked(H5Screate_simple(dimensions, extents.data(), nullptr), doing));
    checked(H5Dread(dataset.get(), memory_type, memory.get(), space.get(), H5P_DEFAULT, values), doing);
}

}  // namespace weavefront::io
