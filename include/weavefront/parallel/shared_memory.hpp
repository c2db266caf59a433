#pragma once
/// @file
/// Memory shared by the ranks of one host.

#include <mpi.h>

#include <cstddef>
#include <vector>

namespace weavefront::parallel {

/// One piece of memory for each rank of a host; all ranks read and write all pieces. Pages are reserved at
/// construction, so none can be missing later. A rank's piece lies near its processor.
class SharedMemory {
  public:
    SharedMemory() = default;
    /// @param host  ranks of one host
    /// @param bytes size of a piece, the same on all ranks
    /// @note Collective. If the host has too little memory, `is_had` is false on all ranks.
    SharedMemory(MPI_Comm host, std::size_t bytes);
    ~SharedMemory();
    SharedMemory(SharedMemory&& other) noexcept;
    SharedMemory& operator=(SharedMemory&& other) noexcept;

    /// Whether the memory was obtained.
    [[nodiscard]] bool is_had() const { return !pieces_.empty(); }
    /// The piece of a rank, aligned to a page.
    [[nodiscard]] std::byte* piece(int rank) const { return pieces_[static_cast<std::size_t>(rank)]; }

  private:
    void release();

    std::size_t bytes_ = 0;
    std::vector<std::byte*> pieces_;  ///< by rank of the host; empty: no memory
};

}  // namespace weavefront::parallel
