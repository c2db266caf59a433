#include "weavefront/io/results.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>

#include "agreement.hpp"
#include "frame_checks.hpp"
#include "frame_publisher.hpp"
#include "hdf5_collective.hpp"
#include "results_skeleton.hpp"
#include "results_topology.hpp"
#include "weavefront/io/block_exchange.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

using Clock = std::chrono::steady_clock;

// What the machine's crash may cost, beside what its kill may: waiting for the disk at every frame would take longer than writing it.
constexpr auto between_syncs = std::chrono::seconds(5);

constexpr std::uint8_t vtk_hidden_cell = 32;  // vtkDataSetAttributes::HIDDENCELL

template <class To, class From>
std::vector<To> converted(const From& values) {
    std::vector<To> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(), [](auto value) { return static_cast<To>(value); });
    return result;
}

}  // namespace

/// The open file.
class Results::File {
  public:
    File(const ResultsSetup& setup, const parallel::Communicator& comm)
        : comm_(comm),
          path_(setup.path.string()),
          sizes_(setup),
          surface_(setup.surface),
          layout_{.time = 0,
                  .points = {},
                  .point_data = shapes(setup.layout.point_data),
                  .cell_data = shapes(setup.layout.cell_data),
                  .eroded = {}},
          max_frames_(setup.max_frames),
          nodes_(comm, setup.topology.nodes, setup.topology.owned_nodes),
          elements_(comm, setup.topology.elements, setup.topology.owned_elements) {
        const QuietHdf5 quiet;
        const std::string unfinished = path_ + ".new";
        Agreement agreement(comm_);
        agreement.attempt_on_root([&] {
            require_space(setup);
            create_results_skeleton(unfinished, setup);
        });
        agreement.settle<FileError>();
        agreement.attempt([&] { write_topology(unfinished, setup, elements_, comm_); });
        agreement.settle<FileError>();
        agreement.attempt_on_root([&] { std::filesystem::rename(unfinished, path_); });
        agreement.settle<FileError>();
        agreement.attempt([&] { open(); });
        agreement.settle<FileError>();
        agreement.attempt_on_root([&] { publisher_.emplace(path_); });
        agreement.settle<FileError>();
    }

    void write(const Frame& frame) {
        const QuietHdf5 quiet;
        Agreement agreement(comm_);
        agreement.attempt([&] { require_layout(frame); });
        agreement.settle<std::logic_error>();
        agreement.attempt([&] { require_finite(frame, path_); });
        agreement.settle<NotFinite>();
        write_arrays(frame, agreement);
        if (comm_.any(Clock::now() - synced_ > between_syncs)) {
            agreement.attempt([&] { sync(); });
            synced_ = Clock::now();
        }
        agreement.settle<FileError>();
        agreement.attempt_on_root([&] { publisher_->publish(frames_, frame.time); });
        agreement.settle<FileError>();
        ++frames_;
    }

    void redistribute(const Topology& topology) {
        nodes_ = BlockExchange(comm_, topology.nodes, topology.owned_nodes);
        elements_ = BlockExchange(comm_, topology.elements, topology.owned_elements);
    }

    [[nodiscard]] std::int64_t frames() const { return frames_; }

    /// What to add to a failure; empty: the disk has room.
    [[nodiscard]] std::string fullness() const {
        std::error_code unknown;
        const auto disk = std::filesystem::space(path_, unknown);
        constexpr std::uintmax_t hardly_any = 1 << 20;
        return !unknown && disk.available < hardly_any ? ": No space left on device" : "";
    }

  private:
    static std::vector<Array> shapes(std::vector<Array> arrays) {
        for (auto& array : arrays) array.values = std::vector<double>();  // gives its memory back
        return arrays;
    }

    /// HDF5 does not survive a disk that is full at the wrong moment, and nobody wants to learn of it at the end of a run.
    static void require_space(const ResultsSetup& setup) {
        constexpr double of_other_files = 1e6;  // history, log and summary
        const auto folder = std::filesystem::absolute(setup.path).parent_path();
        std::error_code unknown;  // then creating the file tells why
        const auto disk = std::filesystem::space(folder, unknown);
        if (unknown) return;
        const auto left = static_cast<double>(disk.available) + taken_by(setup.path);
        const double needed = results_bytes(setup) + of_other_files;
        if (needed > left)
            throw FileError(
                fmt::format("{} may grow to {:.4g} GB with its {} frames, but only {:.4g} GB are free there: write fewer frames "
                            "(output.interval) or fields (output.fields), or to another disk (--output)",
                            setup.path.string(), needed / 1e9, setup.max_frames, left / 1e9));
    }

    /// What the disk gets back when a file is replaced, bytes: results are sparse until they are written.
    static double taken_by(const std::filesystem::path& path) {
        struct stat found {};
        constexpr double of_block = 512;
        return ::stat(path.c_str(), &found) == 0 ? of_block * static_cast<double>(found.st_blocks) : 0.0;
    }

    [[nodiscard]] std::string doing(const std::string& name) const { return "writing " + path_ + ": " + name; }

    void open() {
        file_ = open_by_all(path_, comm_);
        const auto dataset = [&](const std::string& name) {
            return H5Dataset(checked(H5Dopen2(file_.get(), ("/VTKHDF/" + name).c_str(), H5P_DEFAULT), "opening " + path_ + ": " + name));
        };
        points_ = dataset("Points");
        for (const auto& array : layout_.point_data) point_data_.push_back(dataset("PointData/" + array.name));
        for (const auto& array : layout_.cell_data) cell_data_.push_back(dataset("CellData/" + array.name));
        hidden_ = dataset(std::string("CellData/") + hidden_name);
    }

    void require_layout(const Frame& frame) const {
        if (frames_ == max_frames_) throw std::logic_error(path_ + " has no room for more than " + std::to_string(max_frames_) + " frames");
        io::require_layout(frame, layout_, nodes_.owned(), elements_.owned());
    }

    void write_arrays(const Frame& frame, Agreement& agreement) const {
        const auto first_point = frames_ * sizes_.all_points() + nodes_.first();
        const auto first_cell = frames_ * sizes_.all_cells() + elements_.first();
        std::vector<double> surface;
        for (const auto& point : surface_.points)
            for (std::size_t i = 0; i < 3; ++i) surface.push_back(point[i] + frame.projectile[i]);
        const auto points = with_rows_of_last_rank(comm_, nodes_.to_block<double>(frame.points, 3), surface);
        agreement.attempt([&] { write_rows<double>(points_, first_point, points, doing("Points")); });

        for (std::size_t i = 0; i < point_data_.size(); ++i)
            write_array(point_data_[i], frame.point_data[i], nodes_, first_point, surface_.points.size(), agreement);
        for (std::size_t i = 0; i < cell_data_.size(); ++i)
            write_array(cell_data_[i], frame.cell_data[i], elements_, first_cell, surface_.quads.size(), agreement);

        auto hidden = converted<std::uint8_t>(frame.eroded);
        for (auto& value : hidden) value = value != 0 ? vtk_hidden_cell : std::uint8_t{0};
        const auto shown = std::vector<std::uint8_t>(surface_.quads.size(), 0);
        const auto values = with_rows_of_last_rank(comm_, elements_.to_block<std::uint8_t>(hidden), shown);
        agreement.attempt([&] { write_rows<std::uint8_t>(hidden_, first_cell, values, doing(hidden_name)); });
    }

    void write_array(const H5Dataset& dataset, const Array& array, const BlockExchange& exchange, std::int64_t first,
                     std::size_t surface_items, Agreement& agreement) const {
        auto item = array.projectile;
        item.resize(static_cast<std::size_t>(array.components), 0.0);
        std::vector<double> surface;
        for (std::size_t i = 0; i < surface_items; ++i) surface.insert(surface.end(), item.begin(), item.end());
        const auto values = with_rows_of_last_rank(comm_, exchange.to_block<double>(array.values, array.components), surface);
        agreement.attempt([&] {
            if (array.integer)
                write_rows<std::int8_t>(dataset, first, converted<std::int8_t>(values), doing(array.name));
            else
                write_rows<double>(dataset, first, values, doing(array.name));
        });
    }

    // The arrays are written as they are handed over, and metadata do not change: all that is left to flush is the operating system.
    void sync() const { checked(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL), "writing " + path_); }

    const parallel::Communicator& comm_;
    std::string path_;
    PartSizes sizes_;
    Surface surface_;
    Frame layout_;
    std::int64_t max_frames_;
    std::int64_t frames_ = 0;
    BlockExchange nodes_, elements_;
    H5File file_;
    H5Dataset points_, hidden_;
    std::vector<H5Dataset> point_data_, cell_data_;
    std::optional<FramePublisher> publisher_;  // on the first rank
    Clock::time_point synced_ = Clock::now();
};

Results::Results(const ResultsSetup& setup, const parallel::Communicator& comm) : file_(std::make_unique<File>(setup, comm)) {}
Results::~Results() = default;
Results::Results(Results&&) noexcept = default;
Results& Results::operator=(Results&&) noexcept = default;

void Results::write(const Frame& frame) {
    try {
        file_->write(frame);
    } catch (const FileError& failure) {
        throw FileError(failure.what() + file_->fullness());  // of which MPI-IO says nothing
    }
}

void Results::redistribute(const Topology& topology) { file_->redistribute(topology); }

std::int64_t Results::frames() const { return file_->frames(); }

}  // namespace weavefront::io
