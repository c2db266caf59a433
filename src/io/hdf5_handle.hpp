#pragma once
/// @file
/// HDF5 handles closed by type, and the check of every HDF5 call.

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>

namespace weavefront::io {

/// Move-only owner of an HDF5 identifier, closed by `Close`.
template <herr_t (*Close)(hid_t)>
class Hdf5Handle {
  public:
    Hdf5Handle() = default;
    explicit Hdf5Handle(hid_t id) : id_(id) {}
    ~Hdf5Handle() { close(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        if (this != &other) {
            close();
            id_ = std::exchange(other.id_, H5I_INVALID_HID);
        }
        return *this;
    }

    [[nodiscard]] hid_t get() const { return id_; }
    /// Gives the identifier up, for a close whose failure must be seen.
    [[nodiscard]] hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

  private:
    void close() {
        if (id_ >= 0) Close(std::exchange(id_, H5I_INVALID_HID));
    }
    hid_t id_ = H5I_INVALID_HID;
};

using H5File = Hdf5Handle<H5Fclose>;
using H5Group = Hdf5Handle<H5Gclose>;
using H5Dataset = Hdf5Handle<H5Dclose>;
using H5Space = Hdf5Handle<H5Sclose>;
using H5Attribute = Hdf5Handle<H5Aclose>;
using H5Type = Hdf5Handle<H5Tclose>;
using H5Properties = Hdf5Handle<H5Pclose>;

/// Keeps HDF5 from printing its error stack while it lives; `checked` puts what matters of it into the
/// exception.
class QuietHdf5 {
  public:
    QuietHdf5();
    ~QuietHdf5();
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

  private:
    H5E_auto2_t print_ = nullptr;
    void* data_ = nullptr;
};

/// Passes a good status or identifier through.
/// @param result  what an HDF5 function returned
/// @param doing   file and action, for the message
/// @throws FileError with the innermost reason that HDF5 gives when `result` is negative
hid_t checked(hid_t result, const std::string& doing);

/// Access properties for one process, without locks: readers are welcome while a run writes, and some
/// parallel file systems know none.
H5Properties unlocked_access(const std::string& doing);

/// Opens a file for reading. @param doing file and action, for the message @throws FileError
H5File open_to_read(const std::string& path, const std::string& doing);

/// Closes a file and checks it, which its destructor cannot. @throws FileError
void close(H5File& file, const std::string& doing);

/// HDF5 type of `T` in memory.
template <class T>
hid_t native_type();
template <>
inline hid_t native_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t native_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
inline hid_t native_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
inline hid_t native_type<std::int8_t>() {
    return H5T_NATIVE_INT8;
}
template <>
inline hid_t native_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}

}  // namespace weavefront::io
