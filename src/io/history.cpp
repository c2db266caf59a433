#include "weavefront/io/history.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "agreement.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

struct Column {
    std::string name;
    std::variant<double, std::int64_t> value;
};

void add_vector(std::vector<Column>& all, const std::string& name, const std::array<double, 3>& vector) {
    for (std::size_t d = 0; d < 3; ++d) all.push_back({name + "xyz"[d], vector[d]});
}

/// @param number empty for the first projectile
void add_motion(std::vector<Column>& all, const std::string& number, const ProjectileRow& projectile) {
    add_vector(all, "projectile" + number + "_", projectile.position);
    add_vector(all, "projectile" + number + "_v", projectile.velocity);
    add_vector(all, "contact" + number + "_f", projectile.contact_force);
}

void add_rotation(std::vector<Column>& all, const std::string& number, const ProjectileRow& projectile) {
    if (!projectile.rotation) return;
    const auto& [attitude, angular_velocity, moment] = *projectile.rotation;
    for (std::size_t i = 0; i < 4; ++i)
        all.push_back({"projectile" + number + "_q" + "wxyz"[i], attitude[i]});
    add_vector(all, "projectile" + number + "_w", angular_velocity);
    add_vector(all, "contact" + number + "_m", moment);
}

// The order is that of the file.
std::vector<Column> columns(const HistoryRow& row) {
    const auto first = row.projectiles.empty() ? ProjectileRow() : row.projectiles.front();
    std::vector<Column> all{{"time", row.time}};
    add_motion(all, "", first);
    const std::array of_whole{Column{"kinetic_fabric", row.kinetic_fabric},
                              Column{"kinetic_projectile", row.kinetic_projectile},
                              Column{"internal", row.internal},
                              Column{"hourglass", row.hourglass},
                              Column{"contact", row.contact},
                              Column{"friction", row.friction},
                              Column{"damping", row.damping},
                              Column{"external", row.external},
                              Column{"eroded", row.eroded},
                              Column{"energy_error", row.energy_error},
                              Column{"broken_yarns", row.broken_yarns},
                              Column{"eroded_elements", row.eroded_elements},
                              Column{"max_displacement", row.max_displacement},
                              Column{"time_step", row.time_step},
                              Column{"back_face_deflection", row.back_face_deflection},
                              Column{"penetration", row.penetration},
                              Column{"penetration_x", row.penetration_at[0]},
                              Column{"penetration_y", row.penetration_at[1]},
                              Column{"penetration_ply", row.penetration_ply},
                              Column{"debris_elements", row.debris_elements},
                              Column{"debris_mass", row.debris_mass},
                              Column{"debris_displacement", row.debris_displacement}};
    all.insert(all.end(), of_whole.begin(), of_whole.end());
    add_rotation(all, "", first);
    if (row.contact_friction) all.push_back({"contact_friction", *row.contact_friction});
    for (std::size_t p = 1; p < row.projectiles.size(); ++p) {
        add_motion(all, std::to_string(p + 1), row.projectiles[p]);
        add_rotation(all, std::to_string(p + 1), row.projectiles[p]);
    }
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
    for (const auto& column : columns(layout)) names.push_back(column.name);
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
