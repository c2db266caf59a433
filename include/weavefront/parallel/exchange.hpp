#pragma once
/// @file
/// Point-to-point sums of node values between ranks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/mailboxes.hpp"

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
    explicit Exchange(std::vector<Link> links) : links_(std::move(links)), by_mail_(links_.size(), false) { make_buffers(); }

    /// From now on ranks of this host tell each other through mailboxes, which no other exchange uses then.
    /// @note Collective
    void use(const Communicator& comm, Mailboxes& mailboxes) {
        mailboxes_ = &mailboxes;
        std::vector<std::size_t> lengths(static_cast<std::size_t>(comm.size()), 0);
        for (std::size_t k = 0; k < links_.size(); ++k) {
            by_mail_[k] = mailboxes.reach(links_[k].rank);
            if (by_mail_[k]) lengths[static_cast<std::size_t>(links_[k].rank)] = links_[k].nodes.size() * sizeof(T);
        }
        mailboxes.open(lengths);
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
        std::size_t at = 0;
        for_each_link(false, [&](const Link& link) {
            check(MPI_Irecv(incoming_.data() + at, bytes(link), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
            at += link.nodes.size();
        });
        at = 0;
        for_each_link(false, [&](const Link& link) {
            pack(link, values, outgoing_.data() + at);
            check(MPI_Isend(outgoing_.data() + at, bytes(link), MPI_BYTE, link.rank, 0, comm.get(), &requests_.emplace_back()));
            at += link.nodes.size();
        });
        for_each_link(true, [&](const Link& link) { pack(link, values, reinterpret_cast<T*>(mailboxes_->outgoing(link.rank))); });
        if (mailboxes_) mailboxes_->post();
    }

    /// The second half of `sum`: waits and adds.
    void finish(std::span<T> values) {
        for_each_link(true, [&](const Link& link) { add(link, reinterpret_cast<const T*>(mailboxes_->incoming(link.rank)), values); });
        check(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
        std::size_t at = 0;
        for_each_link(false, [&](const Link& link) {
            add(link, incoming_.data() + at, values);
            at += link.nodes.size();
        });
    }

    [[nodiscard]] const std::vector<Link>& links() const { return links_; }

  private:
    static int bytes(const Link& link) { return static_cast<int>(link.nodes.size() * sizeof(T)); }

    static void pack(const Link& link, std::span<const T> values, T* message) {
        for (const auto node : link.nodes) *message++ = values[static_cast<std::size_t>(node)];
    }
    static void add(const Link& link, const T* message, std::span<T> values) {
        for (const auto node : link.nodes) {
            auto& here = values[static_cast<std::size_t>(node)];
            const T& there = *message++;
            for (std::size_t i = 0; i < there.size(); ++i) here[i] += there[i];
        }
    }

    template <class Use>
    void for_each_link(bool by_mail, Use use) const {
        for (std::size_t k = 0; k < links_.size(); ++k)
            if (by_mail_[k] == by_mail) use(links_[k]);
    }

    /// For what does not go by mail.
    void make_buffers() {
        std::size_t items = 0;
        for_each_link(false, [&](const Link& link) { items += link.nodes.size(); });
        outgoing_ = std::vector<T>(items);
        incoming_ = std::vector<T>(items);
        requests_.reserve(2 * links_.size());
    }

    std::vector<Link> links_;  // none without nodes
    std::vector<bool> by_mail_;
    Mailboxes* mailboxes_ = nullptr;
    std::vector<T> outgoing_, incoming_;
    std::vector<MPI_Request> requests_;
};

}  // namespace weavefront::parallel
