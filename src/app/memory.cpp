#include "memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

namespace weavefront::app {

double memory_needed(std::int64_t elements) { return 600.0 * static_cast<double>(elements); }

double memory_here() { return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE)); }

void require_memory(std::int64_t elements, int ranks) {
    const double of_rank = memory_needed(elements) / ranks;
    if (of_rank > memory_here())
        throw std::runtime_error(
            fmt::format("the target has {} elements, which need about {:.3g} GB on each of {} ranks; this machine has {:.3g} GB: use more "
                        "machines or a "
                        "coarser mesh",
                        elements, of_rank / 1e9, ranks, memory_here() / 1e9));
}

}  // namespace weavefront::app
