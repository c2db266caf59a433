#pragma once
/// @file
/// Messages through memory that the ranks of one host share.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/shared_memory.hpp"

namespace weavefront::parallel {

/// Each rank writes its messages into memory of its own that the other ranks of its host read. So a message
/// is copied once less than by MPI on either side, and it is there whether or not its receiver is in a call
/// of MPI. All ranks post in turn: once each, then again.
class SharedMemoryExchange {
  public:
    /// @note Collective
    explicit SharedMemoryExchange(const Communicator& comm);
    ~SharedMemoryExchange();
    SharedMemoryExchange(const SharedMemoryExchange&) = delete;
    SharedMemoryExchange& operator=(const SharedMemoryExchange&) = delete;

    /// Whether a rank is another one of this host, and memory can be shared with it.
    [[nodiscard]] bool on_this_host(int rank) const {
        return !is_refused_ && on_host_[static_cast<std::size_t>(rank)] >= 0 && rank != rank_;
    }

    /// Whether the host has not had the memory: then no rank of it is reached from that `open` on.
    [[nodiscard]] bool is_refused() const { return is_refused_; }

    /// Makes room for messages of other lengths, where the host has it. What was posted last has been read by
    /// all. @param bytes to each rank; 0: none
    /// @note Collective
    void resize(std::span<const std::size_t> bytes);

    /// Where the next message to a rank is written. @pre open for one
    [[nodiscard]] std::byte* outgoing(int rank) const;
    /// Shows the messages to the others.
    void publish();
    /// The message of a rank that it posted with this one's last; waits for it. There until the next `post`.
    [[nodiscard]] const std::byte* incoming(int rank) const;

  private:
    /// What a rank tells the others of its messages.
    struct Header;
    [[nodiscard]] Header& header(int on_host) const;
    [[nodiscard]] std::byte* message(int from, int to, std::uint64_t turn) const;
    [[nodiscard]] std::size_t before_messages() const;

    MPI_Comm host_ = MPI_COMM_NULL;
    int rank_, ranks_on_host_ = 1, rank_on_host_ = 0;
    std::vector<int> on_host_;  ///< of each rank, its rank among those of this host, or -1
    SharedMemory memory_;
    std::size_t room_ = 0;    ///< of each rank of this host, bytes
    std::uint64_t turn_ = 0;  ///< of the last post
    bool is_refused_ = false;
};

}  // namespace weavefront::parallel
