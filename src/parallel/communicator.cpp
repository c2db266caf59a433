#include "weavefront/parallel/communicator.hpp"

#include <array>
#include <csignal>
#include <exception>
#include <new>
#include <stdexcept>

#include "weavefront/parallel/failure.hpp"

namespace weavefront::parallel {

void check(int code) {
    if (code == MPI_SUCCESS) return;
    std::array<char, MPI_MAX_ERROR_STRING> text{};
    int length = 0;
    MPI_Error_string(code, text.data(), &length);
    throw std::runtime_error("MPI: " + std::string(text.data(), static_cast<std::size_t>(length)));
}

namespace {

/// Blocks termination signals in this thread and in threads that it starts, until its destructor.
class HeldSignals {
  public:
    HeldSignals() {
        sigset_t ends;
        sigemptyset(&ends);
        for (const int signal : {SIGTERM, SIGINT, SIGUSR1, SIGUSR2}) sigaddset(&ends, signal);
        pthread_sigmask(SIG_BLOCK, &ends, &before_);
    }
    ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

  private:
    sigset_t before_{};
};

/// Without this, other ranks would wait for a rank that ran out of memory.
[[noreturn]] void end_without_memory() {
    tell_failure("out of memory");
    end_all_ranks();
}

}  // namespace

Environment::Environment(int* argc, char*** argv) : exceptions_(std::uncaught_exceptions()) {
    int is_initialized = 0;
    check(MPI_Initialized(&is_initialized));
    if (is_initialized != 0) return;
    const HeldSignals held;
    check(MPI_Init(argc, argv));
    is_outermost_ = true;
    check(MPI_Comm_size(MPI_COMM_WORLD, &ranks_));
    if (ranks_ > 1) std::set_new_handler(end_without_memory);
}

Environment::~Environment() {
    if (!is_outermost_) return;
    std::set_new_handler(nullptr);
    if (ranks_ > 1 && std::uncaught_exceptions() > exceptions_)
        return;  // other ranks may not get here; exit without MPI_Finalize ends them
    MPI_Finalize();
}

Communicator::Communicator(MPI_Comm original) {
    check(MPI_Comm_dup(original, &comm_));
    check(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN));
    check(MPI_Comm_rank(comm_, &rank_));
    check(MPI_Comm_size(comm_, &size_));
}

Communicator::~Communicator() {
    if (comm_ != MPI_COMM_NULL) MPI_Comm_free(&comm_);
}

Communicator::Communicator(Communicator&& other) noexcept
    : comm_(other.comm_), rank_(other.rank_), size_(other.size_) {
    other.comm_ = MPI_COMM_NULL;
}

void Communicator::sum(std::span<std::int64_t> values) const {
    if (size_ == 1) return;
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_SUM,
                        comm_));
}

double Communicator::min(double value) const {
    if (size_ > 1) check(MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MIN, comm_));
    return value;
}

double Communicator::max(double value) const {
    if (size_ > 1) check(MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, comm_));
    return value;
}

void Communicator::max(std::span<double> values) const {
    if (size_ == 1) return;
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                        comm_));
}

void Communicator::min(std::span<std::int64_t> values) const {
    if (size_ == 1) return;
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_MIN,
                        comm_));
}

bool Communicator::any(bool value) const {
    std::int64_t count = value ? 1 : 0;
    sum({&count, 1});
    return count > 0;
}

std::string Communicator::broadcast(std::string text) const {
    if (size_ == 1) return text;
    auto length = static_cast<std::int64_t>(text.size());
    check(MPI_Bcast(&length, 1, MPI_INT64_T, 0, comm_));
    text.resize(static_cast<std::size_t>(length));
    check(MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, 0, comm_));
    return text;
}

void Communicator::broadcast(std::vector<std::int32_t>& values) const {
    if (size_ == 1) return;
    auto length = static_cast<std::int64_t>(values.size());
    check(MPI_Bcast(&length, 1, MPI_INT64_T, 0, comm_));
    values.resize(static_cast<std::size_t>(length));
    check(MPI_Bcast(values.data(), static_cast<int>(length), MPI_INT32_T, 0, comm_));
}

}  // namespace weavefront::parallel
