#include "results_skeleton.hpp"

#include <fcntl.h>

#include <numeric>
#include <span>

#include "descriptor.hpp"
#include "file_in_memory.hpp"
#include "hdf5_group_writer.hpp"

namespace weavefront::io {

namespace {

hsize_t extent(std::int64_t n) { return static_cast<hsize_t>(n); }

// What is the same in every frame, and the rows that each array of a frame takes.
class Skeleton {
  public:
    Skeleton(const std::string& path, hid_t file, const ResultsSetup& setup)
        : path_(path), file_(file), setup_(setup), sizes_(setup) {}

    void create() const {
        const GroupWriter root(path_, file_, "VTKHDF");
        const std::vector<std::int32_t> version{2, 0};
        root.attribute<std::int32_t>("Version", version, H5T_STD_I32LE);
        root.attribute("Type", "UnstructuredGrid");
        create_geometry(root);

        const GroupWriter steps(path_, root.get(), "Steps");
        create_steps(steps);
        create_data(root, steps, "Point", setup_.layout.point_data, sizes_.all_points());
        create_data(root, steps, "Cell", setup_.layout.cell_data, sizes_.all_cells());
        create_origin();
    }

  private:
    /// What made the file: program and scene.
    void create_origin() const {
        const GroupWriter root = GroupWriter::root(path_, file_);
        root.attribute("version", setup_.version);
        const auto& scene = setup_.scene;
        root.dataset("scene", H5T_STD_U8LE, {scene.size()},
                     std::span(reinterpret_cast<const std::uint8_t*>(scene.data()), scene.size()));
    }

    void create_geometry(const GroupWriter& root) const {
        std::vector<std::int64_t> ids;
        for (const auto cells : sizes_.cells) ids.push_back(4 * cells);
        const Extents parts{extent(sizes_.parts())};
        root.dataset<std::int64_t>("NumberOfPoints", H5T_STD_I64LE, parts, sizes_.points);
        root.dataset<std::int64_t>("NumberOfCells", H5T_STD_I64LE, parts, sizes_.cells);
        root.dataset<std::int64_t>("NumberOfConnectivityIds", H5T_STD_I64LE, parts, ids);
        const auto cells = extent(sizes_.all_cells());
        (void)root.dataset("Points", H5T_IEEE_F64LE, {frames() * extent(sizes_.all_points()), 3});
        (void)root.dataset("Connectivity", H5T_STD_I64LE, {4 * cells});
        (void)root.dataset("Offsets", H5T_STD_I64LE, {cells + parts[0]});
        (void)root.dataset("Types", H5T_STD_U8LE, {cells});
    }

    void create_steps(const GroupWriter& steps) const {
        const std::vector<std::int32_t> none{0};
        steps.attribute<std::int32_t>("NSteps", none, H5T_STD_I32LE);
        // The reader of VTK copies all of Values into room for NSteps times: this one dataset grows with
        // NSteps.
        steps.growing_dataset("Values", H5T_IEEE_F64LE, frames());
        steps.dataset<std::int64_t>("NumberOfParts", H5T_STD_I64LE, {frames()}, multiples(0, sizes_.parts()));
        steps.dataset<std::int64_t>("PartOffsets", H5T_STD_I64LE, {frames()}, multiples(0));
        steps.dataset<std::int64_t>("PointOffsets", H5T_STD_I64LE, {frames()},
                                    multiples(sizes_.all_points()));
        steps.dataset<std::int64_t>("CellOffsets", H5T_STD_I64LE, {frames(), 1}, multiples(0));
        steps.dataset<std::int64_t>("ConnectivityIdOffsets", H5T_STD_I64LE, {frames(), 1}, multiples(0));
    }

    void create_data(const GroupWriter& root, const GroupWriter& steps, const std::string& kind,
                     const std::vector<Array>& arrays, std::int64_t rows) const {
        const GroupWriter data(path_, root.get(), kind + "Data");
        const GroupWriter offsets(path_, steps.get(), kind + "DataOffsets");
        const auto every_frame = [&](const std::string& name, int components, hid_t type) {
            Extents extents{frames() * extent(rows)};
            if (components > 1) extents.push_back(extent(components));
            (void)data.dataset(name, type, extents);
            offsets.dataset<std::int64_t>(name, H5T_STD_I64LE, {frames()}, multiples(rows));
        };
        for (const auto& array : arrays)
            every_frame(array.name, array.components, array.integer ? H5T_STD_I8LE : H5T_IEEE_F64LE);
        if (kind != "Cell") return;
        every_frame(hidden_name, 1, H5T_STD_U8LE);
        (void)data.dataset(ply_name, H5T_STD_I32LE, {extent(rows)});
        offsets.dataset<std::int64_t>(ply_name, H5T_STD_I64LE, {frames()}, multiples(0));
    }

    [[nodiscard]] hsize_t frames() const { return extent(setup_.max_frames); }

    // start + k step for every frame k
    [[nodiscard]] std::vector<std::int64_t> multiples(std::int64_t step, std::int64_t start = 0) const {
        std::vector<std::int64_t> values(static_cast<std::size_t>(setup_.max_frames));
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = start + static_cast<std::int64_t>(k) * step;
        return values;
    }

    std::string path_;
    hid_t file_;
    const ResultsSetup& setup_;
    PartSizes sizes_;
};

}  // namespace

PartSizes::PartSizes(const ResultsSetup& setup)
    : points{setup.topology.nodes}, cells{setup.topology.elements} {
    if (setup.surface.quads.empty()) return;
    points.push_back(static_cast<std::int64_t>(setup.surface.points.size()));
    cells.push_back(static_cast<std::int64_t>(setup.surface.quads.size()));
}

std::int64_t PartSizes::all_points() const { return std::reduce(points.begin(), points.end()); }

std::int64_t PartSizes::all_cells() const { return std::reduce(cells.begin(), cells.end()); }

double results_bytes(const ResultsSetup& setup, std::int64_t frames) {
    const PartSizes sizes(setup);
    const auto of_arrays = [](const std::vector<Array>& arrays) {
        double bytes = 0;
        for (const auto& array : arrays)
            bytes +=
                array.components * static_cast<double>(array.integer ? sizeof(std::int8_t) : sizeof(double));
        return bytes;
    };
    constexpr double of_point = 3 * sizeof(double), of_cell_in_frame = 1;  // Points; vtkGhostType
    constexpr double of_cell =
        5 * sizeof(std::int64_t) + 1 + sizeof(std::int32_t);  // Connectivity and Offsets; Types; ply
    const auto points = static_cast<double>(sizes.all_points()),
               cells = static_cast<double>(sizes.all_cells());
    const double frame = points * (of_point + of_arrays(setup.layout.point_data)) +
                         cells * (of_cell_in_frame + of_arrays(setup.layout.cell_data));
    return static_cast<double>(frames) * frame + cells * of_cell;
}

void create_results_skeleton(const std::string& path, const ResultsSetup& setup) {
    const Descriptor on_disk(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    const FileInMemory memory(path);
    auto file = memory.create_hdf5();
    Skeleton(path, file.get(), setup).create();
    close(file, "closing " + path);
    memory.copy_to(on_disk);
}

}  // namespace weavefront::io
