/// A checkpoint. The first byte says which: 0 the bytes that follow; 1 a good one that was damaged; 2 a good
/// one whose objects are replaced by others, sealed again.

#include "weavefront/io/checkpoint.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checkpoint_edits.hpp"
#include "choices.hpp"
#include "file_checksum.hpp"
#include "hdf5_handle.hpp"
#include "require.hpp"
#include "scratch_file.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/state/values.hpp"

namespace weavefront::fuzz {
namespace {

constexpr std::size_t seal_bytes = 32;

std::unique_ptr<parallel::Environment> environment;
std::unique_ptr<parallel::Communicator> comm;
std::vector<std::uint8_t> good_checkpoint;

/// Two tables, one of them with columns of as many values an item and of any number of values.
io::CheckpointContent good_content() {
    io::CheckpointContent content{
        .scene = "title: x\n", .version = "1", .values = {}, .nodes = {}, .elements = {}};
    content.values = {{"time", std::vector{0.25}}, {"steps", std::vector{std::int64_t{7}}}, {"text", "abc"}};
    content.nodes = {{0, 1, 2}, {{"x", {2, 2, 2}, {0, 1, 2, 3, 4, 5}}}};
    content.elements = {{0, 1}, {{"points", {0, 3}, {1, 2, 3}}}};
    content.all_nodes = 3, content.all_elements = 2;
    return content;
}

void write_good_checkpoint() {
    std::string folder = (std::filesystem::temp_directory_path() / "weavefront_fuzz.XXXXXX").string();
    require(::mkdtemp(folder.data()) != nullptr, "a folder can be made", folder);
    const auto path = std::filesystem::path(folder) / "checkpoint.h5";
    io::write_checkpoint(path, good_content(), *comm);
    std::ifstream file(path, std::ios::binary);
    good_checkpoint.assign(std::istreambuf_iterator<char>(file), {});
    std::filesystem::remove_all(folder);
}

/// Takes all that readers of a state ask for.
template <class Content>
void take(state::ValueReader& reader, const std::string& name) {
    Content content{};
    try {
        reader(name, content);
    } catch (const state::Mismatch&) {
    }
}

void take_items(state::Table table) {
    try {
        state::ColumnReader reader(table);
        for (std::size_t item = 0; item < table.ids.size(); ++item) {
            reader.start(item);
            for (const char* name : {"x", "points"}) {
                double value = 0;
                for (auto left = reader.size(name, 0); left > 0; --left) reader(name, value);
            }
        }
        reader.finish();
    } catch (const state::Mismatch&) {
    }
}

/// Whether the file was taken for a checkpoint.
bool read(const ScratchFile& file) {
    try {
        const io::Checkpoint checkpoint(file.path(), *comm);
        state::ValueReader values(checkpoint.values(), *comm);
        for (const auto& value : checkpoint.values()) {
            take<double>(values, value.name);
            take<std::int64_t>(values, value.name);
            take<std::string>(values, value.name);
            take<std::optional<double>>(values, value.name);
            take<std::vector<double>>(values, value.name);
            take<std::vector<std::int64_t>>(values, value.name);
        }
        const std::vector<std::int64_t> nodes{0, 2}, elements{0, 1};
        take_items(checkpoint.nodes(nodes));
        take_items(checkpoint.elements(elements));
        return true;
    } catch (const io::FileError& refusal) {
        require(std::string_view(refusal.what()).find(file.path().string()) != std::string_view::npos,
                "messages name the file", refusal.what());
        return false;
    }
}

/// The good checkpoint with some bytes replaced by others, or cut.
std::vector<std::uint8_t> damaged(Choices& choices) {
    auto bytes = good_checkpoint;
    bytes.resize(bytes.size() - choices.byte());
    while (choices.any()) {
        const std::size_t at = std::size_t{choices.byte()} << 8 | choices.byte();
        const auto patch = choices.take(1 + choices.below(16));
        if (at + patch.size() <= bytes.size())
            std::ranges::copy(patch, bytes.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return bytes;
}

void read_any(std::span<const std::uint8_t> bytes) {
    const ScratchFile file(std::as_bytes(bytes));
    read(file);
}

void read_damaged(Choices& choices) {
    const auto bytes = damaged(choices);
    const ScratchFile file(std::as_bytes(std::span(bytes)));
    require(read(file) == (bytes == good_checkpoint), "damage is noticed");
}

void read_edited(Choices& choices) {
    const auto unsealed = std::span(good_checkpoint).first(good_checkpoint.size() - seal_bytes);
    const ScratchFile file(std::as_bytes(unsealed));
    {
        const io::QuietHdf5 quiet;
        const auto access = io::unlocked_access("fuzz");
        const io::H5File open(H5Fopen(file.path().c_str(), H5F_ACC_RDWR, access.get()));
        for (int edits = 0; edits < 4 && choices.any(); ++edits) edit_checkpoint(open.get(), choices);
    }
    io::seal_file(file.path(), *comm);
    read(file);
}

}  // namespace
}  // namespace weavefront::fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    using namespace weavefront;
    fuzz::environment = std::make_unique<parallel::Environment>(argc, argv);
    fuzz::comm = std::make_unique<parallel::Communicator>(MPI_COMM_SELF);
    fuzz::write_good_checkpoint();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace weavefront;
    fuzz::Choices choices({data, size});
    const auto kind = choices.below(3);
    if (kind == 0) fuzz::read_any(choices.rest());
    if (kind == 1) fuzz::read_damaged(choices);
    if (kind == 2) fuzz::read_edited(choices);
    return 0;
}
