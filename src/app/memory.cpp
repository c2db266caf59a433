#include "memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

namespace weavefront::app {

double memory_needed(std::int64_t elements) { return 600.0 * static_cast<double>(elements); }

double memory_here() { return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE)); }

std::string bytes_text(double bytes) { return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9); }

void require_memory(std::int64_t elements, const parallel::Communicator& comm) {
    const double of_rank = memory_needed(elements) / comm.size(), least = comm.min(memory_here());
    if (of_rank > least)
        throw std::runtime_error(
            fmt::format("the target has {} elements, which need about {} on each of {} ranks, and this machine has {}: use more machines "
                        "or a coarser mesh",
                        elements, bytes_text(of_rank), comm.size(), bytes_text(least)));
}

}  // namespace weavefront::app
