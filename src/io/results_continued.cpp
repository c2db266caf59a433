#include "results_continued.hpp"

#include <fmt/format.h>

#include "hdf5_handle.hpp"
#include "hdf5_reader.hpp"
#include "results_skeleton.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

class Existing {
  public:
    explicit Existing(const std::string& path)
        : path_(path), file_(open_to_read(path, path + " cannot be continued: opening")) {}

    [[nodiscard]] H5Dataset dataset(const std::string& name) const {
        return H5Dataset(checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), doing(name)));
    }
    [[nodiscard]] std::int64_t rows(const H5Dataset& dataset, const std::string& name) const {
        return extents_of(dataset, doing(name)).rows;
    }
    template <class T>
    [[nodiscard]] std::vector<T> numbers(const std::string& name) const {
        const auto from = dataset(name);
        return read_rows<T>(from, 0, rows(from, name), doing(name));
    }
    [[nodiscard]] std::int64_t frames() const {
        const H5Attribute count(
            checked(H5Aopen_by_name(file_.get(), "/VTKHDF/Steps", "NSteps", H5P_DEFAULT, H5P_DEFAULT),
                    doing("NSteps")));
        return number_in(count, doing("NSteps"));
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
