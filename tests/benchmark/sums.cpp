/// Element forces, their sums on the nodes, and the sums over ranks.

#include <benchmark/benchmark.h>

#include "../shell/elements.hpp"
#include "weavefront/parallel/exchange.hpp"
#include "weavefront/solver/assembly.hpp"

namespace weavefront::benchmark {
namespace {

constexpr int edge =
    22;  // elements along the edge of a square: about as many as the product computes between two sums

/// The square between two states that it goes to and fro.
struct Square {
    std::mt19937_64 random{6};
    test::Mesh mesh = test::grid(edge, 0.1, random);
    test::Elements elements{test::kevlar129(), mesh, 0};
    test::Wander wander{mesh, random, 0.01, 0.05, 0.01};
    shell::AlignedVector<double> forces = shell::AlignedVector<double>(
        static_cast<std::size_t>(elements.group->packs()) * shell::forces_per_pack);

    void advance(const test::Positions& x) {
        elements.group->advance(0, elements.group->packs(), x, forces, elements.events);
    }
};

void internal_force(::benchmark::State& state) {
    Square square;
    const std::array<test::Positions, 2> x{square.wander.at(0.5), square.wander.at(0.501)};
    std::size_t turn = 0;
    for (auto _ : state) {
        square.advance(x[turn]);
        turn = 1 - turn;
        ::benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * square.elements.group->size());
}
BENCHMARK(internal_force);

void assembly(::benchmark::State& state) {
    Square square;
    square.advance(square.wander.at(0.01));
    solver::Assembly assembly(1e3, 1e-2);
    std::vector<solver::FixedVector> sums(square.mesh.X.size());
    for (auto _ : state) {
        assembly.start(sums);
        assembly.add_packs(*square.elements.group, 0, square.elements.group->packs(), square.forces, sums);
        ::benchmark::ClobberMemory();
    }
    if (assembly.faulty_element() >= 0) state.SkipWithError("a force is out of range");
    state.SetItemsProcessed(state.iterations() * square.elements.group->size());
}
BENCHMARK(assembly);

/// One rank linked to itself: packing, unpacking and the least that MPI can take.
void halo(::benchmark::State& state) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    constexpr std::int32_t shared = 256;
    std::vector<std::int32_t> nodes;
    for (std::int32_t n = 0; n < shared; ++n) nodes.push_back(3 * n);
    parallel::Exchange<solver::FixedVector> exchange({{comm.rank(), nodes}});
    std::vector<solver::FixedVector> sums(std::size_t{3} * shared);
    for (auto _ : state) {
        exchange.sum(comm, sums);
        ::benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t{shared});
}
BENCHMARK(halo);

}  // namespace
}  // namespace weavefront::benchmark
