#include "checkpoint_edits.hpp"

#include <array>
#include <string>
#include <vector>

#include "hdf5_handle.hpp"

namespace weavefront::fuzz {
namespace {

constexpr std::array objects{"/",
                             "/scene",
                             "/values",
                             "/values/time",
                             "/values/steps",
                             "/values/text",
                             "/nodes",
                             "/nodes/x",
                             "/nodes/x/values",
                             "/nodes/x/counts",
                             "/elements",
                             "/elements/points",
                             "/elements/points/values",
                             "/elements/points/counts",
                             "/elements/points/other",
                             "/elements/other"};
constexpr std::array attributes{"format", "version", "items", "values_per_item", "xxh3"};

io::H5Type type_of(Choices& choices) {
    switch (choices.below(8)) {
        case 0:
            return io::H5Type(H5Tcopy(H5T_IEEE_F64LE));
        case 1:
            return io::H5Type(H5Tcopy(H5T_STD_I64LE));
        case 2:
            return io::H5Type(H5Tcopy(H5T_STD_I32LE));
        case 3:
            return io::H5Type(H5Tcopy(H5T_STD_U8LE));
        case 4:
            return io::H5Type(H5Tcopy(H5T_IEEE_F32BE));
        case 5:
            return io::H5Type(H5Tcreate(H5T_OPAQUE, 1 + choices.below(16)));
        default:
            break;
    }
    io::H5Type text(H5Tcopy(H5T_C_S1));
    const auto length = choices.below(64);
    H5Tset_size(text.get(), length == 0 ? H5T_VARIABLE : length);
    return text;
}

/// A scalar, nothing, or up to two dimensions of any extent.
io::H5Space space_of(Choices& choices) {
    const auto rank = choices.below(4);
    if (rank == 0) return io::H5Space(H5Screate(H5S_SCALAR));
    if (rank == 3) return io::H5Space(H5Screate(H5S_NULL));
    std::array<hsize_t, 2> extents{};
    for (auto& extent : extents) extent = static_cast<hsize_t>(choices.number());
    return io::H5Space(H5Screate_simple(static_cast<int>(rank), extents.data(), nullptr));
}

/// The content of a small object in bytes of the input.
std::vector<std::uint8_t> content_of(hid_t type, hid_t space, Choices& choices) {
    constexpr hssize_t most = 1000;
    const auto count = H5Sget_simple_extent_npoints(space);
    if (count < 0 || count > most || H5Tis_variable_str(type) > 0) return {};
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count) * H5Tget_size(type));
    std::ranges::copy(choices.take(bytes.size()), bytes.begin());
    return bytes;
}

void replace_attribute(hid_t object, const char* name, Choices& choices) {
    const auto type = type_of(choices);
    const auto space = space_of(choices);
    H5Adelete(object, name);
    const io::H5Attribute made(H5Acreate2(object, name, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
    const auto content = content_of(type.get(), space.get(), choices);
    if (!content.empty()) H5Awrite(made.get(), type.get(), content.data());
}

/// Another number in an attribute that stays an integer: it comes further than most other replacements.
void renumber_attribute(hid_t object, const char* name, Choices& choices) {
    const io::H5Attribute found(H5Aopen(object, name, H5P_DEFAULT));
    const io::H5Space space(H5Aget_space(found.get()));
    if (H5Sget_simple_extent_npoints(space.get()) != 1) return;
    const auto value = choices.number();
    H5Awrite(found.get(), H5T_NATIVE_INT64, &value);
}

void replace_dataset(hid_t file, const char* path, Choices& choices) {
    const auto type = type_of(choices);
    const auto space = space_of(choices);
    H5Ldelete(file, path, H5P_DEFAULT);
    const io::H5Dataset made(
        H5Dcreate2(file, path, type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    const auto content = content_of(type.get(), space.get(), choices);
    if (!content.empty()) H5Dwrite(made.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
}

/// Other values in a dataset of the same type and extents.
void rewrite_dataset(hid_t file, const char* path, Choices& choices) {
    const io::H5Dataset found(H5Dopen2(file, path, H5P_DEFAULT));
    const io::H5Type type(H5Dget_type(found.get()));
    const io::H5Space space(H5Dget_space(found.get()));
    const auto content = content_of(type.get(), space.get(), choices);
    if (!content.empty()) H5Dwrite(found.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, content.data());
}

void link_elsewhere(hid_t file, const char* from, const char* to, bool soft) {
    H5Ldelete(file, to, H5P_DEFAULT);
    if (soft)
        H5Lcreate_soft(from, file, to, H5P_DEFAULT, H5P_DEFAULT);
    else
        H5Lcreate_hard(file, from, file, to, H5P_DEFAULT, H5P_DEFAULT);
}

}  // namespace

void edit_checkpoint(hid_t file, Choices& choices) {
    const auto* path = choices.of(objects);
    switch (choices.below(7)) {
        case 0:
        case 1: {
            const io::Hdf5Handle<H5Oclose> object(H5Oopen(file, path, H5P_DEFAULT));
            const auto* name = choices.of(attributes);
            return choices.below(2) == 0 ? replace_attribute(object.get(), name, choices)
                                         : renumber_attribute(object.get(), name, choices);
        }
        case 2:
            return replace_dataset(file, path, choices);
        case 3:
            return rewrite_dataset(file, path, choices);
        case 4:
            H5Ldelete(file, path, H5P_DEFAULT);
            return;
        case 5: {
            H5Ldelete(file, path, H5P_DEFAULT);
            const io::H5Group made(H5Gcreate2(file, path, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
            return;
        }
        default:
            return link_elsewhere(file, choices.of(objects), path, choices.below(2) == 0);
    }
}

}  // namespace weavefront::fuzz
