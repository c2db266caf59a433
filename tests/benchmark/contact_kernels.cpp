/// Kernels of contact.

#include <benchmark/benchmark.h>

#include <vector>

#include "kernels.hpp"
#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/ray.hpp"

namespace weavefront::benchmark {
namespace {

/// Eight normals against a facet below them, all of which meet it.
void ray(::benchmark::State& state) {
    const std::array<Vec3, 4> facet{Vec3(0, 0, 0), Vec3(1e-3, 0, 1e-5), Vec3(1e-3, 1e-3, 0),
                                    Vec3(0, 1e-3, -1e-5)};
    std::mt19937_64 random(8);
    contact::Rays rays;
    for (std::size_t i = 0; i < contact::batch_width; ++i) {
        rays.origin.x[i] = uniform(random, 1e-4, 9e-4), rays.origin.y[i] = uniform(random, 1e-4, 9e-4),
        rays.origin.z[i] = -2e-4;
        rays.direction.x[i] = uniform(random, -0.05, 0.05), rays.direction.y[i] = 0;
        rays.direction.z[i] = std::sqrt(1 - rays.direction.x[i] * rays.direction.x[i]);
    }
    for (auto _ : state) {
        ::benchmark::DoNotOptimize(rays);
        auto hits = contact::intersect(rays, facet);
        ::benchmark::DoNotOptimize(hits);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(contact::batch_width));
}
BENCHMARK(ray);

/// Points that are response in and let go again.
void penalty(::benchmark::State& state) {
    scene::ContactLaw contact;
    contact.stiffness = 1.1e13, contact.unloading = 10, contact.damping = 0.2;
    const contact::PenaltyLaw law(contact, 0.1);
    std::mt19937_64 random(9);
    std::vector<contact::Penetration> points(batch);
    std::vector<double> speeds;
    for (std::size_t n = 0; n < batch; ++n) speeds.push_back(uniform(random, 1, 50));
    constexpr double dt = 1e-8;
    double dissipated_budget = 0, pressure = 0, depth = 0;
    int step = 0;
    for (auto _ : state) {
        const double direction = ++step % 64 < 32 ? 1 : -1;
        depth += direction * dt;
        double dissipated = 0;
        for (std::size_t n = 0; n < batch; ++n) {
            const double closing = direction * speeds[n];
            const auto response = law.advance(points[n], speeds[n] * depth, {closing, closing, speeds[n]}, dt,
                                              1.0 / batch, {.dissipated_budget = dissipated_budget});
            pressure += response.pressure, dissipated += response.dissipated;
        }
        dissipated_budget += dissipated;
        ::benchmark::DoNotOptimize(pressure);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(batch));
}
BENCHMARK(penalty);

}  // namespace
}  // namespace weavefront::benchmark
