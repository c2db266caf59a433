#include "weavefront/io/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <numeric>
#include <system_error>
#include <variant>

#include "agreement.hpp"
#include "checkpoint_blocks.hpp"
#include "dataset_rows.hpp"
#include "descriptor.hpp"
#include "file_checksum.hpp"
#include "file_in_memory.hpp"
#include "hdf5_group_writer.hpp"
#include "hdf5_reader.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

namespace {

// Raised when a program could read the files of before wrongly.
constexpr std::int64_t format_number = 1;

hsize_t extent(std::int64_t count) { return static_cast<hsize_t>(count); }

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// One table of the file under way: where its columns go and what they hold.
struct TableBlocks {
    std::string name;
    Blocks blocks;
    std::vector<ColumnBlock> columns;
};

TableBlocks blocks_of(const std::string& name, state::Table& table, std::int64_t total,
                      const parallel::Communicator& comm) {
    const Blocks blocks{total, items_of_grain, comm.size()};
    return {name, blocks, column_blocks(table, blocks, comm)};
}

void create_values(const std::string& path, const GroupWriter& root, const state::Values& values) {
    const GroupWriter group(path, root.get(), "values");
    for (const auto& value : values) {
        if (const auto* numbers = std::get_if<std::vector<double>>(&value.content))
            group.dataset<double>(value.name, H5T_IEEE_F64LE, {numbers->size()}, *numbers);
        else if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&value.content))
            group.dataset<std::int64_t>(value.name, H5T_STD_I64LE, {integers->size()}, *integers);
        else
            group.dataset<std::uint8_t>(value.name, H5T_STD_U8LE,
                                        {std::get<std::string>(value.content).size()},
                                        bytes_of(std::get<std::string>(value.content)));
    }
}

/// Everything but the values of the columns, by one process.
void create_structure(const H5File& file, const std::string& path, const CheckpointContent& content,
                      const std::vector<TableBlocks>& tables) {
    const GroupWriter root = GroupWriter::root(path, file.get());
    const auto number = [](const GroupWriter& group, const std::string& name, std::int64_t value) {
        group.attribute<std::int64_t>(name, std::span(&value, 1), H5T_STD_I64LE);
    };
    number(root, "format", format_number);
    root.attribute("version", content.version);
    root.dataset<std::uint8_t>("scene", H5T_STD_U8LE, {content.scene.size()}, bytes_of(content.scene));
    create_values(path, root, content.values);
    for (const auto& table : tables) {
        const GroupWriter group(path, root.get(), table.name);
        number(group, "items", table.blocks.total);
        for (const auto& column : table.columns) {
            const GroupWriter of_column(path, group.get(), column.name);
            number(of_column, "values_per_item", column.per_item);
            number(of_column, "xxh3", static_cast<std::int64_t>(column.checksum));
            (void)of_column.dataset("values", H5T_IEEE_F64LE, {extent(column.all_values)});
            if (column.per_item < 0)
                (void)of_column.dataset("counts", H5T_STD_I32LE, {extent(table.blocks.total)});
        }
    }
}

H5Dataset open_dataset(const H5File& file, const std::string& path, const std::string& name) {
    return H5Dataset(
        checked(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), "reading " + path + ": " + name));
}

/// This rank's blocks of the columns.
void write_columns(const std::string& path, const std::vector<TableBlocks>& tables, int rank) {
    const Descriptor to(path, O_WRONLY);
    const auto file = open_to_read(path, "reading " + path);
    for (const auto& table : tables)
        for (const auto& column : table.columns) {
            const auto name = "/" + table.name + "/" + column.name;
            DatasetRows(file, path, name + "/values", native_type<double>())
                .write(to, column.first_value, column.block.values);
            if (column.per_item < 0)
                DatasetRows(file, path, name + "/counts", native_type<std::int32_t>())
                    .write(to, table.blocks.begin(rank), column.block.counts);
        }
}

/// Number of values in a dataset of one dimension.
std::int64_t rows_of(const H5Dataset& dataset, const std::string& doing) {
    const auto [rows, columns] = extents_of(dataset, doing);
    if (columns != 1)
        throw FileError(fmt::format("{} failed: it has {} columns, allowed is 1", doing, columns));
    return rows;
}

/// Compares what the file holds with what it should. @throws FileError
void require_written(const std::string& path, const std::vector<TableBlocks>& tables, int rank) {
    const auto file = open_to_read(path, "reading " + path);
    for (const auto& table : tables)
        for (const auto& column : table.columns) {
            const auto name = "/" + table.name + "/" + column.name;
            const auto& [counts, values] = column.block;
            const auto doing = "reading " + path + ": " + name;
            const auto read =
                read_rows<double>(open_dataset(file, path, name + "/values"), column.first_value,
                                  static_cast<std::int64_t>(values.size()), doing);
            const bool same = values.empty() ||
                              std::memcmp(read.data(), values.data(), values.size() * sizeof(double)) == 0;
            const bool same_counts =
                column.per_item >= 0 ||
                read_rows<std::int32_t>(open_dataset(file, path, name + "/counts"), table.blocks.begin(rank),
                                        static_cast<std::int64_t>(counts.size()), doing) == counts;
            if (!same || !same_counts)
                throw FileError(fmt::format("{} does not hold what was written to {}", path, name));
        }
}

/// Bytes that the file takes, at most.
std::int64_t most_bytes(const CheckpointContent& content, const std::vector<TableBlocks>& tables) {
    constexpr std::int64_t of_object = 4096;  // of HDF5's structure
    const auto size = [](const auto& values) { return static_cast<std::int64_t>(values.size()); };
    std::int64_t bytes = of_object + size(content.scene), objects = 4 + size(content.values);
    for (const auto& value : content.values)
        std::visit([&](const auto& values) { bytes += size(values) * std::int64_t{sizeof(values[0])}; },
                   value.content);
    for (const auto& table : tables) {
        objects += 1 + 3 * size(table.columns);
        for (const auto& column : table.columns)
            bytes += std::int64_t{sizeof(double)} * column.all_values +
                     (column.per_item < 0 ? std::int64_t{sizeof(std::int32_t)} * table.blocks.total : 0);
    }
    return bytes + of_object * objects;
}

/// Creates the file with room on the disk for all of it.
void create_with_room(const std::string& path, const CheckpointContent& content,
                      const std::vector<TableBlocks>& tables) {
    const Descriptor file(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    file.reserve(most_bytes(content, tables));
    const FileInMemory memory(path);
    auto structure = memory.create_hdf5();
    create_structure(structure, path, content, tables);
    close(structure, "closing " + path);
    memory.copy_to(file);
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0)
        throw FileError(fmt::format("{} cannot be renamed to {}: {}", from.string(), to.string(),
                                    std::generic_category().message(errno)));
}

/// Waits until renamed files have their names on the disk.
void sync_folder_of(const std::filesystem::path& path) {
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int cause = descriptor >= 0 && ::fsync(descriptor) == 0 ? 0 : errno;
    if (descriptor >= 0) ::close(descriptor);
    if (cause != 0 && cause != EINVAL)  // of file systems that know no such call
        throw FileError(
            fmt::format("{} cannot be flushed: {}", folder.string(), std::generic_category().message(cause)));
}

}  // namespace

void adopt_checkpoint(const std::filesystem::path& from, const std::filesystem::path& path,
                      const parallel::Communicator& comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        if (std::filesystem::exists(path) && std::filesystem::equivalent(from, path)) return;
        require_regular_or_missing(path);
        if (const auto previous = previous_checkpoint(path);
            std::filesystem::exists(previous) && std::filesystem::equivalent(from, previous)) {
            rename_file(previous, path);
        } else {
            const auto unfinished = temporary_name(path);
            ::unlink(unfinished.c_str());
            std::filesystem::copy_file(from, unfinished);
            rename_file(unfinished, path);
        }
        sync_folder_of(path);
    });
    agreement.settle<FileError>();
}

std::filesystem::path previous_checkpoint(const std::filesystem::path& path) {
    return path.parent_path() / (path.stem().string() + ".previous" + path.extension().string());
}

void write_checkpoint(const std::filesystem::path& path, CheckpointContent content,
                      const parallel::Communicator& comm) {
    const QuietHdf5 quiet;
    const auto unfinished = temporary_name(path).string();
    Agreement agreement(comm);
    try {
        const std::vector<TableBlocks> tables{
            blocks_of("nodes", content.nodes, content.all_nodes, comm),
            blocks_of("elements", content.elements, content.all_elements, comm)};
        agreement.attempt_on_root([&] {
            require_regular_or_missing(path);
            ::unlink(unfinished.c_str());  // of a run that was killed
            create_with_room(unfinished, content, tables);
        });
        agreement.settle<FileError>();
        agreement.attempt([&] { write_columns(unfinished, tables, comm.rank()); });
        agreement.settle<FileError>();
        agreement.attempt([&] { require_written(unfinished, tables, comm.rank()); });
        agreement.settle<FileError>();
        seal_file(unfinished, comm);
        agreement.attempt_on_root([&] {
            if (std::filesystem::exists(path)) rename_file(path, previous_checkpoint(path));
            rename_file(unfinished, path);
            sync_folder_of(path);
        });
        agreement.settle<FileError>();
    } catch (const FileError&) {
        if (comm.rank() == 0) ::unlink(unfinished.c_str());
        throw;
    }
}

/// An open file, verified.
class Checkpoint::File {
  public:
    File(const std::filesystem::path& path, const parallel::Communicator& comm)
        : path_(path.string()), comm_(comm) {
        require_sealed(path_, comm);
        const QuietHdf5 quiet;
        Agreement agreement(comm);
        agreement.attempt([&] {
            file_ = open_to_read(path_, "reading " + path_);
            if (const auto found = number("/", "format"); found != format_number)
                throw FileError(
                    fmt::format("{} is of format {}, this program reads {}", path_, found, format_number));
            version_ = text_attribute("version");
            scene_ = text("/scene");
            read_values();
        });
        agreement.settle<FileError>();
    }

    [[nodiscard]] state::Table table(const std::string& name, std::span<const std::int64_t> ids) const {
        const QuietHdf5 quiet;
        Agreement agreement(comm_);
        state::Table table{{ids.begin(), ids.end()}, {}};
        Blocks blocks{0, items_of_grain, comm_.size()};
        std::vector<std::string> columns;
        agreement.attempt([&] {
            blocks.total = items_of(name);
            if (!ids.empty() && ids.back() >= blocks.total)
                throw FileError(fmt::format("{} holds {} {}, the scene has more", path_, blocks.total, name));
            columns = names_in("/" + name);
        });
        agreement.settle<FileError>();
        for (const auto& column : columns) {
            const auto where = "/" + name + "/" + column;
            RaggedValues block;
            std::uint64_t written = 0;
            agreement.attempt([&] {
                written = static_cast<std::uint64_t>(number(where, "xxh3"));
                block = read_block(where, blocks);
            });
            agreement.settle<FileError>();
            if (checksum_of(block, blocks, blocks.begin(comm_.rank()), comm_) != written)
                throw FileError(fmt::format("{} was changed: the checksum of {} is another", path_, where));
            auto values = from_blocks(block, blocks, ids, comm_);
            table.columns.push_back({column, std::move(values.counts), std::move(values.values)});
        }
        return table;
    }

    [[nodiscard]] const std::string& scene() const { return scene_; }
    [[nodiscard]] const std::string& version() const { return version_; }
    [[nodiscard]] const state::Values& values() const { return values_; }

  private:
    [[nodiscard]] std::string doing(const std::string& name) const {
        return "reading " + path_ + ": " + name;
    }

    [[nodiscard]] H5Attribute attribute(const std::string& where, const std::string& name) const {
        return H5Attribute(
            checked(H5Aopen_by_name(file_.get(), where.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                    doing(where + "@" + name)));
    }
    [[nodiscard]] std::int64_t number(const std::string& where, const std::string& name) const {
        return number_in(attribute(where, name), doing(where + "@" + name));
    }
    [[nodiscard]] std::string text_attribute(const std::string& name) const {
        return text_in(attribute("/", name), doing(name));
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        const auto dataset = open_dataset(file_, path_, name);
        const auto bytes = read_rows<std::uint8_t>(dataset, 0, rows_of(dataset, doing(name)), doing(name));
        return {bytes.begin(), bytes.end()};
    }

    /// Names of what a group holds, ascending.
    [[nodiscard]] std::vector<std::string> names_in(const std::string& name) const {
        const H5Group group(checked(H5Gopen2(file_.get(), name.c_str(), H5P_DEFAULT), doing(name)));
        H5G_info_t info{};
        checked(H5Gget_info(group.get(), &info), doing(name));
        std::vector<std::string> names;
        for (hsize_t i = 0; i < info.nlinks; ++i) {
            const auto length = checked(
                H5Lget_name_by_idx(group.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT),
                doing(name));
            std::string link(static_cast<std::size_t>(length) + 1, '\0');
            checked(H5Lget_name_by_idx(group.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, link.data(),
                                       link.size(), H5P_DEFAULT),
                    doing(name));
            link.pop_back();
            names.push_back(std::move(link));
        }
        return names;
    }

    void read_values() {
        for (const auto& name : names_in("/values")) {
            const auto where = "/values/" + name;
            const auto dataset = open_dataset(file_, path_, where);
            const auto rows = rows_of(dataset, doing(where));
            const H5Type type(checked(H5Dget_type(dataset.get()), doing(where)));
            if (H5Tget_class(type.get()) == H5T_FLOAT)
                values_.push_back({name, read_rows<double>(dataset, 0, rows, doing(where))});
            else if (H5Tget_size(type.get()) == 1)
                values_.push_back({name, text(where)});
            else
                values_.push_back({name, read_rows<std::int64_t>(dataset, 0, rows, doing(where))});
        }
    }

    /// How many nodes or elements the file holds.
    [[nodiscard]] std::int64_t items_of(const std::string& name) const {
        const auto items = number("/" + name, "items");
        if (items < 0) throw FileError(fmt::format("{} holds {} {}", path_, items, name));
        return items;
    }

    [[noreturn]] void refuse_column(const std::string& where) const {
        throw FileError(
            fmt::format("{} was changed: {} does not hold the values of its items", path_, where));
    }

    /// @throws FileError unless each item has as many values
    void require_values(const std::string& where, std::int64_t per_item, std::int64_t items) const {
        constexpr auto most = std::numeric_limits<std::int32_t>::max();
        const auto rows = rows_of(open_dataset(file_, path_, where + "/values"), doing(where));
        if (per_item == 0 || per_item > most || rows % per_item != 0 || rows / per_item != items)
            refuse_column(where);
    }

    /// Values of a dataset of one dimension.
    template <class T>
    [[nodiscard]] std::vector<T> one_column(const std::string& name, std::int64_t first,
                                            std::int64_t count) const {
        const auto dataset = open_dataset(file_, path_, name);
        (void)rows_of(dataset, doing(name));
        return read_rows<T>(dataset, first, count, doing(name));
    }

    /// This rank's block of a column.
    [[nodiscard]] RaggedValues read_block(const std::string& where, const Blocks& blocks) const {
        const auto per_item = number(where, "values_per_item");
        RaggedValues block;
        std::int64_t before = 0;
        if (per_item >= 0) {
            require_values(where, per_item, blocks.total);
            const auto first = blocks.begin(comm_.rank()), count = blocks.begin(comm_.rank() + 1) - first;
            before = first * per_item;
            block.counts.assign(static_cast<std::size_t>(count), static_cast<std::int32_t>(per_item));
        } else {
            before = read_counts(where, blocks, block.counts);
        }
        const auto size = std::accumulate(block.counts.begin(), block.counts.end(), std::int64_t{0});
        block.values = one_column<double>(where + "/values", before, size);
        return block;
    }

    /// How many values each item of this rank's block has. @return values before them
    std::int64_t read_counts(const std::string& where, const Blocks& blocks,
                             std::vector<std::int32_t>& of_block) const {
        if (rows_of(open_dataset(file_, path_, where + "/counts"), doing(where)) != blocks.total)
            refuse_column(where);
        // Where the values of a block begin follows from all counts before it.
        const auto first = blocks.begin(comm_.rank()), end = blocks.begin(comm_.rank() + 1);
        const auto counts = one_column<std::int32_t>(where + "/counts", 0, end);
        if (std::ranges::any_of(counts, [](std::int32_t count) { return count < 0; })) refuse_column(where);
        of_block.assign(counts.begin() + first, counts.end());
        return std::accumulate(counts.begin(), counts.begin() + first, std::int64_t{0});
    }

    std::string path_;
    const parallel::Communicator& comm_;
    H5File file_;
    std::string scene_, version_;
    state::Values values_;
};

Checkpoint::Checkpoint(const std::filesystem::path& path, const parallel::Communicator& comm)
    : file_(std::make_unique<File>(path, comm)) {}
Checkpoint::~Checkpoint() = default;
Checkpoint::Checkpoint(Checkpoint&&) noexcept = default;
Checkpoint& Checkpoint::operator=(Checkpoint&&) noexcept = default;

const std::string& Checkpoint::scene() const { return file_->scene(); }
const std::string& Checkpoint::version() const { return file_->version(); }
const state::Values& Checkpoint::values() const { return file_->values(); }
state::Table Checkpoint::nodes(std::span<const std::int64_t> ids) const { return file_->table("nodes", ids); }
state::Table Checkpoint::elements(std::span<const std::int64_t> ids) const {
    return file_->table("elements", ids);
}

}  // namespace weavefront::io
