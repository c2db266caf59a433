#include "frame_publisher.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

FramePublisher::FramePublisher(const std::string& path)
    : doing_("writing " + path + ": Steps"),
      file_(checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, unlocked_access(path).get()), doing_)),
      times_(checked(H5Dopen2(file_.get(), "/VTKHDF/Steps/Values", H5P_DEFAULT), doing_)),
      steps_(checked(H5Gopen2(file_.get(), "/VTKHDF/Steps", H5P_DEFAULT), doing_)),
      count_(checked(H5Aopen(steps_.get(), "NSteps", H5P_DEFAULT), doing_)) {}

void FramePublisher::publish(std::int64_t frame, double time) {
    const hsize_t first = static_cast<hsize_t>(frame), frames = first + 1, one = 1;
    checked(H5Dset_extent(times_.get(), &frames), doing_);
    const H5Space here(checked(H5Dget_space(times_.get()), doing_));
    checked(H5Sselect_hyperslab(here.get(), H5S_SELECT_SET, &first, nullptr, &one, nullptr), doing_);
    const H5Space memory(checked(H5Screate_simple(1, &one, nullptr), doing_));
    checked(H5Dwrite(times_.get(), H5T_NATIVE_DOUBLE, memory.get(), here.get(), H5P_DEFAULT, &time), doing_);
    flush();
    const auto number = static_cast<std::int32_t>(frames);
    checked(H5Awrite(count_.get(), H5T_NATIVE_INT32, &number), doing_);
    flush();
}

void FramePublisher::require_in_place(const std::string& path) const {
    io::require_in_place(descriptor(), path);
}

// Readers never find more frames than times.
void FramePublisher::cut(std::int64_t frames) {
    const auto number = static_cast<std::int32_t>(frames);
    checked(H5Awrite(count_.get(), H5T_NATIVE_INT32, &number), doing_);
    flush();
    const hsize_t extent = std::max<hsize_t>(static_cast<hsize_t>(frames), 1);
    checked(H5Dset_extent(times_.get(), &extent), doing_);
    flush();
}

void FramePublisher::sync() const {
    if (::fsync(descriptor()) != 0) throw FileError(doing_ + ": " + std::generic_category().message(errno));
}

int FramePublisher::descriptor() const {
    void* descriptor = nullptr;  // of the driver for one process: to an int
    checked(H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &descriptor), doing_);
    return *static_cast<const int*>(descriptor);
}

void FramePublisher::flush() const { checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), doing_); }

}  // namespace weavefront::io
