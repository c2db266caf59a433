// Runs a progress through a few steps, with a line in between.
#include "weavefront/io/progress.hpp"

using namespace weavefront;

int main(int argc, char** argv) {
    const parallel::Environment environment(&argc, &argv);
    const parallel::Communicator comm(MPI_COMM_WORLD);
    io::Log log({}, comm);
    double wall = 0;
    io::Progress progress(log, 100e-6, [&] { return wall += 1; });
    for (int step = 0; step <= 100; ++step) {
        progress.update(step * 1e-6, step, "projectile 212.4 m/s");
        if (step == 50) log.info("a line in between");
    }
    progress.finish();
}
