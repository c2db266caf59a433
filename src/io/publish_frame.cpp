#include "publish_frame.hpp"

#include "hdf5_handle.hpp"

namespace weavefront::io {

void publish_frame(const std::string& path, std::int64_t frame, double time) {
    const std::string doing = "writing " + path + ": Steps";
    H5File file(checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, unlocked_access(path).get()), doing));
    const H5Dataset times(checked(H5Dopen2(file.get(), "/VTKHDF/Steps/Values", H5P_DEFAULT), doing));
    const H5Group steps(checked(H5Gopen2(file.get(), "/VTKHDF/Steps", H5P_DEFAULT), doing));
    const H5Attribute count(checked(H5Aopen(steps.get(), "NSteps", H5P_DEFAULT), doing));

    const hsize_t first = static_cast<hsize_t>(frame);
    const hsize_t frames = first + 1;
    checked(H5Dset_extent(times.get(), &frames), doing);
    const hsize_t one = 1;
    const H5Space here(checked(H5Dget_space(times.get()), doing));
    checked(H5Sselect_hyperslab(here.get(), H5S_SELECT_SET, &first, nullptr, &one, nullptr), doing);
    const H5Space memory(checked(H5Screate_simple(1, &one, nullptr), doing));
    checked(H5Dwrite(times.get(), H5T_NATIVE_DOUBLE, memory.get(), here.get(), H5P_DEFAULT, &time), doing);
    checked(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), doing);

    const auto number = static_cast<std::int32_t>(frames);
    checked(H5Awrite(count.get(), H5T_NATIVE_INT32, &number), doing);
    checked(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), doing);
    close(file, doing);
}

}  // namespace weavefront::io
