#include "rank_groups.hpp"

namespace weavefront::app {

parallel::Communicator split(const parallel::Communicator& comm, int colour) {
    MPI_Comm part = MPI_COMM_NULL;
    parallel::check(MPI_Comm_split(comm.get(), colour, comm.rank(), &part));
    parallel::Communicator owned(part);
    MPI_Comm_free(&part);
    return owned;
}

}  // namespace weavefront::app
