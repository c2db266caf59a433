#include "spread_ranks.hpp"

namespace weavefront::app {

std::optional<parallel::Communicator> first_ranks(const parallel::Communicator& comm, int count) {
    MPI_Comm part = MPI_COMM_NULL;
    const bool among = comm.rank() < count;
    parallel::check(MPI_Comm_split(comm.get(), among ? 0 : MPI_UNDEFINED, comm.rank(), &part));
    if (!among) return {};
    std::optional<parallel::Communicator> owned(std::in_place, part);
    MPI_Comm_free(&part);
    return owned;
}

}  // namespace weavefront::app
