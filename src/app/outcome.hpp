#pragma once
/// @file
/// How the program ends.

#include <functional>
#include <string>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Exit status.
enum class Status : int { done = 0, stopped = 1, bad_input = 2, system_error = 3, interrupted = 4 };

/// Exit status and what is told to standard error, one line each.
struct Outcome {
    Status status = Status::done;
    std::vector<std::string> messages;
};

/// Runs `action`. @return the outcome that belongs to what it throws
Outcome outcome_of(const std::function<void()>& action);

/// Tells the outcome where this is the first process. @return exit status
int report(const Outcome& outcome);

/// The same for an outcome that all ranks have, or rank 0 alone: it is told once. Where another rank has
/// failed otherwise, each one that failed tells its own and all ranks end with status 3; so they do when one
/// has failed and others do not arrive within seconds.
/// @return exit status: that of rank 0, done on the other ranks
/// @note Collective
int report_together(const Outcome& outcome, const parallel::Communicator& comm);

/// @throws scene::InputError on all ranks, naming the difference, when ranks were started with different
/// arguments
/// @note Collective
void require_same_arguments(const std::vector<std::string>& arguments, const parallel::Communicator& comm);

/// Has `action` run at the end of the program, when MPI has ended: not every MPI lets programs be started
/// before.
void run_at_end(std::function<void()> action);

/// Runs what is to be run now.
void run_end();

}  // namespace weavefront::app
