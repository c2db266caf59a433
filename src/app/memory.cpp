#include "memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "weavefront/io/host_memory.hpp"
#include "weavefront/parallel/failure.hpp"

namespace weavefront::app {

namespace {

// Of a column, on the rank that distributes columns among several.
constexpr double of_partition = 3600;

/// Ranks on the machine of this one. @note Collective
int ranks_here(const parallel::Communicator& comm) {
    MPI_Comm host = MPI_COMM_NULL;
    int ranks = 1;
    parallel::check(MPI_Comm_split_type(comm.get(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &host));
    parallel::check(MPI_Comm_size(host, &ranks));
    MPI_Comm_free(&host);
    return ranks;
}

}  // namespace

// Peaks of runs of the small scene of tests/command_line, less the 26 MB of the program, per element with its
// node. The first numbers are without, the second ones with a checkpoint every other step.
//   plies of columns | ranks | bytes per element | a checkpoint more
//    2 of  40,000    |   1   |   821, 1132       |  311
//    2 of 160,000    |   1   |   822, 1029       |  207
//   30 of  10,000    |   1   |   733,  935       |  202
//   30 of  10,000    |   2   |   795, 1070       |  276
//    2 of 160,000    |   2   | METIS: 575 MB on the first rank, before any rank has elements
// A column takes a part of its own. A checkpoint is always counted: a signal may ask for one.
double memory_needed(const mesh::Panel& panel) {
    constexpr double of_element = 500, of_node = 250, of_ply = 700, of_column = 300, of_checkpoint = 320;
    const auto elements = static_cast<double>(panel.elements());
    return (of_element + of_checkpoint) * elements + of_node * static_cast<double>(panel.nodes()) +
           of_ply * static_cast<double>(panel.plies.size()) +
           of_column * static_cast<double>(panel.columns());
}

double memory_here() { return io::host_memory(); }

std::string bytes_text(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

void require_memory(const mesh::Panel& panel, const parallel::Communicator& comm, int models) {
    const int ranks = ranks_here(comm);
    const double of_ranks = std::max(
                     memory_needed(panel) * models / comm.size() * ranks,
                     comm.size() > 1 ? of_partition * models * static_cast<double>(panel.columns()) : 0),
                 here = memory_here();
    const auto lack = parallel::first_failure(
        comm,
        of_ranks <= here
            ? ""
            : fmt::format(
                  "the target has {} elements, which need about {} on the {} of {} ranks that run on one "
                  "machine, and it has {} to give: use more machines or a coarser mesh",
                  panel.elements(), bytes_text(of_ranks), ranks, comm.size(), bytes_text(here)));
    if (!lack.empty()) throw std::runtime_error(lack);
}

}  // namespace weavefront::app
