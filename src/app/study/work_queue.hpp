#pragma once
/// @file
/// Work handed out to groups of ranks, and how much of it is done.

#include <mpi.h>

#include <cstdint>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Counters on rank 0 that every rank can read and raise without its help.
class WorkQueue {
  public:
    /// @note Collective, as is the end of its life
    explicit WorkQueue(const parallel::Communicator& comm);
    ~WorkQueue();
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;

    /// The next of 0, 1, 2, ..., each given to one caller.
    std::int64_t next() { return raise(0, 1); }
    /// Adds to what is done. @returns all that is done
    std::int64_t done(std::int64_t amount) { return raise(1, amount) + amount; }
    /// Counts a finished variant. @returns how many there are
    std::int64_t finished() { return raise(2, 1) + 1; }

  private:
    std::int64_t raise(int counter, std::int64_t by);

    int exceptions_;  ///< under way when this was made
    MPI_Win window_ = MPI_WIN_NULL;
    std::int64_t* counters_ = nullptr;
};

}  // namespace weavefront::app
