#include "results_continued.hpp"

#include <fmt/format.h>

#include "hdf5_handle.hpp"
#include "results_skeleton.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

class Existing {
  public:
    explicit Existing(const std::string& path)
        : path_(path),
          file_(checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, unlocked_access(path).get()),
                        path + " cannot be continued: opening")) {}

    [[nodiscard]] H5Dataset dataset(const std::string& name) const {
        return H5Dataset(checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), doing(name)));
    }
    [[nodiscard]] std::int64_t rows(const H5Dataset& dataset, const std::string& name) const {
        const H5Space space(checked(H5Dget_space(dataset.get()), doing(name)));
        return checked(H5Sget_simple_extent_npoints(space.get()), doing(name));
    }
    template <class T>
    [[nodiscard]] std::vector<T> numbers(const std::string& name) const {
        const auto from = dataset(name);
        std::vector<T> values(static_cast<std::size_t>(rows(from, name)));
        checked(H5Dread(from.get(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                doing(name));
        return values;
    }
    [[nodiscard]] std::int64_t frames() const {
        const H5Attribute count(
            checked(H5Aopen_by_name(file_.get(), "/VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT),
                    doing("NSteps")));
        std::int32_t frames = 0;
        checked(H5Aread(count.get(), H5T_NATIVE_INT32, &frames), doing("NSteps"));
        return frames;
    }

  private:
    [[nodiscard]] std::string doing(const std::string& name) const {
        return path_ + " cannot be continued: reading " + name;
    }
    std::string path_;
    H5File file_;
};

}  // namespace

std::int64_t room_of_results(const std::string& path, const ResultsSetup& setup, std::int64_t frames) {
    const Existing file(path);
    const PartSizes sizes(setup);
    if (file.numbers<std::int64_t>("/VTKHDF/NumberOfPoints") != sizes.points ||
        file.numbers<std::int64_t>("/VTKHDF/NumberOfCells") != sizes.cells)
        throw FileError(path + " cannot be continued: it has other nodes or elements than the scene");
    if (file.frames() < frames)
        throw FileError(
            fmt::format("{} cannot be continued: it holds {} frames, {} were written before the checkpoint",
                        path, file.frames(), frames));
    const std::string offsets = "/VTKHDF/Steps/PointOffsets";
    return file.rows(file.dataset(offsets), offsets);
}

std::string scene_of_results(const std::string& path) {
    const auto bytes = Existing(path).numbers<std::uint8_t>("/scene");
    return {bytes.begin(), bytes.end()};
}

}  // namespace weavefront::io
