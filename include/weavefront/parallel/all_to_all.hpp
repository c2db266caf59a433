#pragma once
/// @file
/// Messages of any length from every rank to every rank.

#include <numeric>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// Sends outgoing[r] to rank r; returns what each rank sent here. T is trivially copyable. @note Collective
template <class T>
std::vector<std::vector<T>> all_to_all(const Communicator& comm, const std::vector<std::vector<T>>& outgoing) {
    const auto ranks = static_cast<std::size_t>(comm.size());
    std::vector<int> send_bytes(ranks), receive_bytes(ranks), send_at(ranks), receive_at(ranks);
    for (std::size_t r = 0; r < ranks; ++r) send_bytes[r] = static_cast<int>(outgoing[r].size() * sizeof(T));
    check(MPI_Alltoall(send_bytes.data(), 1, MPI_INT, receive_bytes.data(), 1, MPI_INT, comm.get()));
    std::exclusive_scan(send_bytes.begin(), send_bytes.end(), send_at.begin(), 0);
    std::exclusive_scan(receive_bytes.begin(), receive_bytes.end(), receive_at.begin(), 0);
    std::vector<T> send, receive(static_cast<std::size_t>(receive_at.back() + receive_bytes.back()) / sizeof(T));
    for (const auto& items : outgoing) send.insert(send.end(), items.begin(), items.end());
    check(MPI_Alltoallv(send.data(), send_bytes.data(), send_at.data(), MPI_BYTE, receive.data(), receive_bytes.data(), receive_at.data(),
                        MPI_BYTE, comm.get()));
    std::vector<std::vector<T>> incoming(ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
        const auto* first = receive.data() + static_cast<std::size_t>(receive_at[r]) / sizeof(T);
        incoming[r].assign(first, first + static_cast<std::size_t>(receive_bytes[r]) / sizeof(T));
    }
    return incoming;
}

/// The value of every rank, in rank order. T is trivially copyable. @note Collective
template <class T>
std::vector<T> all_gather(const Communicator& comm, const T& value) {
    std::vector<T> values(static_cast<std::size_t>(comm.size()));
    check(MPI_Allgather(&value, sizeof(T), MPI_BYTE, values.data(), sizeof(T), MPI_BYTE, comm.get()));
    return values;
}

}  // namespace weavefront::parallel
