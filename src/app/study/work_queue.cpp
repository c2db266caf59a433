#include "work_queue.hpp"

#include <algorithm>
#include <exception>

namespace weavefront::app {

namespace {
constexpr int counters = 3;
}

WorkQueue::WorkQueue(const parallel::Communicator& comm) : exceptions_(std::uncaught_exceptions()) {
    const MPI_Aint bytes = comm.rank() == 0 ? counters * static_cast<MPI_Aint>(sizeof(std::int64_t)) : 0;
    parallel::check(MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, comm.get(),
                                     static_cast<void*>(&counters_), &window_));
    parallel::check(MPI_Win_lock_all(0, window_));
    if (comm.rank() == 0) std::fill_n(counters_, counters, 0);
    parallel::check(MPI_Win_sync(window_));
    parallel::check(MPI_Barrier(comm.get()));
}

WorkQueue::~WorkQueue() {
    if (std::uncaught_exceptions() > exceptions_) return;  // the others may not get here
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
}

std::int64_t WorkQueue::raise(int counter, std::int64_t by) {
    std::int64_t before = 0;
    parallel::check(MPI_Fetch_and_op(&by, &before, MPI_INT64_T, 0, counter, MPI_SUM, window_));
    parallel::check(MPI_Win_flush(0, window_));
    return before;
}

}  // namespace weavefront::app
