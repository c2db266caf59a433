#pragma once
/// @file
/// Owned MPI handles and checked calls.

#include <mpi.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace weavefront::parallel {

/// Throws std::runtime_error with MPI's own text when `code` is not MPI_SUCCESS.
void check(int code);

/// Initialises MPI and finalises it in its destructor. A nested environment does neither. A rank among
/// several that runs out of memory reports it and ends all ranks with exit status 3. Threads that MPI starts
/// receive no termination signals.
class Environment {
  public:
    Environment(int* argc, char*** argv);
    ~Environment();
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    bool is_outermost_ = false;
    int exceptions_;  ///< exceptions in flight at construction
    int ranks_ = 1;
};

/// A duplicated communicator, freed by its destructor.
class Communicator {
  public:
    /// @note Collective
    explicit Communicator(MPI_Comm original);
    /// A communicator of this process only; MPI need not be initialised. Sums, extremes and broadcasts return
    /// its own values. `get` returns no valid handle.
    static Communicator alone() { return Communicator(); }
    ~Communicator();
    Communicator(Communicator&& other) noexcept;
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;
    Communicator& operator=(Communicator&&) = delete;

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] MPI_Comm get() const { return comm_; }

    /// Sums integers over the ranks, in place. Integer sums do not depend on their order. @note Collective
    void sum(std::span<std::int64_t> values) const;
    /// Smallest value over the ranks. @note Collective
    [[nodiscard]] double min(double value) const;
    /// Largest value over the ranks. @note Collective
    [[nodiscard]] double max(double value) const;
    /// Largest values over the ranks, in place. @note Collective
    void max(std::span<double> values) const;
    /// Smallest values over the ranks, in place. @note Collective
    void min(std::span<std::int64_t> values) const;
    /// True on all ranks if true on any. @note Collective
    [[nodiscard]] bool any(bool value) const;
    /// The text of rank 0 on all ranks. @note Collective
    [[nodiscard]] std::string broadcast(std::string text) const;
    /// The integers of rank 0 on all ranks. @note Collective
    void broadcast(std::vector<std::int32_t>& values) const;

  private:
    Communicator() = default;

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace weavefront::parallel
