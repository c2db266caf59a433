#pragma once
/// @file
/// Point-to-point sums of node values between ranks.

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/shared_memory_exchange.hpp"

namespace weavefront::parallel {

/// Nodes whose values one rank sends to another: local indices, in the same global order on both ranks.
struct SendList {
    std::vector<std::int32_t> nodes;
    std::size_t dense_count = 0;  ///< values of the first `dense_count` nodes are always sent; of the other
                                  ///< nodes only values that are not zero

    explicit SendList(std::vector<std::int32_t> always = {})
        : nodes(std::move(always)), dense_count(nodes.size()) {}
};

/// Nodes that this rank exchanges with one other rank.
struct Neighbour {
    int rank = 0;
    SendList out, in;

    /// Exchanges the same nodes both ways. @param nodes in the same global order on both ranks
    Neighbour(int other, const std::vector<std::int32_t>& nodes) : rank(other), out(nodes), in(nodes) {}
    Neighbour(int other, SendList sent, SendList received)
        : rank(other), out(std::move(sent)), in(std::move(received)) {}
};

/// Sums node values of type T, an array of integers, over all ranks that share a node. Buffers are allocated
/// once.
template <class T>
class Exchange {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0 &&
                  alignof(T) <= sizeof(std::uint64_t));

  public:
    Exchange() = default;
    explicit Exchange(std::vector<Neighbour> neighbours)
        : neighbours_(std::move(neighbours)), in_memory_(neighbours_.size(), false) {
        make_buffers();
    }

    /// Lets ranks of this host exchange through shared memory from now on, if the host provides it.
    /// `shared_memory` must outlive this exchange, and no other exchange may use it.
    /// @note Collective
    void use(const Communicator& comm, SharedMemoryExchange& shared_memory) {
        shared_memory_ = &shared_memory;
        std::vector<std::size_t> lengths(static_cast<std::size_t>(comm.size()), 0);
        for (const auto& neighbour : neighbours_)
            if (shared_memory.on_this_host(neighbour.rank))
                lengths[static_cast<std::size_t>(neighbour.rank)] = most_bytes(neighbour.out);
        shared_memory.resize(lengths);
        for (std::size_t k = 0; k < neighbours_.size(); ++k)
            in_memory_[k] =
                shared_memory.on_this_host(neighbours_[k].rank);  // false where shared memory was refused
        make_buffers();
    }

    /// Adds the values of other ranks at shared nodes. Every rank contributes its values from before the
    /// call.
    /// @note Collective over the neighbouring ranks; with shared memory over all
    void sum(const Communicator& comm, std::span<T> values) {
        start(comm, values);
        finish(values);
    }

    /// First half of `sum`: sends the values. The caller may read and change `values` until `finish`.
    void start(const Communicator& comm, std::span<const T> values) {
        requests_.clear();
        auto* message = incoming_.data();
        for_each_neighbour(false, [&](const Neighbour& neighbour) {
            const auto bytes = most_bytes(neighbour.in);
            check(MPI_Irecv(message, static_cast<int>(bytes), MPI_BYTE, neighbour.rank, 0, comm.get(),
                            &requests_.emplace_back()));
            message += bytes;
        });
        message = outgoing_.data();
        for_each_neighbour(false, [&](const Neighbour& neighbour) {
            const auto bytes = pack(neighbour.out, values, message);
            check(MPI_Isend(message, static_cast<int>(bytes), MPI_BYTE, neighbour.rank, 0, comm.get(),
                            &requests_.emplace_back()));
            message += most_bytes(neighbour.out);
        });
        for_each_neighbour(true, [&](const Neighbour& neighbour) {
            pack(neighbour.out, values, shared_memory_->outgoing(neighbour.rank));
        });
        if (shared_memory_) shared_memory_->publish();
    }

    /// Second half of `sum`: waits for the values of other ranks and adds them.
    void finish(std::span<T> values) {
        for_each_neighbour(true, [&](const Neighbour& neighbour) {
            add(neighbour.in, shared_memory_->incoming(neighbour.rank), values);
        });
        if (!requests_.empty())
            check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
        const auto* message = incoming_.data();
        for_each_neighbour(false, [&](const Neighbour& neighbour) {
            add(neighbour.in, message, values);
            message += most_bytes(neighbour.in);
        });
    }

    [[nodiscard]] const std::vector<Neighbour>& neighbours() const { return neighbours_; }

  private:
    // A message holds the number of records, the dense values, and a record for each sparse value that is not
    // zero.
    struct Record {
        std::uint64_t place;  ///< position in the node list
        T value;
    };
    static std::size_t bytes(const SendList& list, std::size_t records) {
        return sizeof(std::uint64_t) + list.dense_count * sizeof(T) + records * sizeof(Record);
    }
    static std::size_t most_bytes(const SendList& list) {
        return bytes(list, list.nodes.size() - list.dense_count);
    }

    /// @return bytes of the message
    static std::size_t pack(const SendList& list, std::span<const T> values, std::byte* message) {
        auto* value = reinterpret_cast<T*>(message + sizeof(std::uint64_t));
        for (std::size_t place = 0; place < list.dense_count; ++place)
            *value++ = values[static_cast<std::size_t>(list.nodes[place])];
        auto* record = reinterpret_cast<Record*>(value);
        std::uint64_t records = 0;
        for (std::size_t place = list.dense_count; place < list.nodes.size(); ++place) {
            const auto& sparse = values[static_cast<std::size_t>(list.nodes[place])];
            std::int64_t bits = 0;
            for (const auto part : sparse) bits |= part;
            if (bits != 0) record[records++] = {place, sparse};
        }
        *reinterpret_cast<std::uint64_t*>(message) = records;
        return bytes(list, records);
    }
    static void add(const SendList& list, const std::byte* message, std::span<T> values) {
        const auto add_to = [&](std::int32_t node, const T& there) {
            auto& here = values[static_cast<std::size_t>(node)];
            for (std::size_t i = 0; i < there.size(); ++i) here[i] += there[i];
        };
        const auto* value = reinterpret_cast<const T*>(message + sizeof(std::uint64_t));
        for (std::size_t place = 0; place < list.dense_count; ++place) add_to(list.nodes[place], *value++);
        const auto* record = reinterpret_cast<const Record*>(value);
        for (auto records = *reinterpret_cast<const std::uint64_t*>(message); records > 0;
             --records, ++record)
            add_to(list.nodes[record->place], record->value);
    }

    template <class Use>
    void for_each_neighbour(bool in_memory, Use use) const {
        for (std::size_t k = 0; k < neighbours_.size(); ++k)
            if (in_memory_[k] == in_memory) use(neighbours_[k]);
    }

    /// Allocates buffers for neighbours that are not reached through shared memory.
    void make_buffers() {
        std::size_t sent = 0, received = 0;
        for_each_neighbour(false, [&](const Neighbour& neighbour) {
            sent += most_bytes(neighbour.out);
            received += most_bytes(neighbour.in);
        });
        outgoing_ = std::vector<std::byte>(sent);
        incoming_ = std::vector<std::byte>(received);
        requests_.reserve(2 * neighbours_.size());
    }

    std::vector<Neighbour> neighbours_;  // ranks that share nodes with this one
    std::vector<bool> in_memory_;
    SharedMemoryExchange* shared_memory_ = nullptr;
    std::vector<std::byte> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

}  // namespace weavefront::parallel
