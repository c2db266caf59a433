// Fails on purpose on the last rank; tests/harness/CMakeLists.txt expects the run to report it and to fail.
#include <gtest/gtest.h>
#include <mpi.h>

namespace {

bool last_rank() {
    int rank = 0;
    int size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return rank == size - 1;
}

TEST(FailureOnOneRank, FailsTheRun) {
    EXPECT_FALSE(last_rank()) << "on purpose";
    MPI_Barrier(MPI_COMM_WORLD);
}

TEST(FailureOnOneRank, DoesNotReachTheNextTest) { MPI_Barrier(MPI_COMM_WORLD); }

TEST(RankThatLeaves, EndsTheRunInsteadOfHangingIt) {
    ASSERT_FALSE(last_rank()) << "left the others waiting";
    MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace
