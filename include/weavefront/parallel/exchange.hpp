#pragma once
/// @file
/// Point-to-point sums of node values between ranks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

/// What this rank shares with one other: local node indices, in the same global order on both sides.
struct Link {
    int rank = 0;
    std::vector<std::int32_t> nodes;
};

/// Sums arrays of type T (trivially copyable) over all ranks that are linked at a node. Buffers live as long as the exchange.
template <class T>
class Exchange {
  public:
    Exchange() = default;
    explicit Exchange(std::vector<Link> links) : links_(std::move(links)) {
        std::size_t items = 0;
        for (const auto& link : links_) items += link.nodes.size();
        outgoing_.resize(items);
        incoming_.resize(items);
        requests_.reserve(2 * links_.size());
    }

    /// Adds what the other ranks hold of shared nodes: values[n] += the other's values[n], as they were before the call.
    /// @note Collective over the linked ranks
    void sum(const Communicator& comm, std::span<T> values) {
        start(comm, values);
        finish(values);
    }

    /// The first half of `sum`: sends. `values` may be read and written until `finish`.
    void start(const Communicator& comm, std::span<const T> values) {
        requests_.clear();
        std::size_t at = 0;
        for (const auto& link : links_) {
            check(MPI_Irecv(incoming_.data() + at, bytes(link), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
            at += link.nodes.size();
        }
        at = 0;
        for (const auto& link : links_) {
            const std::size_t first = at;
            for (const auto node : link.nodes) outgoing_[at++] = values[static_cast<std::size_t>(node)];
            check(MPI_Isend(outgoing_.data() + first, bytes(link), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
        }
    }

    /// The second half of `sum`: waits and adds.
    void finish(std::span<T> values) {
        check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
        std::size_t at = 0;
        for (const auto& link : links_)
            for (const auto node : link.nodes) {
                auto& here = values[static_cast<std::size_t>(node)];
                const T& there = incoming_[at++];
                for (std::size_t i = 0; i < there.size(); ++i) here[i] += there[i];
            }
    }

    [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  private:
    static int bytes(const Link& link) { return static_cast<int>(link.nodes.size() * sizeof(T)); }

    std::vector<Link> links_;  // none without nodes
    std::vector<T> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

}  // namespace weavefront::parallel
