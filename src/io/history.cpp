#include "weavefront/io/history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
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
    std::vector<Column> all{{"time", row.time},
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
    if (row.rotation) {
        const auto& [attitude, angular_velocity, moment] = *row.rotation;
        all.insert(all.end(), {{"projectile_qw", attitude[0]},
                               {"projectile_qx", attitude[1]},
                               {"projectile_qy", attitude[2]},
                               {"projectile_qz", attitude[3]},
                               {"projectile_wx", angular_velocity[0]},
                               {"projectile_wy", angular_velocity[1]},
                               {"projectile_wz", angular_velocity[2]},
                               {"contact_mx", moment[0]},
                               {"contact_my", moment[1]},
                               {"contact_mz", moment[2]}});
    }
    if (row.contact_friction) all.push_back({"contact_friction", *row.contact_friction});
    return all;
}

std::string cell(const Column& column, double time) {
    if (const auto* count = std::get_if<std::int64_t>(&column.value)) return fmt::format("{}", *count);
    const double value = std::get<double>(column.value);
    if (!std::isfinite(value))
        throw NotFinite(
            fmt::format("column {} of the history would be {} at {} s", column.name, value, time));
    return fmt::format("{:.17g}", value);
}

}  // namespace

std::string history_header(const HistoryRow& layout) {
    std::vector<std::string> names;
    for (const auto& column : columns(layout)) names.emplace_back(column.name);
    return fmt::format("{}", fmt::join(names, ","));
}

std::string history_line(const HistoryRow& row) {
    std::vector<std::string> cells;
    for (const auto& column : columns(row)) cells.push_back(cell(column, row.time));
    return fmt::format("{}", fmt::join(cells, ","));
}

History::History(const std::filesystem::path& path, const HistoryRow& layout,
                 const parallel::Communicator& comm)
    : comm_(&comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        file_ = std::make_unique<NewFile>(path);
        append(history_header(layout));
    });
    agreement.settle<FileError>();
}

History::History(const std::filesystem::path& path, const Written& written,
                 const parallel::Communicator& comm)
    : comm_(&comm) {
    Agreement agreement(comm);
    agreement.attempt_on_root([&] {
        std::ifstream file(path, std::ios::binary);
        std::string text(static_cast<std::size_t>(written.bytes), '\0');
        if (!file.read(text.data(), written.bytes))
            throw FileError(
                fmt::format("{} cannot be continued: it has fewer than the {} bytes that were written",
                            path.string(), written.bytes));
        sha256_.add(text);
        if (sha256_.hex() != written.sha256)
            throw FileError(path.string() + " cannot be continued: its rows are not those of the checkpoint");
        bytes_ = written.bytes;
        file_ = NewFile::appended_to(path);
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
    agreement.attempt_on_root([&] { append(line); });
    agreement.settle<FileError>();
}

void History::publish() {
    Agreement agreement(*comm_);
    agreement.attempt_on_root([&] {
        file_->publish();
        file_->cut(bytes_);
    });
    agreement.settle<FileError>();
}

void History::require_in_place() const {
    Agreement agreement(*comm_);
    agreement.attempt_on_root([&] { file_->require_in_place(); });
    agreement.settle<FileError>();
}

Written History::written() const {
    Written written;
    Agreement agreement(*comm_);
    agreement.attempt_on_root([&] {
        file_->sync();
        written = {bytes_, sha256_.hex()};
    });
    agreement.settle<FileError>();
    return written;
}

std::string History::hash() const { return sha256_.hex(); }

void History::append(std::string line) {
    line += '\n';
    file_->append(line);
    sha256_.add(line);
    bytes_ += static_cast<std::int64_t>(line.size());
}

}  // namespace weavefront::io
