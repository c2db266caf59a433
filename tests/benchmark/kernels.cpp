/// Speed of the kernels, each alone. Every benchmark reports its items per second: points, elements, nodes or
/// instructions.

#include <benchmark/benchmark.h>

#include "weavefront/parallel/communicator.hpp"

int main(int argc, char** argv) {
    const weavefront::parallel::Environment environment(&argc, &argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
