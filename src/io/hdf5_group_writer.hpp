#pragma once
/// @file
/// Groups of an HDF5 file and what is put into them by one process.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace weavefront::io {

using Extents = std::vector<hsize_t>;

/// Creation properties of a file, group or dataset, without object times: two files of the same run must not
/// differ by their moment.
H5Properties creation_properties(hid_t kind, const std::string& doing);

/// Writes attributes and datasets into one group. Every function throws FileError.
class GroupWriter {
  public:
    /// Creates the group `name` in `parent`; `file` is the path of the file, for messages.
    GroupWriter(const std::string& file, hid_t parent, const std::string& name);
    /// The root group of an open file.
    static GroupWriter root(const std::string& file, hid_t id);

    [[nodiscard]] hid_t get() const { return group_.get(); }

    /// One value as a scalar, more as a vector.
    template <class T>
    void attribute(const std::string& name, std::span<const T> values, hid_t file_type) const {
        attribute(name, values.size(), file_type, native_type<T>(), values.data());
    }
    /// ASCII text of fixed length: older readers refuse strings of variable length.
    void attribute(const std::string& name, const std::string& text) const;

    /// Contiguous dataset whose space is allocated now and left unwritten.
    H5Dataset dataset(const std::string& name, hid_t file_type, const Extents& extents) const;
    /// The same, written.
    template <class T>
    void dataset(const std::string& name, hid_t file_type, const Extents& extents,
                 std::span<const T> values) const {
        const H5Dataset made = dataset(name, file_type, extents);
        checked(H5Dwrite(made.get(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                "writing " + where_ + "/" + name);
    }
    /// Vector with one entry now and up to `most` later, in one chunk that exists from the start: growing
    /// changes only the extent.
    void growing_dataset(const std::string& name, hid_t file_type, hsize_t most) const;

  private:
    GroupWriter(std::string where, H5Group group) : where_(std::move(where)), group_(std::move(group)) {}
    void attribute(const std::string& name, std::size_t count, hid_t file_type, hid_t memory_type,
                   const void* values) const;
    H5Dataset create(const std::string& name, hid_t file_type, const H5Space& space,
                     const H5Properties& properties) const;

    std::string where_;
    H5Group group_;
};

}  // namespace weavefront::io
