#include "study_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "rank_groups.hpp"
#include "signals.hpp"
#include "stop.hpp"
#include "variant_run.hpp"
#include "weavefront/io/progress.hpp"
#include "weavefront/parallel/failure.hpp"
#include "weavefront/parallel/on_root.hpp"
#include "work_queue.hpp"

namespace weavefront::app {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class StudyRun {
  public:
    StudyRun(const scene::Study& study, std::span<const StudyEntry> entries,
             const std::filesystem::path& folder, const parallel::Communicator& comm, io::Log& log)
        : study_(study),
          entries_(entries),
          folder_(folder),
          comm_(comm),
          log_(log),
          work_queue_(std::in_place, comm) {}

    void run() {
        choose_pending();
        const study::RankPlan plan = study::plan_ranks(jobs_, comm_.size());
        say(plan);
        for (std::size_t i = 0; i < plan.together && !comm_.any(noted_signal() != 0); ++i)
            compute_together(plan.order[i]);
        compute_side_by_side(plan);
        work_queue_.reset();  // all ranks are here; after an exception its window would outlive MPI
        raise_failure();
    }

  private:
    void choose_pending() {
        std::vector<std::int32_t> pending;
        parallel::on_root(comm_, [&] {
            for (std::size_t i = 0; i < entries_.size(); ++i)
                if (!is_computed(study_.compute, entries_[i].input, folder_of(i)))
                    pending.push_back(static_cast<std::int32_t>(i));
        });
        comm_.broadcast(pending);
        for (const std::int32_t i : pending) {
            pending_.push_back(static_cast<std::size_t>(i));
            jobs_.push_back(job_of(study_.compute, entries_[static_cast<std::size_t>(i)].input));
            total_ += jobs_.back().cost;
        }
    }

    [[nodiscard]] std::filesystem::path folder_of(std::size_t entry) const {
        return folder_ / entries_[entry].variant.name;
    }

    void say(const study::RankPlan& plan) {
        const std::size_t before = entries_.size() - pending_.size();
        log_.info(fmt::format("  variants      {}, of them {} computed before", entries_.size(), before));
        if (pending_.empty()) return;
        std::string text;
        if (plan.together > 0)
            text += fmt::format("the longest {} on all {}, one after another", plan.together, comm_.size());
        const std::size_t rest = pending_.size() - plan.together;
        if (rest > 0 && plan.together > 0) text += "; then ";
        if (rest > 0)
            text += plan.groups > 1 ? fmt::format("{} by {} groups side by side", rest, plan.groups)
                                    : "one variant after another";
        log_.info(fmt::format("  ranks         {}: {}", comm_.size(), text));
    }

    void compute_together(std::size_t job) {
        const bool takes_part = comm_.rank() < jobs_[job].columns;
        const parallel::Communicator group = split(comm_, takes_part ? 0 : 1);
        if (takes_part) compute(job, group);
    }

    void compute_side_by_side(const study::RankPlan& plan) {
        const std::size_t rest = pending_.size() - plan.together;
        const parallel::Communicator group =
            split(comm_, study::group_of(comm_.rank(), comm_.size(), plan.groups));
        for (;;) {
            std::vector<std::int32_t> next(1);
            const bool goes_on = !group.any(noted_signal() != 0);
            if (group.rank() == 0)
                next[0] = goes_on ? static_cast<std::int32_t>(
                                        std::min<std::int64_t>(work_queue_->next(), std::ssize(pending_)))
                                  : -1;
            group.broadcast(next);
            if (next[0] < 0 || static_cast<std::size_t>(next[0]) >= rest) return;
            const std::size_t job = plan.order[plan.together + static_cast<std::size_t>(next[0])];
            const bool takes_part = group.rank() < jobs_[job].columns;
            const parallel::Communicator part = split(group, takes_part ? 0 : 1);
            if (takes_part) compute(job, part);
        }
    }

    void compute(std::size_t job, const parallel::Communicator& group) {
        const std::size_t entry = pending_[job];
        const Clock::time_point begin = Clock::now();
        std::string failure;
        try {
            compute_variant(study_.compute, entries_[entry].input, folder_of(entry), group);
        } catch (const Interrupted&) {
            return;
        } catch (const std::exception& error) {
            failure = entries_[entry].variant.name + ": " + parallel::text_of(error);
        }
        parallel::meet(group,
                       failure);  // all ranks of the group fail alike, or else end; the other groups go on
        if (failure_.empty()) failure_ = failure;
        if (group.rank() == 0) tell(job, seconds_since(begin));
    }

    void tell(std::size_t job, double seconds) {
        // In parts of a billion, since the counters are whole numbers.
        const auto done =
            static_cast<double>(work_queue_->done(std::llround(jobs_[job].cost / total_ * 1e9))) / 1e9;
        const double left = done > 0 ? seconds_since(begin_) * (1 - std::min(done, 1.0)) / done : 0;
        const std::int64_t finished = work_queue_->finished();
        const std::string name = entries_[pending_[job]].variant.name;
        // Leaders of groups print for themselves; whole lines, so that they do not mix.
        const std::string line = fmt::format("  [{}/{}] {}: {:.2f} s, {} left\n", finished, pending_.size(),
                                             name, seconds, io::duration_text(left));
        std::fputs(line.c_str(), stdout);
        std::fflush(stdout);
    }

    void raise_failure() {
        if (const int signal = static_cast<int>(comm_.max(noted_signal())); signal != 0)
            throw Interrupted(
                fmt::format("{} received: computed variants are kept, the same command goes on from them",
                            name_of_signal(signal)));
        const auto failure = parallel::first_failure(comm_, failure_);
        if (!failure.empty()) throw std::runtime_error(failure);
    }

    const scene::Study& study_;
    std::span<const StudyEntry> entries_;
    std::filesystem::path folder_;
    const parallel::Communicator& comm_;
    io::Log& log_;
    std::optional<WorkQueue> work_queue_;
    std::vector<std::size_t> pending_;  // entries to compute
    std::vector<study::Job> jobs_;      // one each
    double total_ = 0;
    std::string failure_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

void run_study(const scene::Study& study, std::span<const StudyEntry> entries,
               const std::filesystem::path& folder, const parallel::Communicator& comm, io::Log& log) {
    StudyRun(study, entries, folder, comm, log).run();
}

}  // namespace weavefront::app
