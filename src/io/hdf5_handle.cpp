#include "hdf5_handle.hpp"

#include <string_view>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

// H5E_WALK_UPWARD visits the place where the error was found first: the reason, the outer ones only say what
// could not be done then.
herr_t take_innermost(unsigned index, const H5E_error2_t* error, void* reason) {
    if (index == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
    return 0;
}

/// Of a failed call to the system HDF5 tells time, file, address and more in several lines: what the system
/// says is the reason.
std::string of_system(const std::string& reason) {
    constexpr std::string_view before = "error message = '";
    const auto at = reason.find(before);
    if (at == std::string::npos) return reason.substr(0, reason.find('\n'));
    const auto first = at + before.size();
    return reason.substr(first, reason.find('\'', first) - first);
}

}  // namespace

QuietHdf5::QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

hid_t checked(hid_t result, const std::string& doing) {
    if (result >= 0) return result;
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_innermost, &reason);
    throw FileError(doing + " failed" + (reason.empty() ? "" : ": " + of_system(reason)));
}

H5Properties unlocked_access(const std::string& doing) {
    H5Properties access(checked(H5Pcreate(H5P_FILE_ACCESS), doing));
    checked(H5Pset_file_locking(access.get(), false, true), doing);
    return access;
}

H5File open_to_read(const std::string& path, const std::string& doing) {
    return H5File(checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, unlocked_access(doing).get()), doing));
}

void close(H5File& file, const std::string& doing) { checked(H5Fclose(file.release()), doing); }

}  // namespace weavefront::io
