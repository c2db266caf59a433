#include "results_topology.hpp"

#include <fcntl.h>

#include <span>

#include "dataset_rows.hpp"
#include "results_skeleton.hpp"

namespace weavefront::io {

namespace {

constexpr std::uint8_t vtk_quad = 9;  // VTK_QUAD

std::span<const std::int64_t> flat(const std::vector<std::array<std::int64_t, 4>>& quads) {
    return {quads.empty() ? nullptr : quads.front().data(), 4 * quads.size()};
}

std::vector<std::int64_t> multiples_of_four(std::int64_t first, std::int64_t count) {
    std::vector<std::int64_t> values;
    for (std::int64_t i = 0; i < count; ++i) values.push_back(4 * (first + i));
    return values;
}

// Offsets after the fabric's elements: each part has one entry more than cells, and starts at 0.
std::vector<std::int64_t> closing_offsets(const PartSizes& sizes) {
    std::vector<std::int64_t> values{4 * sizes.cells[0]};
    if (sizes.parts() == 1) return values;
    const auto surface = multiples_of_four(0, sizes.cells[1] + 1);
    values.insert(values.end(), surface.begin(), surface.end());
    return values;
}

}  // namespace

void write_topology(const std::string& path, const ResultsSetup& setup, const BlockExchange& elements,
                    const parallel::Communicator& comm) {
    const Descriptor to(path, O_WRONLY);
    const auto file = open_to_read(path, "opening " + path);
    const auto write = [&]<class T>(const std::string& name, std::int64_t first, std::vector<T> of_fabric,
                                    const std::vector<T>& after) {
        const DatasetRows rows(file, path, "/VTKHDF/" + name, native_type<T>());
        rows.write(to, first, with_rows_of_last_rank(comm, std::move(of_fabric), after));
    };
    const auto surface = flat(setup.surface.quads);
    const auto quads = setup.surface.quads.size();
    const std::vector<std::uint8_t> types(static_cast<std::size_t>(elements.count()), vtk_quad);
    write("Connectivity", 4 * elements.first(),
          elements.to_block<std::int64_t>(flat(setup.topology.connectivity), 4),
          std::vector<std::int64_t>(surface.begin(), surface.end()));
    write("Offsets", elements.first(), multiples_of_four(elements.first(), elements.count()),
          closing_offsets(PartSizes(setup)));
    write("Types", elements.first(), types, std::vector<std::uint8_t>(quads, vtk_quad));
    write("CellData/ply", elements.first(), elements.to_block<std::int32_t>(setup.topology.ply),
          std::vector<std::int32_t>(quads, 0));
}

}  // namespace weavefront::io
