#include "weavefront/parallel/communicator.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace weavefront::parallel {

void check(int code) {
    if (code == MPI_SUCCESS) return;
    std::array<char, MPI_MAX_ERROR_STRING> text{};
    int length = 0;
    MPI_Error_string(code, text.data(), &length);
    throw std::runtime_error("MPI: " + std::string(text.data(), static_cast<std::size_t>(length)));
}

namespace {

/// A rank without memory would leave the others waiting for it.
[[noreturn]] void end_all_ranks() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    std::fprintf(stderr, "weavefront: error: rank %d is out of memory\n", rank);
    MPI_Abort(MPI_COMM_WORLD, 3);
    std::abort();
}

}  // namespace

Environment::Environment(int* argc, char*** argv) {
    check(MPI_Init(argc, argv));
    int ranks = 1;
    check(MPI_Comm_size(MPI_COMM_WORLD, &ranks));
    if (ranks > 1) std::set_new_handler(end_all_ranks);
}

Environment::~Environment() {
    std::set_new_handler(nullptr);
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

Communicator::Communicator(Communicator&& other) noexcept : comm_(other.comm_), rank_(other.rank_), size_(other.size_) {
    other.comm_ = MPI_COMM_NULL;
}

void Communicator::sum(std::span<std::int64_t> values) const {
    if (size_ == 1) return;
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_SUM, comm_));
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
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, comm_));
}

void Communicator::min(std::span<std::int64_t> values) const {
    if (size_ == 1) return;
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_INT64_T, MPI_MIN, comm_));
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
