#include "launcher.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "weavefront/scene/read.hpp"

namespace weavefront::app {

namespace {

// SLURM_PROCID is 0 in a batch script as well; srun sets it for each of its processes.
constexpr std::array rank_variables{"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"};

// Of Open MPI's and MPICH's mpirun and of PMI launchers. SLURM_NTASKS is what a whole job asks for, also
// where one process of it runs by itself: it counts where srun has started this process, which
// SLURM_STEP_NUM_TASKS tells.
constexpr std::array size_variables{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE",
                                    "SLURM_NTASKS"};

int whole_number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

/// What a variable says of the number of processes; 0: nothing.
int size_in(const char* variable) {
    const char* text = std::getenv(variable);
    if (text == nullptr) return 0;
    if (std::string_view(variable) == "SLURM_NTASKS" && std::getenv("SLURM_STEP_NUM_TASKS") == nullptr)
        return 0;
    return whole_number(text);
}

bool starts_first() {
    for (const char* variable : rank_variables)
        if (const char* rank = std::getenv(variable)) return std::string_view(rank) == "0";
    return true;
}

// MPI sets variables of its own when it begins in a process that its mpirun has not started.
const bool started_first = starts_first();

}  // namespace

bool is_first_process() { return started_first; }

int launched_processes() {
    for (const char* variable : size_variables)
        if (const int size = size_in(variable); size > 0) return size;
    return 1;
}

void require_one_job(int ranks) {
    if (ranks > 1) return;
    for (const char* variable : size_variables) {
        const int size = size_in(variable);
        if (size == 0) continue;
        if (size <= ranks) return;
        throw scene::InputError(
            {fmt::format("found one rank where the launcher has started {0} processes ({1}={0}): it belongs "
                         "to another MPI than this "
                         "program, so that each "
                         "process would compute everything by itself; allowed is the mpirun of the MPI that "
                         "the program was built with, or "
                         "srun --mpi=pmix",
                         size, variable)});
    }
}

}  // namespace weavefront::app
