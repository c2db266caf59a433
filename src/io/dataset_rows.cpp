#include "dataset_rows.hpp"

#include <algorithm>
#include <stdexcept>

namespace weavefront::io {

DatasetRows::DatasetRows(const H5File& file, const std::string& path, const std::string& name, hid_t memory) {
    const auto doing = "opening " + path + ": " + name;
    const H5Dataset dataset(checked(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), doing));
    const H5Type type(checked(H5Dget_type(dataset.get()), doing));
    if (H5Tequal(type.get(), memory) <= 0) throw std::logic_error(doing + ": the type is another in memory");
    const H5Space space(checked(H5Dget_space(dataset.get()), doing));
    std::vector<hsize_t> rows(
        static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space.get()), doing)));
    checked(H5Sget_simple_extent_dims(space.get(), rows.data(), nullptr), doing);
    row_bytes_ = static_cast<std::int64_t>(H5Tget_size(type.get()));
    std::int64_t values = 1;
    for (const auto extent : rows) values *= static_cast<std::int64_t>(extent);
    for (std::size_t i = 1; i < rows.size(); ++i) row_bytes_ *= static_cast<std::int64_t>(rows[i]);
    const auto at = H5Dget_offset(dataset.get());
    if (at == HADDR_UNDEF && values > 0) throw std::logic_error(doing + ": the dataset has no place yet");
    if (values > 0) offset_ = static_cast<std::int64_t>(at);
}

void DatasetRows::copy(const Descriptor& from, const DatasetRows& source, const Descriptor& to,
                       std::int64_t rows) const {
    if (source.row_bytes_ != row_bytes_) throw std::logic_error("the rows of the datasets differ");
    constexpr std::int64_t at_once = 1 << 20;
    std::vector<std::byte> bytes(at_once);
    for (std::int64_t at = 0, end = rows * row_bytes_; at < end; at += at_once) {
        const auto part = std::span(bytes).first(static_cast<std::size_t>(std::min(at_once, end - at)));
        from.read(part, source.offset_ + at);
        to.write(part, offset_ + at);
    }
}

}  // namespace weavefront::io
