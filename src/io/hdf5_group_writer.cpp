#include "hdf5_group_writer.hpp"

#include <algorithm>

namespace weavefront::io {

H5Properties creation_properties(hid_t kind, const std::string& doing) {
    H5Properties properties(checked(H5Pcreate(kind), doing));
    checked(H5Pset_obj_track_times(properties.get(), false), doing);
    return properties;
}

GroupWriter::GroupWriter(const std::string& file, hid_t parent, const std::string& name)
    : where_(file + ": " + name) {
    const H5Properties properties = creation_properties(H5P_GROUP_CREATE, where_);
    group_ = H5Group(checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                             "creating " + where_));
}

GroupWriter GroupWriter::root(const std::string& file, hid_t id) {
    return {file + ": ", H5Group(checked(H5Gopen2(id, "/", H5P_DEFAULT), "opening " + file))};
}

void GroupWriter::attribute(const std::string& name, std::size_t count, hid_t file_type, hid_t memory_type,
                            const void* values) const {
    const std::string doing = "writing " + where_ + "/@" + name;
    const hsize_t extent = count;
    const H5Space space(
        checked(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr), doing));
    const H5Attribute made(
        checked(H5Acreate2(get(), name.c_str(), file_type, space.get(), H5P_DEFAULT, H5P_DEFAULT), doing));
    checked(H5Awrite(made.get(), memory_type, values), doing);
}

void GroupWriter::attribute(const std::string& name, const std::string& text) const {
    const std::string doing = "writing " + where_ + "/@" + name;
    const H5Type type(checked(H5Tcopy(H5T_C_S1), doing));
    checked(H5Tset_size(type.get(), std::max<std::size_t>(text.size(), 1)), doing);
    checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), doing);
    attribute(name, 1, type.get(), type.get(), text.c_str());
}

H5Dataset GroupWriter::dataset(const std::string& name, hid_t file_type, const Extents& extents) const {
    const H5Properties properties = creation_properties(H5P_DATASET_CREATE, where_);
    checked(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY), where_);
    checked(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER), where_);
    const H5Space space(
        checked(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), where_));
    return create(name, file_type, space, properties);
}

void GroupWriter::growing_dataset(const std::string& name, hid_t file_type, hsize_t most) const {
    const H5Properties properties = creation_properties(H5P_DATASET_CREATE, where_);
    checked(H5Pset_chunk(properties.get(), 1, &most), where_);
    checked(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY), where_);
    checked(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_ALLOC), where_);  // takes its room on the disk
    const hsize_t one = 1;
    const H5Space space(checked(H5Screate_simple(1, &one, &most), where_));
    (void)create(name, file_type, space, properties);
}

H5Dataset GroupWriter::create(const std::string& name, hid_t file_type, const H5Space& space,
                              const H5Properties& properties) const {
    return H5Dataset(checked(
        H5Dcreate2(get(), name.c_str(), file_type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
        "creating " + where_ + "/" + name));
}

}  // namespace weavefront::io
