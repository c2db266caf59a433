// Writes frames of the synthetic model: results_writer PATH FRAMES MAX_FRAMES PROJECTILE(0|1) [cut]. Each
// rank prints its process id first.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "synthetic_model.hpp"

using namespace weavefront;

int main(int argc, char** argv) try {
    const parallel::Environment environment(&argc, &argv);
    if (argc < 5) return EXIT_FAILURE;
    const int frames = std::atoi(argv[2]);
    const int max_frames = std::atoi(argv[3]);
    std::printf("%d\n", static_cast<int>(::getpid()));
    std::fflush(stdout);

    const parallel::Communicator comm(MPI_COMM_WORLD);
    const io::SyntheticModel model{
        .projectile = std::atoi(argv[4]) == 1, .rank = comm.rank(), .ranks = comm.size()};
    io::Results results(model.setup(argv[1], max_frames), comm);
    results.publish();
    for (int k = 0; k < frames; ++k) results.write(model.frame(k));
    if (argc > 5) results.cut();
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return EXIT_FAILURE;
}
