#pragma once
/// @file
/// Point-to-point exchange of node values between ranks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// What this rank sends to, and receives from, one other rank: local node indices, in the same global order on both sides.
struct Link {
    int rank = 0;
    std::vector<std::int32_t> send;
    std::vector<std::int32_t> receive;
};

/// Moves values of type T (trivially copyable) along links. Buffers live as long as the exchange.
template <class T>
class Exchange {
  public:
    Exchange() = default;
    explicit Exchange(std::vector<Link> links) : links_(std::move(links)) {
        std::size_t send = 0, receive = 0;
        for (const auto& link : links_) send += link.send.size(), receive += link.receive.size();
        outgoing_.resize(send);
        incoming_.resize(receive);
    }

    /// Adds what the other ranks hold of shared nodes: values[receive] += the sender's values[send], as they were before the call.
    /// @note Collective over the linked ranks
    void sum(const Communicator& comm, std::span<T> values) {
        transfer(comm, values, [](T& here, const T& there) {
            for (std::size_t i = 0; i < there.size(); ++i) here[i] += there[i];
        });
    }

    /// Overwrites values[receive] with the sender's values[send]. @note Collective over the linked ranks
    void copy(const Communicator& comm, std::span<T> values) {
        transfer(comm, values, [](T& here, const T& there) { here = there; });
    }

    [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  private:
    template <class Combine>
    void transfer(const Communicator& comm, std::span<T> values, Combine combine) {
        if (links_.empty()) return;
        requests_.clear();
        std::size_t at = 0;
        for (const auto& link : links_) {
            post(link.receive.size(), [&](int bytes, MPI_Request* request) {
                return MPI_Irecv(incoming_.data() + at, bytes, MPI_BYTE, link.rank, 0, comm.get(), request);
            });
            at += link.receive.size();
        }
        at = 0;
        for (const auto& link : links_) {
            for (std::size_t i = 0; i < link.send.size(); ++i) outgoing_[at + i] = values[static_cast<std::size_t>(link.send[i])];
            post(link.send.size(), [&](int bytes, MPI_Request* request) {
                return MPI_Isend(outgoing_.data() + at, bytes, MPI_BYTE, link.rank, 0, comm.get(), request);
            });
            at += link.send.size();
        }
        check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
        at = 0;
        for (const auto& link : links_)
            for (const auto node : link.receive) combine(values[static_cast<std::size_t>(node)], incoming_[at++]);
    }

    template <class Call>
    void post(std::size_t items, Call call) {
        if (items == 0) return;
        check(call(static_cast<int>(items * sizeof(T)), &requests_.emplace_back()));
    }

    std::vector<Link> links_;
    std::vector<T> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

}  // namespace weavefront::parallel
