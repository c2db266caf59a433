#pragma once
/// @file
/// Point-to-point sums of node values between ranks.

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/mailboxes.hpp"

namespace weavefront::parallel {

/// What travels one way over a link: local node indices, in the same order on both sides.
struct Share {
    std::vector<std::int32_t> nodes;
    std::size_t whole = 0;  ///< the values of so many, the first ones, always travel; of the others those that are not zero

    explicit Share(std::vector<std::int32_t> always = {}) : nodes(std::move(always)), whole(nodes.size()) {}
};

/// What this rank exchanges with one other.
struct Link {
    int rank = 0;
    Share out, in;

    /// Sums of the same nodes both ways, in the same global order on both sides.
    Link(int other, const std::vector<std::int32_t>& nodes) : rank(other), out(nodes), in(nodes) {}
    Link(int other, Share sent, Share received) : rank(other), out(std::move(sent)), in(std::move(received)) {}
};

/// Sums arrays of type T, which has some integers, over all ranks that are linked at a node. Buffers live as long as the exchange.
template <class T>
class Exchange {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0 && alignof(T) <= sizeof(std::uint64_t));

  public:
    Exchange() = default;
    explicit Exchange(std::vector<Link> links) : links_(std::move(links)), by_mail_(links_.size(), false) { make_buffers(); }

    /// From now on ranks of this host tell each other through mailboxes, where these have memory; no other exchange uses them then.
    /// @note Collective
    void use(const Communicator& comm, Mailboxes& mailboxes) {
        mailboxes_ = &mailboxes;
        std::vector<std::size_t> lengths(static_cast<std::size_t>(comm.size()), 0);
        for (const auto& link : links_)
            if (mailboxes.reach(link.rank)) lengths[static_cast<std::size_t>(link.rank)] = most_bytes(link.out);
        mailboxes.open(lengths);
        for (std::size_t k = 0; k < links_.size(); ++k) by_mail_[k] = mailboxes.reach(links_[k].rank);  // unless it had no memory
        make_buffers();
    }

    /// Adds what the other ranks hold of shared nodes: values[n] += the other's values[n], as they were before the call.
    /// @note Collective over the linked ranks; with mailboxes over all
    void sum(const Communicator& comm, std::span<T> values) {
        start(comm, values);
        finish(values);
    }

    /// The first half of `sum`: sends. `values` may be read and written until `finish`.
    void start(const Communicator& comm, std::span<const T> values) {
        requests_.clear();
        auto* message = incoming_.data();
        for_each_link(false, [&](const Link& link) {
            const auto bytes = most_bytes(link.in);
            check(MPI_Irecv(message, static_cast<int>(bytes), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
            message += bytes;
        });
        message = outgoing_.data();
        for_each_link(false, [&](const Link& link) {
            const auto bytes = pack(link.out, values, message);
            check(MPI_Isend(message, static_cast<int>(bytes), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
            message += most_bytes(link.out);
        });
        for_each_link(true, [&](const Link& link) { pack(link.out, values, mailboxes_->outgoing(link.rank)); });
        if (mailboxes_) mailboxes_->post();
    }

    /// The second half of `sum`: waits and adds.
    void finish(std::span<T> values) {
        for_each_link(true, [&](const Link& link) { add(link.in, mailboxes_->incoming(link.rank), values); });
        if (!requests_.empty()) check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
        const auto* message = incoming_.data();
        for_each_link(false, [&](const Link& link) {
            add(link.in, message, values);
            message += most_bytes(link.in);
        });
    }

    [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  private:
    // A message: the number of records, the values that always travel, and a record of each other one that is not zero.
    struct Record {
        std::uint64_t place;  ///< among the nodes of the share
        T value;
    };
    static std::size_t bytes(const Share& share, std::size_t records) {
        return sizeof(std::uint64_t) + share.whole * sizeof(T) + records * sizeof(Record);
    }
    static std::size_t most_bytes(const Share& share) { return bytes(share, share.nodes.size() - share.whole); }

    /// @return bytes of the message
    static std::size_t pack(const Share& share, std::span<const T> values, std::byte* message) {
        auto* value = reinterpret_cast<T*>(message + sizeof(std::uint64_t));
        for (std::size_t place = 0; place < share.whole; ++place) *value++ = values[static_cast<std::size_t>(share.nodes[place])];
        auto* record = reinterpret_cast<Record*>(value);
        std::uint64_t records = 0;
        for (std::size_t place = share.whole; place < share.nodes.size(); ++place) {
            const auto& sparse = values[static_cast<std::size_t>(share.nodes[place])];
            std::int64_t bits = 0;
            for (const auto part : sparse) bits |= part;
            if (bits != 0) record[records++] = {place, sparse};
        }
        *reinterpret_cast<std::uint64_t*>(message) = records;
        return bytes(share, records);
    }
    static void add(const Share& share, const std::byte* message, std::span<T> values) {
        const auto add_to = [&](std::int32_t node, const T& there) {
            auto& here = values[static_cast<std::size_t>(node)];
            for (std::size_t i = 0; i < there.size(); ++i) here[i] += there[i];
        };
        const auto* value = reinterpret_cast<const T*>(message + sizeof(std::uint64_t));
        for (std::size_t place = 0; place < share.whole; ++place) add_to(share.nodes[place], *value++);
        const auto* record = reinterpret_cast<const Record*>(value);
        for (auto records = *reinterpret_cast<const std::uint64_t*>(message); records > 0; --records, ++record)
            add_to(share.nodes[record->place], record->value);
    }

    template <class Use>
    void for_each_link(bool by_mail, Use use) const {
        for (std::size_t k = 0; k < links_.size(); ++k)
            if (by_mail_[k] == by_mail) use(links_[k]);
    }

    /// For what does not go by mail.
    void make_buffers() {
        std::size_t sent = 0, received = 0;
        for_each_link(false, [&](const Link& link) {
            sent += most_bytes(link.out);
            received += most_bytes(link.in);
        });
        outgoing_ = std::vector<std::byte>(sent);
        incoming_ = std::vector<std::byte>(received);
        requests_.reserve(2 * links_.size());
    }

    std::vector<Link> links_;  // none without nodes
    std::vector<bool> by_mail_;
    Mailboxes* mailboxes_ = nullptr;
    std::vector<std::byte> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

}  // namespace weavefront::parallel
