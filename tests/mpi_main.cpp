// GoogleTest over MPI: every rank runs every test, rank 0 reports the failures of all ranks, and all ranks
// leave with the same status.
#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#ifndef WEAVEFRONT_TEST_PATIENCE
#define WEAVEFRONT_TEST_PATIENCE 30  // seconds that a rank with a failure waits for the others
#endif

namespace {

struct Failure {
    std::string file;
    int line;
    std::string message;
};

/// Fields ended by '\0', which no message contains.
std::string pack(const std::vector<Failure>& failures) {
    std::string text;
    for (const auto& failure : failures) {
        for (const auto& field : {failure.file, std::to_string(failure.line), failure.message})
            text.append(field).push_back('\0');
    }
    return text;
}

std::vector<Failure> unpack(const std::string& text) {
    std::vector<Failure> failures;
    std::istringstream fields(text);
    for (std::string file, line, message; std::getline(fields, file, '\0');) {
        std::getline(fields, line, '\0');
        std::getline(fields, message, '\0');
        failures.push_back({file, std::stoi(line), message});
    }
    return failures;
}

/// Agrees on each test's outcome before any rank begins the next one.
class AgreeingListener final : public testing::EmptyTestEventListener {
  public:
    explicit AgreeingListener(MPI_Comm tests) {
        // A communicator of its own keeps the agreement apart from messages that a failed test left behind.
        MPI_Comm_dup(tests, &comm_);
        MPI_Comm_rank(comm_, &rank_);
        MPI_Comm_size(comm_, &size_);
        name_rank();
    }
    AgreeingListener(const AgreeingListener&) = delete;
    AgreeingListener& operator=(const AgreeingListener&) = delete;
    ~AgreeingListener() override { MPI_Comm_free(&comm_); }

  private:
    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (!result.failed() || agreeing_) return;
        failures_.push_back(
            {result.file_name() ? result.file_name() : "", result.line_number(), result.message()});
    }
    void OnTestEnd(const testing::TestInfo&) override { agree(); }
    void OnTestSuiteEnd(const testing::TestSuite&) override { agree(); }
    void OnEnvironmentsTearDownEnd(const testing::UnitTest&) override { agree(); }

    void name_rank() {
        trace_.emplace("mpirun", size_, "rank " + std::to_string(rank_) + " of " + std::to_string(size_));
    }

    /// Brings the failures of all ranks to rank 0 and fails its test for each of them.
    /// @note Collective
    void agree() {
        await_others();
        const std::string mine = pack(rank_ == 0 ? std::vector<Failure>{} : failures_);
        failures_.clear();
        const int length = static_cast<int>(mine.size());
        std::vector<int> lengths(static_cast<std::size_t>(size_));
        MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, comm_);
        std::vector<int> offsets(lengths.size());
        std::exclusive_scan(lengths.begin(), lengths.end(), offsets.begin(), 0);
        std::string all(static_cast<std::size_t>(offsets.back() + lengths.back()), '\0');
        MPI_Gatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), offsets.data(), MPI_CHAR, 0,
                    comm_);
        if (rank_ != 0) return;
        agreeing_ = true;
        trace_.reset();  // the messages already name the rank that they come from
        for (const auto& failure : unpack(all))
            ADD_FAILURE_AT(failure.file.c_str(), failure.line) << failure.message;
        name_rank();
        agreeing_ = false;
    }

    /// Waits until every rank is here. A rank with a failure may have left a collective call in which the
    /// others wait for it: past its patience it reports and ends the run.
    void await_others() {
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Ibarrier(comm_, &request);
        const auto deadline =
            std::chrono::steady_clock::now() + std::chrono::seconds(WEAVEFRONT_TEST_PATIENCE);
        for (int arrived = 0; MPI_Test(&request, &arrived, MPI_STATUS_IGNORE), arrived == 0;) {
            if (!failures_.empty() && std::chrono::steady_clock::now() > deadline) give_up();
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
    }

    [[noreturn]] void give_up() const {
        for (const auto& failure : failures_) {
            std::fprintf(stderr, "%s:%d: Failure\n%s\n", failure.file.c_str(), failure.line,
                         failure.message.c_str());
        }
        std::fprintf(stderr, "rank %d failed and the others did not finish the test; aborting\n", rank_);
        std::fflush(nullptr);
        MPI_Abort(comm_, EXIT_FAILURE);
        std::abort();
    }

    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    int size_ = 1;
    bool agreeing_ = false;
    std::vector<Failure> failures_;
    std::optional<testing::ScopedTrace> trace_;
};

}  // namespace

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    testing::InitGoogleTest(&argc, argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);

    auto& listeners = testing::UnitTest::GetInstance()->listeners();
    if (rank != 0) delete listeners.Release(listeners.default_result_printer());
    // Behind the printer: end events run backwards through the list, so the outcome is agreed before it is
    // printed.
    auto* const agreeing = new AgreeingListener(MPI_COMM_WORLD);
    listeners.Append(agreeing);

    int status = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &status, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    delete listeners.Release(agreeing);
    MPI_Finalize();
    return status;
}
