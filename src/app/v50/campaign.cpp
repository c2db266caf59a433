#include "campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "shared_text.hpp"
#include "shot_result.hpp"
#include "shot_run.hpp"
#include "shot_table.hpp"
#include "stop.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/io/replace_file.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::app {

namespace {

// The limits of other meshes lie near that of the scene: the first steps away from it are short.
constexpr double widths_of_first_step = 2;

// A design whose shots are not decided learns nothing.
constexpr std::ptrdiff_t most_without_result = 3;

std::ptrdiff_t without_result_at_end(const std::vector<ShotRow>& rows) {
    const auto last = std::find_if(rows.rbegin(), rows.rend(),
                                   [](const auto& row) { return row.result != ballistics::Result::none; });
    return last - rows.rbegin();
}

}  // namespace

std::string text_of_shot(const V50Plan& plan, const ShotRow& row) {
    if (row.is_stopped_by_guard) return "stopped by the guard: " + row.reason;
    if (row.is_failed) return "failed: " + row.reason;
    if (row.result == ballistics::Result::none)
        return fmt::format("no result, {}: {}", row.outcome, row.reason);
    const bool is_complete = row.result == ballistics::Result::complete;
    return fmt::format("{}, {} of {} plies perforated, back face {:.2f} mm",
                       is_complete ? "complete, residual " + plan.unit.text(*row.residual) : "partial",
                       *row.plies_perforated, plan.plies, *row.deflection * 1e3);
}

Campaign::Campaign(const V50Plan& plan, std::filesystem::path folder, const parallel::Communicator& comm,
                   io::Log& log)
    : plan_(plan), folder_(std::move(folder)), comm_(comm), log_(log), failures_(plan.variants.size()) {}

std::vector<ballistics::Trial> Campaign::trials(std::size_t variant) const {
    std::vector<ballistics::Trial> found;
    for (const auto& row : rows_)
        if (row.variant == variant) found.push_back({row.speed, row.result});
    return found;
}

void Campaign::go_on() {
    const auto path = folder_ / "v50.csv";
    rows_ = planned_shots(plan_, shared_text(path, comm_, scene::most_of_table), path.string());
    if (rows_.empty()) return;
    expected_ = static_cast<int>(rows_.size());
    fire(0);
}

void Campaign::shoot() {
    if (!plan_.scatter.empty()) return shoot_design();
    for (std::size_t variant = 0; variant < plan_.variants.size(); ++variant) search(variant);
}

ballistics::SearchPlan Campaign::search_plan(std::size_t variant) const {
    auto plan = plan_.search;
    const auto bracket = ballistics::bracket_of(trials(0));
    if (variant == 0 || !bracket.low || !bracket.high) return plan;
    plan.from.reset();
    plan.to.reset();
    plan.start = 0.5 * (*bracket.low + *bracket.high);
    plan.step = widths_of_first_step * plan.width;
    return plan;
}

void Campaign::search(std::size_t variant) {
    const auto plan = search_plan(variant);
    for (;;) {
        std::vector<double> wanted;
        std::string failure;
        const auto known = trials(variant);
        if (comm_.rank() == 0) {
            const auto round = ballistics::next_round(plan, known);
            failure = round.failure;
            wanted = round.speeds;
        }
        failures_[variant] = comm_.broadcast(failure);
        const auto speeds = agreed_speeds(wanted);
        if (speeds.empty()) return;
        expected_ = static_cast<int>(rows_.size()) + ballistics::rounds_left(plan, known) * plan_.groups;
        const auto first = rows_.size();
        add(variant, speeds);
        fire(first);
    }
}

void Campaign::shoot_design() {
    expected_ = plan_.count;
    while (std::ssize(rows_) < plan_.count) {
        if (without_result_at_end(rows_) >= most_without_result) {
            failures_[0] = fmt::format("{} shots in a row gave no result", most_without_result);
            return;
        }
        std::vector<double> wanted;
        if (comm_.rank() == 0) {
            std::vector<ballistics::Shot> shots;
            for (const auto& trial : trials(0))
                if (trial.result != ballistics::Result::none)
                    shots.push_back({trial.speed, trial.result == ballistics::Result::complete});
            const int left = plan_.count - static_cast<int>(rows_.size());
            wanted = ballistics::next_speeds(plan_.design, shots, std::min(plan_.groups, left));
        }
        const auto first = rows_.size();
        add(0, agreed_speeds(wanted));
        fire(first);
    }
}

std::vector<double> Campaign::agreed_speeds(const std::vector<double>& wanted) const {
    std::vector<std::int32_t> grains;
    for (const double speed : wanted)
        grains.push_back(static_cast<std::int32_t>(std::lround(speed / ballistics::speed_grain)));
    comm_.broadcast(grains);
    std::vector<double> speeds;
    for (const auto grain : grains)
        speeds.push_back(ballistics::rounded_speed(grain * ballistics::speed_grain));
    return speeds;
}

void Campaign::add(std::size_t variant, const std::vector<double>& speeds) {
    for (const double speed : speeds) {
        ShotRow row;
        row.number = static_cast<int>(rows_.size()) + 1;
        row.variant = variant;
        row.speed = speed;
        row.folder = folder_of_shot(row.number, speed);
        rows_.push_back(row);
    }
}

void Campaign::fire(std::size_t first) {
    write();  // what is planned, for a restart
    std::vector<std::int32_t> pending;
    parallel::on_root(comm_, [&] {
        for (std::size_t i = first; i < rows_.size(); ++i)
            if (!is_shot_computed(plan_.scene_of(rows_[i].variant, rows_[i].number, rows_[i].speed),
                                  folder_ / rows_[i].folder))
                pending.push_back(static_cast<std::int32_t>(i));
    });
    comm_.broadcast(pending);
    std::vector<ShotRow> shots;
    for (const auto i : pending) shots.push_back(rows_[static_cast<std::size_t>(i)]);
    const auto finish = [&] {
        for (std::size_t i = 0; i < shots.size(); ++i) rows_[static_cast<std::size_t>(pending[i])] = shots[i];
        read_on_root(first);
        share(first);
        for (std::size_t i = first; i < rows_.size(); ++i) record(rows_[i]);
        write();
    };
    try {
        if (!shots.empty())
            compute_shots(plan_, shots, folder_, comm_, [&](const ShotRow& row) { tell(row); });
    } catch (const Interrupted&) {
        finish();
        throw;
    }
    computed_ += static_cast<int>(shots.size());
    finish();
}

void Campaign::read_on_root(std::size_t first) {
    parallel::on_root(comm_, [&] {
        for (std::size_t i = first; i < rows_.size(); ++i)
            if (!rows_[i].is_failed)
                read_shot(folder_ / rows_[i].folder, plan_.criterion, plan_.direction, rows_[i]);
    });
}

/// What the searches of all ranks depend on.
void Campaign::share(std::size_t first) {
    std::vector<std::int32_t> results;
    for (std::size_t i = first; i < rows_.size(); ++i) {
        results.push_back(static_cast<std::int32_t>(rows_[i].result));
        results.push_back(rows_[i].is_stopped_by_guard ? 1 : 0);
    }
    comm_.broadcast(results);
    for (std::size_t i = first; i < rows_.size(); ++i) {
        rows_[i].result = static_cast<ballistics::Result>(results[2 * (i - first)]);
        rows_[i].is_stopped_by_guard = results[2 * (i - first) + 1] != 0;
    }
}

void Campaign::write() const {
    parallel::on_root(comm_, [&] { io::replace_file(folder_ / "v50.csv", shot_table(plan_, rows_)); });
}

void Campaign::tell(const ShotRow& row) const {
    auto read = row;
    try {
        read_shot(folder_ / row.folder, plan_.criterion, plan_.direction, read);
    } catch (const std::exception&) {
        return;  // told when all shots of the round are read
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const int left = std::max(0, expected_ - row.number);
    const double each = seconds / std::max(1, computed_ + 1);
    // Leaders of groups print for themselves; whole lines, so that they do not mix.
    const auto line =
        fmt::format("  [{}/{}] {}{}: {}; about {} left\n", row.number, std::max(expected_, row.number),
                    row.variant == 0 ? "" : plan_.variants[row.variant].label + ", ",
                    plan_.unit.text(row.speed), text_of_shot(plan_, read), io::duration_text(each * left));
    std::fputs(line.c_str(), stdout);
    std::fflush(stdout);
}

void Campaign::record(const ShotRow& row) const {
    log_.record(fmt::format("  shot {:<8} {}: {}", row.number, plan_.unit.text(row.speed),
                            row.is_done ? text_of_shot(plan_, row) : row.outcome));
}

}  // namespace weavefront::app
