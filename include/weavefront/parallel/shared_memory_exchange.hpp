#pragma once
/// @file
/// Messages between ranks of one host through shared memory.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/parallel/communicator.hpp"
#include "weavefront/parallel/shared_memory.hpp"

namespace weavefront::parallel {

/// Each rank writes its messages into its own part of the memory, and the other ranks of its host read them
/// there. MPI would copy a message once more on either side, and only while the receiver is in a call of MPI.
/// A turn is one call of `publish` on every rank; all ranks finish a turn before the next one.
class SharedMemoryExchange {
  public:
    /// @note Collective
    explicit SharedMemoryExchange(const Communicator& comm);
    ~SharedMemoryExchange();
    SharedMemoryExchange(const SharedMemoryExchange&) = delete;
    SharedMemoryExchange& operator=(const SharedMemoryExchange&) = delete;

    /// Whether another rank is on this host and reached through shared memory.
    [[nodiscard]] bool on_this_host(int rank) const {
        return !is_refused_ && on_host_[static_cast<std::size_t>(rank)] >= 0 && rank != rank_;
    }

    /// Whether the host refused the memory at the last `resize`. Then no rank is reached through it any more.
    [[nodiscard]] bool is_refused() const { return is_refused_; }

    /// Makes room for messages of new lengths, if the host has the memory. All published messages must have
    /// been read.
    /// @param bytes by rank: length of the message to it; 0: no message
    /// @note Collective
    void resize(std::span<const std::size_t> bytes);

    /// Address of the next message to a rank. @pre `resize` gave it a length
    [[nodiscard]] std::byte* outgoing(int rank) const;
    /// Releases the messages of this turn to the other ranks.
    void publish();
    /// Waits for the message of a rank in this turn. It is valid until the next `publish`.
    [[nodiscard]] const std::byte* incoming(int rank) const;

  private:
    /// Header of a rank's part of the memory.
    struct Header;
    [[nodiscard]] Header& header(int on_host) const;
    [[nodiscard]] std::byte* message(int from, int to, std::uint64_t turn) const;
    [[nodiscard]] std::size_t before_messages() const;

    MPI_Comm host_ = MPI_COMM_NULL;
    int rank_, ranks_on_host_ = 1, rank_on_host_ = 0;
    std::vector<int> on_host_;  ///< by rank: its rank on this host, or -1
    SharedMemory memory_;
    std::size_t room_ = 0;    ///< size of each rank's part, bytes
    std::uint64_t turn_ = 0;  ///< number of published turns
    bool is_refused_ = false;
};

}  // namespace weavefront::parallel
