#include "results_copy.hpp"

#include <fcntl.h>

#include <vector>

#include "dataset_rows.hpp"
#include "descriptor.hpp"
#include "frame_publisher.hpp"
#include "hdf5_handle.hpp"
#include "hdf5_reader.hpp"
#include "results_skeleton.hpp"

namespace weavefront::io {

namespace {

class Copy {
  public:
    Copy(const std::string& from, const std::string& to)
        : from_path_(from),
          to_path_(to),
          from_(from, O_RDONLY),
          to_(to, O_WRONLY),
          source_(open_to_read(from, "reading " + from)),
          target_(open_to_read(to, "reading " + to)) {}

    /// Copies the frames and returns their times.
    [[nodiscard]] std::vector<double> all(const ResultsSetup& setup, std::int64_t frames) const {
        const PartSizes sizes(setup);
        const auto points = frames * sizes.all_points(), cells = frames * sizes.all_cells();
        rows("Connectivity", 4 * sizes.all_cells());
        rows("Offsets", sizes.all_cells() + sizes.parts());
        rows("Types", sizes.all_cells());
        rows(std::string("CellData/") + ply_name, sizes.all_cells());
        rows("Points", points);
        for (const auto& array : setup.layout.point_data) rows("PointData/" + array.name, points);
        for (const auto& array : setup.layout.cell_data) rows("CellData/" + array.name, cells);
        rows(std::string("CellData/") + hidden_name, cells);
        return times(frames);
    }

  private:
    /// The first rows of a dataset below /VTKHDF, as they are stored.
    void rows(const std::string& name, std::int64_t count) const {
        const auto doing = "reading " + from_path_;
        const H5Dataset dataset(
            checked(H5Dopen2(source_.get(), ("/VTKHDF/" + name).c_str(), H5P_DEFAULT), doing));
        const H5Type type(checked(H5Dget_type(dataset.get()), doing));
        const DatasetRows source(source_, from_path_, "/VTKHDF/" + name, type.get()),
            target(target_, to_path_, "/VTKHDF/" + name, type.get());
        target.copy(from_, source, to_, count);
    }

    [[nodiscard]] std::vector<double> times(std::int64_t frames) const {
        const auto doing = "reading " + from_path_ + ": Steps/Values";
        return read_rows<double>(
            H5Dataset(checked(H5Dopen2(source_.get(), "/VTKHDF/Steps/Values", H5P_DEFAULT), doing)), 0,
            frames, doing);
    }

    std::string from_path_, to_path_;
    Descriptor from_, to_;
    H5File source_, target_;
};

}  // namespace

void copy_results(const std::string& from, const std::string& to, const ResultsSetup& setup,
                  std::int64_t frames) {
    const auto times = Copy(from, to).all(setup, frames);
    FramePublisher publisher(to);
    for (std::size_t k = 0; k < times.size(); ++k) publisher.publish(static_cast<std::int64_t>(k), times[k]);
}

}  // namespace weavefront::io
