#include "ranks_apart.hpp"

#include <chrono>
#include <thread>

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

void sleep_until_all_arrive(const parallel::Communicator& comm) {
    MPI_Request arrived = MPI_REQUEST_NULL;
    parallel::check(MPI_Ibarrier(comm.get(), &arrived));
    for (int done = 0; done == 0;) {
        parallel::check(MPI_Test(&arrived, &done, MPI_STATUS_IGNORE));
        if (done == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

}  // namespace weavefront::app
