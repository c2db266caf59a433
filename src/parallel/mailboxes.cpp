#include "weavefront/parallel/mailboxes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <exception>
#include <memory>
#include <numeric>
#include <thread>

namespace weavefront::parallel {

namespace {

constexpr std::size_t cache_line = 64;

// A wait is short unless the ranks share their cores: then the one waited for has to get its turn.
constexpr int looks_before_yielding = 2000;

static_assert(std::atomic_ref<std::uint64_t>::is_always_lock_free, "ranks share it");

/// Has the system fill memory with zeros, which it refuses where the memory cannot be had: to write there would end the program.
bool is_had(void* memory, std::size_t bytes) {
    const int zeros = ::open("/dev/zero", O_RDONLY | O_CLOEXEC);
    if (zeros < 0) return false;
    auto* at = static_cast<std::byte*>(memory);
    for (std::size_t left = bytes; left > 0;) {
        const auto filled = ::read(zeros, at, left);
        if (filled < 0 && errno == EINTR) continue;
        if (filled <= 0) break;
        at += filled, left -= static_cast<std::size_t>(filled);
    }
    ::close(zeros);
    return at == static_cast<std::byte*>(memory) + bytes;
}

std::size_t in_whole_lines(std::size_t bytes) { return (bytes + cache_line - 1) / cache_line * cache_line; }

}  // namespace

// In shared memory, at the start of a rank's part. After it: where the message to each rank of the host begins, then the messages of even
// turns, then those of odd ones. A rank writes those of a turn when all have read those of the turn before, not yet those of the last.
struct alignas(cache_line) Mailboxes::Header {
    std::uint64_t turn;  ///< of the last post; atomic
    std::size_t bytes;   ///< of the messages of a turn
};

Mailboxes::Mailboxes(const Communicator& comm)
    : exceptions_(std::uncaught_exceptions()), rank_(comm.rank()), on_host_(static_cast<std::size_t>(comm.size()), -1) {
    if (comm.size() == 1) return;
    check(MPI_Comm_split_type(comm.get(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &host_));
    check(MPI_Comm_set_errhandler(host_, MPI_ERRORS_RETURN));
    check(MPI_Comm_size(host_, &ranks_on_host_));
    check(MPI_Comm_rank(host_, &rank_on_host_));
    std::vector<int> ranks(on_host_.size());
    std::iota(ranks.begin(), ranks.end(), 0);
    MPI_Group all = MPI_GROUP_NULL, here = MPI_GROUP_NULL;
    check(MPI_Comm_group(comm.get(), &all));
    check(MPI_Comm_group(host_, &here));
    check(MPI_Group_translate_ranks(all, comm.size(), ranks.data(), here, on_host_.data()));
    MPI_Group_free(&all);
    MPI_Group_free(&here);
    std::ranges::replace_if(
        on_host_, [](int rank) { return rank == MPI_UNDEFINED; }, -1);
}

Mailboxes::~Mailboxes() {
    if (std::uncaught_exceptions() > exceptions_) return;  // the others may not get here
    release();
    if (host_ != MPI_COMM_NULL) MPI_Comm_free(&host_);
}

void Mailboxes::release() {
    if (window_ == MPI_WIN_NULL) return;
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
}

bool Mailboxes::allocate(std::size_t bytes) {
    release();
    memories_.clear();
    room_ = 0;
    void* mine = nullptr;
    const int code = MPI_Win_allocate_shared(static_cast<MPI_Aint>(bytes), 1, MPI_INFO_NULL, host_, &mine, &window_);
    if (code != MPI_SUCCESS) window_ = MPI_WIN_NULL;
    int is_had_by_all = code == MPI_SUCCESS && is_had(mine, bytes) ? 1 : 0;
    check(MPI_Allreduce(MPI_IN_PLACE, &is_had_by_all, 1, MPI_INT, MPI_MIN, host_));
    if (window_ != MPI_WIN_NULL) check(MPI_Win_lock_all(MPI_MODE_NOCHECK, window_));
    if (is_had_by_all == 0) {
        release();
        return false;
    }
    for (int r = 0; r < ranks_on_host_; ++r) {
        MPI_Aint size = 0;
        int unit = 0;
        void* memory = nullptr;
        check(MPI_Win_shared_query(window_, r, &size, &unit, &memory));
        // The same place for all: they see it at different addresses, which differ by whole pages.
        std::size_t space = bytes;
        memories_.push_back(static_cast<std::byte*>(std::align(cache_line, bytes - cache_line, memory, space)));
    }
    room_ = bytes - cache_line;
    turn_ = 0;
    header(rank_on_host_) = {};
    return true;
}

void Mailboxes::open(std::span<const std::size_t> bytes) {
    if (ranks_on_host_ == 1 || is_refused_) return;
    std::vector<std::size_t> begins(static_cast<std::size_t>(ranks_on_host_), 0);
    std::size_t end = 0;
    for (std::size_t r = 0; r < bytes.size(); ++r) {
        if (on_host_[r] < 0) continue;
        begins[static_cast<std::size_t>(on_host_[r])] = end;
        end += in_whole_lines(bytes[r]);
    }
    std::uint64_t wanted = before_messages() + 2 * end;
    check(MPI_Allreduce(MPI_IN_PLACE, &wanted, 1, MPI_UINT64_T, MPI_MAX, host_));
    is_refused_ = wanted > room_ && !allocate(in_whole_lines(wanted + wanted / 2) + cache_line);
    if (is_refused_) return;
    auto& own = header(rank_on_host_);
    own.bytes = end;
    std::ranges::copy(begins, reinterpret_cast<std::size_t*>(&own + 1));
    check(MPI_Win_sync(window_));
    check(MPI_Barrier(host_));
    check(MPI_Win_sync(window_));
}

std::size_t Mailboxes::before_messages() const {
    return in_whole_lines(sizeof(Header) + static_cast<std::size_t>(ranks_on_host_) * sizeof(std::size_t));
}

Mailboxes::Header& Mailboxes::header(int on_host) const { return *reinterpret_cast<Header*>(memories_[static_cast<std::size_t>(on_host)]); }

std::byte* Mailboxes::message(int from, int to, std::uint64_t turn) const {
    auto& header_of_sender = header(from);
    const auto* begins = reinterpret_cast<const std::size_t*>(&header_of_sender + 1);
    const auto place = before_messages() + turn % 2 * header_of_sender.bytes + begins[to];
    return memories_[static_cast<std::size_t>(from)] + place;
}

std::byte* Mailboxes::outgoing(int rank) const { return message(rank_on_host_, on_host_[static_cast<std::size_t>(rank)], turn_ + 1); }

void Mailboxes::post() {
    ++turn_;
    if (ranks_on_host_ > 1 && !is_refused_) std::atomic_ref(header(rank_on_host_).turn).store(turn_, std::memory_order_release);
}

const std::byte* Mailboxes::incoming(int rank) const {
    const auto from = on_host_[static_cast<std::size_t>(rank)];
    const std::atomic_ref turn(header(from).turn);
    for (int looks = 0; turn.load(std::memory_order_acquire) < turn_;)
        if (looks < looks_before_yielding)
            ++looks;
        else
            std::this_thread::yield();
    return message(from, rank_on_host_, turn_);
}

}  // namespace weavefront::parallel
