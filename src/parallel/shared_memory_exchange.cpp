#include "weavefront/parallel/shared_memory_exchange.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

namespace weavefront::parallel {

namespace {

constexpr std::size_t cache_line = 64;

// A wait is short unless ranks share cores. Then the awaited rank needs the core.
constexpr int looks_before_yielding = 2000;

static_assert(std::atomic_ref<std::uint64_t>::is_always_lock_free, "ranks share it");

std::size_t in_whole_lines(std::size_t bytes) { return (bytes + cache_line - 1) / cache_line * cache_line; }

}  // namespace

// Start of a rank's part of the shared memory. It is followed by the offset of the message to each rank of
// the host, the messages of even turns, and the messages of odd turns. A rank writes the messages of a turn
// after all ranks have read those of the turn before the last.
struct alignas(cache_line) SharedMemoryExchange::Header {
    std::uint64_t turn;  ///< of the last published messages; atomic
    std::size_t bytes;   ///< of all messages of a turn
};

SharedMemoryExchange::SharedMemoryExchange(const Communicator& comm)
    : rank_(comm.rank()), on_host_(static_cast<std::size_t>(comm.size()), -1) {
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

SharedMemoryExchange::~SharedMemoryExchange() {
    if (host_ != MPI_COMM_NULL) MPI_Comm_free(&host_);
}

void SharedMemoryExchange::resize(std::span<const std::size_t> bytes) {
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
    if (wanted > room_) {
        room_ = wanted + wanted / 2;
        memory_ = {};  // before others take room
        memory_ = SharedMemory(host_, room_);
        is_refused_ = !memory_.is_had();
        if (is_refused_) return;
        turn_ = 0;
        header(rank_on_host_) = {};
    }
    auto& own = header(rank_on_host_);
    own.bytes = end;
    std::ranges::copy(begins, reinterpret_cast<std::size_t*>(&own + 1));
    std::atomic_thread_fence(std::memory_order_seq_cst);
    check(MPI_Barrier(host_));
    std::atomic_thread_fence(std::memory_order_seq_cst);
}

std::size_t SharedMemoryExchange::before_messages() const {
    return in_whole_lines(sizeof(Header) + static_cast<std::size_t>(ranks_on_host_) * sizeof(std::size_t));
}

SharedMemoryExchange::Header& SharedMemoryExchange::header(int on_host) const {
    return *reinterpret_cast<Header*>(memory_.piece(on_host));
}

std::byte* SharedMemoryExchange::message(int from, int to, std::uint64_t turn) const {
    auto& header_of_sender = header(from);
    const auto* begins = reinterpret_cast<const std::size_t*>(&header_of_sender + 1);
    const auto place = before_messages() + turn % 2 * header_of_sender.bytes + begins[to];
    return memory_.piece(from) + place;
}

std::byte* SharedMemoryExchange::outgoing(int rank) const {
    return message(rank_on_host_, on_host_[static_cast<std::size_t>(rank)], turn_ + 1);
}

void SharedMemoryExchange::publish() {
    ++turn_;
    if (ranks_on_host_ > 1 && !is_refused_)
        std::atomic_ref(header(rank_on_host_).turn).store(turn_, std::memory_order_release);
}

const std::byte* SharedMemoryExchange::incoming(int rank) const {
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
