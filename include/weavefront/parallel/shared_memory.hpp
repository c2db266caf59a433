#pragma once
/// @file
/// Memory that the ranks of one host share.

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace weavefront::parallel {

/// A piece of memory of each rank of a host, which all of them read and write. Its pages are reserved when it
/// is made: none can be missing later. A rank's piece lies near to its processor.
class SharedMemory {
  public:
    SharedMemory() = default;
    /// @param host  ranks of one host
    /// @param bytes of a piece, the same on all ranks
    /// @note Collective. Where the host has not got the memory, `is_had` is false on all ranks.
    SharedMemory(MPI_Comm host, std::size_t bytes);
    ~SharedMemory();
    SharedMemory(SharedMemory&& other) noexcept;
    SharedMemory& operator=(SharedMemory&& other) noexcept;

    [[nodiscard]] bool is_had() const { return !pieces_.empty(); }
    /// Of a rank, page by page.
    [[nodiscard]] std::byte* piece(int rank) const { return pieces_[static_cast<std::size_t>(rank)]; }

  private:
    void release();

    std::size_t bytes_ = 0;
    std::vector<std::byte*> pieces_;  ///< of the ranks of the host; none: the memory was not had
};

}  // namespace weavefront::parallel
