#include "weavefront/io/history.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "agreement.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

struct Column {
    const char* name;
    std::variant<double, std::int64_t> value;
};

// The order is that of the file.
std::vector<Column> columns(const HistoryRow& row) {
    return {{"time", row.time},
            {"projectile_x", row.projectile[0]},
            {"projectile_y", row.projectile[1]},
            {"projectile_z", row.projectile[2]},
            {"projectile_vx", row.projectile_velocity[0]},
            {"projectile_vy", row.projectile_velocity[1]},
            {"projectile_vz", row.projectile_velocity[2]},
            {"contact_fx", row.contact_force[0]},
            {"contact_fy", row.contact_force[1]},
            {"contact_fz", row.contact_force[2]},
            {"kinetic_fabric", row.kinetic_fabric},
            {"kinetic_projectile", row.kinetic_projectile},
            {"internal", row.internal},
            {"hourglass", row.hourglass},
            {"contact", row.contact},
            {"friction", row.friction},
            {"damping", row.damping},
            {"external", row.external},
            {"eroded", row.eroded},
            {"energy_error", row.energy_error},
            {"broken_yarns", row.broken_yarns},
            {"eroded_elements", row.eroded_elements},
            {"max_displacement", row.max_displacement},
            {"time_step", row.time_step},
            {"back_face_deflection", row.back_face_deflection},
            {"penetration", row.penetration},
            {"penetration_x", row.penetration_at[0]},
            {"penetration_y", row.penetration_at[1]},
            {"penetration_ply", row.penetration_ply},
            {"debris_elements", row.debris_elements},
            {"debris_mass", row.debris_mass},
            {"debris_displacement", row.debris_displacement}};
}

std::string cell(const Column& column, double time) {
    if (const auto* count = std::get_if<std::int64_t>(&column.value)) return fmt::format("{}", *count);
    const double value = std::get<double>(column.value);
    if (!std::isfinite(value)) throw NotFinite(fmt::format("column {} of the history would be {} at {} s", column.name, value, time));
    return fmt::format("{:.17g}", value);
}

}  // namespace

std::string history_header() {
    std::vector<std::string> names;
    for (const auto& column : columns({})) names.emplace_back(column.name);
    return fmt::format("{}", fmt::join(names, ","));
}

std::string history_line(const HistoryRow& row) {
    std::vector<std::string> cells;
    for (const auto& column : columns(row)) cells.push_back(cell(column, row.time));
    return fmt::format("{}", fmt::join(cells, ","));
}

/// The open file on rank 0. A line goes out in one call to the system, which no stream promises.
class History::File {
  public:
    explicit File(std::string path)
        : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666)) {
        if (descriptor_ < 0) fail("created");
    }
    ~File() { ::close(descriptor_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    void append(std::string line) const {
        line += '\n';
        for (std::size_t done = 0; done < line.size();) {
            const auto wrote = ::write(descriptor_, line.data() + done, line.size() - done);
            if (wrote < 0 && errno != EINTR) {
                take_back(done);
                fail("written");
            }
            if (wrote > 0) done += static_cast<std::size_t>(wrote);
        }
    }

  private:
    /// Takes part of a line off the end again, and leaves errno as it is.
    void take_back(std::size_t part) const {
        const int cause = errno;
        const auto end = ::lseek(descriptor_, 0, SEEK_END);
        if (part > 0 && end >= 0 && ::ftruncate(descriptor_, end - static_cast<off_t>(part)) != 0) fail("cut back to whole lines");
        errno = cause;
    }
    [[noreturn]] void fail(const char* action) const {
        throw FileError(path_ + " cannot be " + action + ": " + std::generic_category().message(errno));
    }

    std::string path_;
    int descriptor_;
};

History::History(const std::filesystem::path& path, const parallel::Communicator& comm) : comm_(&comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        file_ = std::make_unique<File>(path.string());
        file_->append(history_header());
    });
    agreement.settle<FileError>();
}

History::~History() = default;
History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

void History::write(const HistoryRow& row) {
    std::string line;
    Agreement agreement(*comm_);
    agreement.attempt_on_root([&] { line = history_line(row); });
    agreement.settle<NotFinite>();
    agreement.attempt_on_root([&] { file_->append(line); });
    agreement.settle<FileError>();
}

}  // namespace weavefront::io
