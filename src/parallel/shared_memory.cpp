#include "weavefront/parallel/shared_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "weavefront/parallel/communicator.hpp"

namespace weavefront::parallel {

namespace {

using Name = std::array<char, 64>;  ///< empty: no memory

/// Creates an object of shared memory with all its pages. @return its name
Name create(std::size_t bytes) {
    static int made = 0;
    Name name{};
    for (;;) {
        std::snprintf(name.data(), name.size(), "/weavefront.%d.%d", static_cast<int>(::getpid()), made++);
        const int object = ::shm_open(name.data(), O_RDWR | O_CREAT | O_EXCL, 0600);
        if (object < 0 && errno == EEXIST)
            continue;  // name of a process with this id in another container, or of a killed one
        int cause = object < 0 ? errno : EINTR;
        while (cause == EINTR && object >= 0) cause = ::posix_fallocate(object, 0, static_cast<off_t>(bytes));
        if (object >= 0) ::close(object);
        if (cause == 0) return name;
        if (object >= 0) ::shm_unlink(name.data());
        return {};
    }
}

/// @return null if it cannot be mapped
std::byte* map(const Name& name, std::size_t bytes) {
    const int object = ::shm_open(name.data(), O_RDWR, 0600);
    if (object < 0) return nullptr;
    void* memory = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, object, 0);
    ::close(object);
    return memory == MAP_FAILED ? nullptr : static_cast<std::byte*>(memory);
}

bool on_all(MPI_Comm host, bool here) {
    int all = here ? 1 : 0;
    check(MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, host));
    return all == 1;
}

}  // namespace

SharedMemory::SharedMemory(MPI_Comm host, std::size_t bytes) : bytes_(bytes) {
    int ranks = 1;
    check(MPI_Comm_size(host, &ranks));
    const Name own = create(bytes);
    std::vector<Name> names(static_cast<std::size_t>(ranks));
    check(MPI_Allgather(own.data(), static_cast<int>(own.size()), MPI_CHAR, names.data(),
                        static_cast<int>(own.size()), MPI_CHAR, host));
    const bool is_created = std::ranges::all_of(names, [](const Name& name) { return name[0] != '\0'; });
    for (const auto& name : names) pieces_.push_back(is_created ? map(name, bytes) : nullptr);
    const bool is_had = on_all(host, std::ranges::find(pieces_, nullptr) == pieces_.end());
    if (own[0] != '\0')
        ::shm_unlink(own.data());  // the memory is freed with its last user, even a killed one
    if (!is_had) release();
}

SharedMemory::~SharedMemory() { release(); }

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : bytes_(other.bytes_), pieces_(std::exchange(other.pieces_, {})) {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
    if (this != &other) {
        release();
        bytes_ = other.bytes_;
        pieces_ = std::exchange(other.pieces_, {});
    }
    return *this;
}

void SharedMemory::release() {
    for (auto* piece : std::exchange(pieces_, {}))
        if (piece != nullptr) ::munmap(piece, bytes_);
}

}  // namespace weavefront::parallel
