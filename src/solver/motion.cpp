#include "weavefront/solver/motion.hpp"

#include "weavefront/simd/integers.hpp"
#include "weavefront/simd/vectors.hpp"
#include "weavefront/solver/central_difference.hpp"

namespace weavefront::solver {

namespace {

using simd::Pack;
constexpr std::size_t together = simd::pack_width;

/// Calls with the number of each of the three packs that eight vectors fill.
template <class Call>
WEAVEFRONT_INLINE void for_blocks(Call call) {
    call.template operator()<0>();
    call.template operator()<1>();
    call.template operator()<2>();
}

}  // namespace

void move_freely(Nodes& nodes, const parallel::FixedPoint& scale, double step, double dt) {
    const auto count = nodes.x.size(), whole = count / together * together;
    const double quantum =
        scale.quantum();  // the scale is a power of two: times its inverse is divided by it
    for (std::size_t n = 0; n < whole; n += together) {
        const Pack mass = Pack::load_anywhere(&nodes.mass[n]);
        const std::int64_t* force = nodes.force[n].data();
        double *v = nodes.v[n].data(), *x = nodes.x[n].data();
        for_blocks([&]<int block>() __attribute__((always_inline)) {
            constexpr auto at = block * together;
            const Pack f = to_pack(simd::Integers::load(force + at)) * quantum;
            const Pack acceleration = f / simd::spread<block>(mass);
            const Pack next = next_velocity(Pack::load_anywhere(v + at), acceleration, step);
            next.store_anywhere(v + at);
            (Pack::load_anywhere(x + at) + dt * next).store_anywhere(x + at);
        });
    }
    for (std::size_t n = whole; n < count; ++n)
        for (std::size_t d = 0; d < 3; ++d) {
            const auto i = static_cast<Eigen::Index>(d);
            const double acceleration = scale.to(nodes.force[n][d]) / nodes.mass[n];
            nodes.v[n][i] = next_velocity(nodes.v[n][i], acceleration, step);
            nodes.x[n][i] += dt * nodes.v[n][i];
        }
}

std::array<double, energies_at_once> kinetic_energies(const Nodes& nodes, const parallel::FixedPoint& scale,
                                                      std::size_t first, double step, double last_dt) {
    static_assert(energies_at_once == together);
    const double quantum = scale.quantum();
    const Pack mass = Pack::load_anywhere(&nodes.mass[first]);
    const std::int64_t* force = nodes.force[first].data();
    const double* v = nodes.v[first].data();
    std::array<double, 3 * together> products;
    for_blocks([&]<int block>() __attribute__((always_inline)) {
        constexpr auto at = block * together;
        const Pack f = to_pack(simd::Integers::load(force + at)) * quantum, now = Pack::load_anywhere(v + at);
        const Pack next = next_velocity(now, Pack(f / simd::spread<block>(mass)), step);
        const Pack acceleration = acceleration_between(now, next, step);
        (now * opposite_velocity(now, acceleration, last_dt)).store_anywhere(products.data() + at);
    });
    std::array<double, energies_at_once> energies;
    for (std::size_t n = 0; n < together; ++n)
        energies[n] =
            nodes.mass[first + n] * (products[3 * n] + products[3 * n + 1] + products[3 * n + 2]) / 2;
    return energies;
}

}  // namespace weavefront::solver
