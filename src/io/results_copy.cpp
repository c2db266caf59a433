#include "results_copy.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "frame_publisher.hpp"
#include "hdf5_handle.hpp"
#include "results_skeleton.hpp"

namespace weavefront::io {

namespace {

constexpr hsize_t bytes_at_once = hsize_t{64} << 20;

class Copy {
  public:
    Copy(const std::string& from, const std::string& to)
        : doing_("writing " + to),
          from_(
              checked(H5Fopen(from.c_str(), H5F_ACC_RDONLY, unlocked_access(from).get()), "reading " + from)),
          to_(checked(H5Fopen(to.c_str(), H5F_ACC_RDWR, unlocked_access(to).get()), doing_)) {}

    /// The first rows of a dataset below /VTKHDF, as they are stored.
    void rows(const std::string& name, hsize_t rows) const {
        const auto open = [&](const H5File& file) {
            return H5Dataset(checked(H5Dopen2(file.get(), ("/VTKHDF/" + name).c_str(), H5P_DEFAULT),
                                     doing_ + ": " + name));
        };
        const H5Dataset source = open(from_), target = open(to_);
        const H5Type type(checked(H5Dget_type(source.get()), doing_));
        const H5Space in_source(checked(H5Dget_space(source.get()), doing_)),
            in_target(checked(H5Dget_space(target.get()), doing_));
        std::vector<hsize_t> block(
            static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(in_source.get()), doing_)));
        checked(H5Sget_simple_extent_dims(in_source.get(), block.data(), nullptr), doing_);
        hsize_t of_row = H5Tget_size(type.get());
        for (std::size_t d = 1; d < block.size(); ++d) of_row *= block[d];
        const auto most = std::max<hsize_t>(1, bytes_at_once / of_row);
        std::vector<std::byte> values(static_cast<std::size_t>(std::min(rows, most) * of_row));
        std::vector<hsize_t> start(block.size(), 0);
        for (; start[0] < rows; start[0] += block[0]) {
            block[0] = std::min(rows - start[0], most);
            for (const auto* space : {&in_source, &in_target})
                checked(H5Sselect_hyperslab(space->get(), H5S_SELECT_SET, start.data(), nullptr, block.data(),
                                            nullptr),
                        doing_);
            const H5Space memory(
                checked(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), doing_));
            checked(
                H5Dread(source.get(), type.get(), memory.get(), in_source.get(), H5P_DEFAULT, values.data()),
                doing_);
            checked(
                H5Dwrite(target.get(), type.get(), memory.get(), in_target.get(), H5P_DEFAULT, values.data()),
                doing_);
        }
    }

    [[nodiscard]] std::vector<double> times(std::int64_t frames) const {
        const H5Dataset source(checked(H5Dopen2(from_.get(), "/VTKHDF/Steps/Values", H5P_DEFAULT), doing_));
        const H5Space space(checked(H5Dget_space(source.get()), doing_));
        std::vector<double> values(
            static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space.get()), doing_)));
        checked(H5Dread(source.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                doing_);
        values.resize(static_cast<std::size_t>(frames));
        return values;
    }

    void finish() { close(to_, doing_); }

  private:
    std::string doing_;
    H5File from_, to_;
};

}  // namespace

void copy_results(const std::string& from, const std::string& to, const ResultsSetup& setup,
                  std::int64_t frames) {
    const PartSizes sizes(setup);
    const auto size = [](std::int64_t count) { return static_cast<hsize_t>(count); };
    const auto points = size(frames * sizes.all_points()), cells = size(frames * sizes.all_cells());
    Copy copy(from, to);
    copy.rows("Connectivity", size(4 * sizes.all_cells()));
    copy.rows("Offsets", size(sizes.all_cells() + sizes.parts()));
    copy.rows("Types", size(sizes.all_cells()));
    copy.rows(std::string("CellData/") + ply_name, size(sizes.all_cells()));
    copy.rows("Points", points);
    for (const auto& array : setup.layout.point_data) copy.rows("PointData/" + array.name, points);
    for (const auto& array : setup.layout.cell_data) copy.rows("CellData/" + array.name, cells);
    copy.rows(std::string("CellData/") + hidden_name, cells);
    const auto times = copy.times(frames);
    copy.finish();
    FramePublisher publisher(to);
    for (std::size_t k = 0; k < times.size(); ++k) publisher.publish(static_cast<std::int64_t>(k), times[k]);
}

}  // namespace weavefront::io
