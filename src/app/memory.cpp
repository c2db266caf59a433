#include "memory.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "weavefront/io/host_memory.hpp"
#include "weavefront/parallel/failure.hpp"

namespace weavefront::app {

namespace {

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

double memory_needed(const mesh::Panel& panel) {
    // As measured on 3,000 and 10,000 plies of 1 to 100 elements, and on the large panel of
    // examples/large_panel, whose set-up takes the most.
    constexpr double of_element = 400, of_node = 250, of_ply = 700;
    return of_element * static_cast<double>(panel.elements()) + of_node * static_cast<double>(panel.nodes()) +
           of_ply * static_cast<double>(panel.plies.size());
}

double memory_here() { return io::host_memory(); }

std::string bytes_text(double bytes) {
    return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

void require_memory(const mesh::Panel& panel, const parallel::Communicator& comm) {
    const int ranks = ranks_here(comm);
    const double of_ranks = memory_needed(panel) / comm.size() * ranks, here = memory_here();
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
