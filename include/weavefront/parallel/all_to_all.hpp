#pragma once
/// @file
/// Messages of any length from every rank to every rank.

#include <numeric>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/item_type.hpp"

namespace weavefront::parallel {

/// Sends outgoing[r] to rank r. T is trivially copyable.
/// @return by rank: the items that it sent to this rank
/// @note Collective
template <class T>
std::vector<std::vector<T>> all_to_all(const Communicator& comm,
                                       const std::vector<std::vector<T>>& outgoing) {
    const auto ranks = static_cast<std::size_t>(comm.size());
    const ItemType item(sizeof(T));
    std::vector<int> sent(ranks), received(ranks), send_at(ranks), receive_at(ranks);
    for (std::size_t r = 0; r < ranks; ++r) sent[r] = static_cast<int>(outgoing[r].size());
    check(MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, comm.get()));
    std::exclusive_scan(sent.begin(), sent.end(), send_at.begin(), 0);
    std::exclusive_scan(received.begin(), received.end(), receive_at.begin(), 0);
    std::vector<T> send, receive(static_cast<std::size_t>(receive_at.back() + received.back()));
    for (const auto& items : outgoing) send.insert(send.end(), items.begin(), items.end());
    check(MPI_Alltoallv(send.data(), sent.data(), send_at.data(), item.get(), receive.data(), received.data(),
                        receive_at.data(), item.get(), comm.get()));
    std::vector<std::vector<T>> incoming(ranks);
    for (std::size_t r = 0; r < ranks; ++r)
        incoming[r].assign(receive.begin() + receive_at[r], receive.begin() + receive_at[r] + received[r]);
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
