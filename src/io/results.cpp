#include "weavefront/io/results.hpp"

#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "agreement.hpp"
#include "dataset_rows.hpp"
#include "descriptor.hpp"
#include "disk_space.hpp"
#include "frame_checks.hpp"
#include "frame_publisher.hpp"
#include "results_continued.hpp"
#include "results_copy.hpp"
#include "results_skeleton.hpp"
#include "results_topology.hpp"
#include "weavefront/io/block_exchange.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/new_file.hpp"

namespace weavefront::io {

namespace {

using Clock = std::chrono::steady_clock;

// What the machine's crash may cost, beside what its kill may: waiting for the disk at every frame would take
// longer than writing it.
constexpr auto between_syncs = std::chrono::seconds(5);

constexpr std::uint8_t vtk_hidden_cell = 32;  // vtkDataSetAttributes::HIDDENCELL

template <class To, class From>
std::vector<To> converted(const From& values) {
    std::vector<To> result(values.size());
    std::transform(values.begin(), values.end(), result.begin(),
                   [](auto value) { return static_cast<To>(value); });
    return result;
}

/// What all ranks write to together.
struct OpenArrays {
    Descriptor file;
    DatasetRows points, hidden;
    std::vector<DatasetRows> point_data, cell_data;

    OpenArrays(const std::string& path, const Frame& layout, const std::string& shown)
        : file(path, O_WRONLY, shown) {
        const auto structure = open_to_read(path, "opening " + path);
        const auto rows = [&](const std::string& name, hid_t type) {
            return DatasetRows(structure, path, "/VTKHDF/" + name, type);
        };
        const auto type_of = [](const Array& array) {
            return array.integer ? native_type<std::int8_t>() : native_type<double>();
        };
        points = rows("Points", native_type<double>());
        for (const auto& array : layout.point_data)
            point_data.push_back(rows("PointData/" + array.name, type_of(array)));
        for (const auto& array : layout.cell_data)
            cell_data.push_back(rows("CellData/" + array.name, type_of(array)));
        hidden = rows(std::string("CellData/") + hidden_name, native_type<std::uint8_t>());
    }
};

}  // namespace

/// The file, under its temporary name until it is published.
class Results::File {
  public:
    File(const ResultsSetup& setup, const parallel::Communicator& comm)
        : comm_(comm),
          setup_(without_values(setup)),
          path_(setup.path.string()),
          sizes_(setup),
          nodes_(comm, setup.topology.nodes, setup.topology.owned_nodes),
          elements_(comm, setup.topology.elements, setup.topology.owned_elements) {
        const QuietHdf5 quiet;
        const std::string unfinished = temporary_name(path_).string();
        Agreement agreement(comm_);
        agreement.attempt_on_root([&] {
            require_regular_or_missing(path_);
            require_space(setup, taken_by(path_));
            require_size(setup);
            create_results_skeleton(unfinished, setup);
            is_unfinished_there_ = true;
        });
        agreement.settle<FileError>();
        agreement.attempt([&] { write_topology(unfinished, setup, elements_, comm_); });
        settle_creation(agreement);
        open(unfinished);
    }

    File(const ResultsSetup& setup, std::int64_t frames, const parallel::Communicator& comm)
        : comm_(comm),
          setup_(without_values(setup)),
          path_(setup.path.string()),
          sizes_(setup),
          frames_(frames),
          nodes_(comm, setup.topology.nodes, setup.topology.owned_nodes),
          elements_(comm, setup.topology.elements, setup.topology.owned_elements),
          is_continued_(true) {
        const QuietHdf5 quiet;
        Agreement agreement(comm_);
        std::vector<std::int64_t> room(1, 0);
        agreement.attempt_on_root([&] {
            require_regular_or_missing(path_);
            room[0] = room_of_results(path_, setup_, frames);
        });
        agreement.settle<FileError>();
        comm_.sum(room);
        setup_.max_frames = room[0];
        open(path_);
    }

    ~File() { remove_unfinished(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void publish() {
        Agreement agreement(comm_);
        if (std::exchange(is_continued_, false)) {
            bool is_of_other_scene = false;
            agreement.attempt_on_root([&] {
                publisher_->cut(frames_);
                is_of_other_scene = scene_of_results(path_) != setup_.scene;
            });
            agreement.settle<FileError>();
            if (comm_.any(is_of_other_scene)) change_room(setup_.max_frames);
            return;
        }
        agreement.attempt_on_root([&] {
            publish_file(path_);
            is_unfinished_there_ = false;
        });
        agreement.settle<FileError>();
    }

    void write(const Frame& frame) {
        const QuietHdf5 quiet;
        Agreement agreement(comm_);
        agreement.attempt([&] { require_layout(frame, setup_.layout, nodes_.owned(), elements_.owned()); });
        agreement.settle<std::logic_error>();
        agreement.attempt([&] { require_finite(frame, path_); });
        agreement.settle<NotFinite>();
        agreement.attempt_on_root([&] { publisher_->require_in_place(path_); });
        agreement.settle<FileError>();
        if (frames_ == setup_.max_frames) change_room(frames_ + std::max<std::int64_t>(frames_ / 2, 1));
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

    bool cut() {
        const auto room = std::max<std::int64_t>(frames_, 1);
        const QuietHdf5 quiet;
        if (room != setup_.max_frames) change_room(room);
        return room == setup_.max_frames;
    }

    void sync_all() {
        const QuietHdf5 quiet;
        Agreement agreement(comm_);
        agreement.attempt([&] { sync(); });
        agreement.attempt_on_root([&] { publisher_->sync(); });
        agreement.settle<FileError>();
        synced_ = Clock::now();
    }

    void redistribute(const Topology& topology) {
        nodes_ = BlockExchange(comm_, topology.nodes, topology.owned_nodes);
        elements_ = BlockExchange(comm_, topology.elements, topology.owned_elements);
    }

    [[nodiscard]] std::int64_t frames() const { return frames_; }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] double bytes() const { return results_bytes(setup_, frames_); }

  private:
    /// What is needed of a setup to make the structure anew.
    static ResultsSetup without_values(ResultsSetup setup) {
        setup.topology = {setup.topology.nodes, setup.topology.elements, {}, {}, {}, {}};
        for (auto* arrays : {&setup.layout.point_data, &setup.layout.cell_data})
            for (auto& array : *arrays) array.values = std::vector<double>();  // gives its memory back
        setup.layout.points = {};
        setup.layout.eroded = {};
        return setup;
    }

    void settle_creation(Agreement& agreement) {
        try {
            agreement.settle<FileError>();
        } catch (...) {
            remove_unfinished();  // no destructor will
            throw;
        }
    }

    void remove_unfinished() {
        if (!std::exchange(is_unfinished_there_, false)) return;
        std::error_code ignored;
        std::filesystem::remove(temporary_name(path_), ignored);
    }

    void open(const std::string& path) {
        Agreement agreement(comm_);
        agreement.attempt([&] { arrays_ = std::make_unique<OpenArrays>(path, setup_.layout, path_); });
        settle_creation(agreement);
        agreement.attempt_on_root([&] { publisher_.emplace(path); });
        settle_creation(agreement);
    }

    /// Puts a file with room for another number of frames in the place of this one, as a whole: space between
    /// arrays cannot be inserted or taken out. Whoever reads finds one of them at any moment.
    void change_room(std::int64_t frames) {
        arrays_.reset();
        publisher_.reset();
        Agreement agreement(comm_);
        agreement.settle<FileError>();  // all have closed it
        auto setup = setup_;
        setup.max_frames = frames;
        const std::string unfinished = temporary_name(path_).string();
        agreement.attempt_on_root([&] {
            require_space(setup, 0);
            require_size(setup);
            create_results_skeleton(unfinished, setup);
            is_unfinished_there_ = true;
            copy_results(path_, unfinished, setup, frames_);
        });
        bool is_copied = false;
        try {
            agreement.settle<FileError>();
            publish();
            is_copied = true;
        } catch (const FileError&) {
            remove_unfinished();
            if (frames > frames_) throw;
        }
        if (is_copied) setup_.max_frames = frames;
        open(path_);
    }

    void write_arrays(const Frame& frame, Agreement& agreement) const {
        const auto first_point = frames_ * sizes_.all_points() + nodes_.first();
        const auto first_cell = frames_ * sizes_.all_cells() + elements_.first();
        const auto points =
            with_rows_of_last_rank(comm_, nodes_.to_block<double>(frame.points, 3), frame.projectile);
        agreement.attempt([&] { arrays_->points.write(arrays_->file, first_point, points); });

        for (std::size_t i = 0; i < arrays_->point_data.size(); ++i)
            write_array(arrays_->point_data[i], frame.point_data[i], nodes_, first_point,
                        setup_.surface.points.size(), agreement);
        for (std::size_t i = 0; i < arrays_->cell_data.size(); ++i)
            write_array(arrays_->cell_data[i], frame.cell_data[i], elements_, first_cell,
                        setup_.surface.quads.size(), agreement);

        auto hidden = converted<std::uint8_t>(frame.eroded);
        for (auto& value : hidden) value = value != 0 ? vtk_hidden_cell : std::uint8_t{0};
        const auto shown = std::vector<std::uint8_t>(setup_.surface.quads.size(), 0);
        const auto values = with_rows_of_last_rank(comm_, elements_.to_block<std::uint8_t>(hidden), shown);
        agreement.attempt([&] { arrays_->hidden.write(arrays_->file, first_cell, values); });
    }

    void write_array(const DatasetRows& rows, const Array& array, const BlockExchange& exchange,
                     std::int64_t first, std::size_t surface_items, Agreement& agreement) const {
        auto surface = array.projectile;
        surface.resize(surface_items * static_cast<std::size_t>(array.components), 0.0);
        const auto values =
            with_rows_of_last_rank(comm_, exchange.to_block<double>(array.values, array.components), surface);
        agreement.attempt([&] {
            if (array.integer)
                rows.write(arrays_->file, first, converted<std::int8_t>(values));
            else
                rows.write(arrays_->file, first, values);
        });
    }

    void sync() const { arrays_->file.sync(); }

    const parallel::Communicator& comm_;
    ResultsSetup setup_;
    std::string path_;
    PartSizes sizes_;
    bool is_unfinished_there_ = false;  // on the first rank
    std::int64_t frames_ = 0;
    BlockExchange nodes_, elements_;
    bool is_continued_ = false;  // and not published yet
    std::unique_ptr<OpenArrays> arrays_;
    std::optional<FramePublisher> publisher_;  // on the first rank
    Clock::time_point synced_ = Clock::now();
};

Results::Results(const ResultsSetup& setup, const parallel::Communicator& comm)
    : file_(std::make_unique<File>(setup, comm)) {}
Results::Results(const ResultsSetup& setup, std::int64_t frames, const parallel::Communicator& comm)
    : file_(std::make_unique<File>(setup, frames, comm)) {}
Results::~Results() = default;
Results::Results(Results&&) noexcept = default;
Results& Results::operator=(Results&&) noexcept = default;

void Results::write(const Frame& frame) { file_->write(frame); }

void Results::publish() {
    const QuietHdf5 quiet;
    file_->publish();
}

void Results::sync() { file_->sync_all(); }

bool Results::cut() { return file_->cut(); }

void Results::redistribute(const Topology& topology) { file_->redistribute(topology); }

std::int64_t Results::frames() const { return file_->frames(); }

double Results::bytes() const { return file_->bytes(); }

}  // namespace weavefront::io
