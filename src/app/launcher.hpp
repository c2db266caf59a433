#pragma once
/// @file
/// What the launcher of a parallel job, mpirun or srun, says of the processes that it has started.

namespace weavefront::app {

/// Whether this is the first of the processes that were started together, as far as the launcher's
/// environment tells: it is the one that prints, also before MPI is there or without it.
bool is_first_process();

/// Processes that the launcher has started together, as far as its environment tells; 1: this one alone.
int launched_processes();

/// Refuses to go on where the launcher has started several processes that do not know each other, as when
/// mpirun belongs to another MPI than the one that Weavefront was built with: each would compute the whole
/// run by itself.
/// @param ranks that MPI sees
/// @throws scene::InputError
void require_one_job(int ranks);

}  // namespace weavefront::app
