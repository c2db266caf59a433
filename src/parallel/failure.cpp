#include "weavefront/parallel/failure.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <thread>

namespace weavefront::parallel {

namespace {

// Ranks that fail for the same reason arrive within the time that it takes to free their memory.
constexpr auto patience = std::chrono::seconds(5);
// Ranks that do not fail first end what they are at, such as a write to a slow disk.
constexpr auto patience_in_agreement = std::chrono::seconds(10);
constexpr auto between_looks = std::chrono::milliseconds(1);
// MPICH's mpiexec drops what it has not read yet of a rank's messages when a rank calls MPI_Abort.
constexpr auto time_to_be_read = std::chrono::milliseconds(300);

/// Waits, asleep, for a request that the other ranks take part in. A rank with a failure waits for some time
/// only.
void wait_asleep(MPI_Request& request, const std::string& failure, std::chrono::seconds longest) {
    const auto deadline = std::chrono::steady_clock::now() + longest;
    for (;;) {
        int done = 0;
        check(MPI_Test(&request, &done, MPI_STATUS_IGNORE));
        if (done != 0) return;
        if (!failure.empty() && std::chrono::steady_clock::now() > deadline) {
            tell_failure(failure);
            end_all_ranks();
        }
        std::this_thread::sleep_for(between_looks);
    }
}

}  // namespace

std::string text_of(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
    if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
        return of_file->path1().string() + ": " + of_file->code().message();
    return error.what();
}

void tell_failure(const std::string& message) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::fprintf(stderr, "weavefront: error: rank %d: %s\n", rank, message.c_str());
    std::fflush(stderr);
}

void end_all_ranks() {
    std::this_thread::sleep_for(time_to_be_read);
    MPI_Abort(MPI_COMM_WORLD, 3);
    std::abort();
}

void meet(const Communicator& comm, const std::string& failure) {
    if (comm.size() == 1) return;
    MPI_Request all_here = MPI_REQUEST_NULL;
    check(MPI_Ibarrier(comm.get(), &all_here));
    wait_asleep(all_here, failure, patience);
}

std::string first_failure(const Communicator& comm, const std::string& failure) {
    if (comm.size() == 1) return failure;
    const int candidate = failure.empty() ? comm.size() : comm.rank();
    int speaker = candidate;
    MPI_Request all_told = MPI_REQUEST_NULL;
    check(MPI_Iallreduce(&candidate, &speaker, 1, MPI_INT, MPI_MIN, comm.get(), &all_told));
    if (failure.empty())
        check(MPI_Wait(&all_told, MPI_STATUS_IGNORE));
    else
        wait_asleep(all_told, failure, patience_in_agreement);
    if (speaker == comm.size()) return {};
    std::string text = failure;
    int length = static_cast<int>(text.size());
    check(MPI_Bcast(&length, 1, MPI_INT, speaker, comm.get()));
    text.resize(static_cast<std::size_t>(length));
    check(MPI_Bcast(text.data(), length, MPI_CHAR, speaker, comm.get()));
    return text;
}

}  // namespace weavefront::parallel
