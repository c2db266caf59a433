#include "hdf5_collective.hpp"

#include <vector>

namespace weavefront::io {

H5File open_by_all(const std::string& path, const parallel::Communicator& comm) {
    const H5Properties access(checked(H5Pcreate(H5P_FILE_ACCESS), path));
    checked(H5Pset_fapl_mpio(access.get(), comm.get(), MPI_INFO_NULL), path);
    return H5File(checked(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()), "opening " + path));
}

void write_rows(const H5Dataset& dataset, std::int64_t first, std::size_t length, hid_t memory_type,
                const void* values, const std::string& doing) {
    const H5Space file(checked(H5Dget_space(dataset.get()), doing));
    std::vector<hsize_t> rows(
        static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(file.get()), doing)));
    checked(H5Sget_simple_extent_dims(file.get(), rows.data(), nullptr), doing);
    const hsize_t flat = length;
    const H5Space memory(checked(H5Screate_simple(1, &flat, nullptr), doing));
    if (length == 0) {
        checked(H5Sselect_none(file.get()), doing);
        checked(H5Sselect_none(memory.get()), doing);
    } else {
        std::vector<hsize_t> start(rows.size(), 0);
        start[0] = static_cast<hsize_t>(first);
        rows[0] = flat;
        for (std::size_t i = 1; i < rows.size(); ++i) rows[0] /= rows[i];
        checked(H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, start.data(), nullptr, rows.data(), nullptr),
                doing);
    }
    const H5Properties transfer(checked(H5Pcreate(H5P_DATASET_XFER), doing));
    checked(H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE), doing);
    checked(H5Dwrite(dataset.get(), memory_type, memory.get(), file.get(), transfer.get(), values), doing);
}

}  // namespace weavefront::io
