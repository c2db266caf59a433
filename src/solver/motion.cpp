#include "weavefront/solver/motion.hpp"

#include <cmath>
#include <limits>

#include "weavefront/fabric/integers.hpp"
#include "weavefront/fabric/vectors.hpp"

namespace weavefront::solver {

namespace {

using fabric::Pack;
constexpr std::size_t together = fabric::pack_width;

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
    const double quantum = scale.quantum();  // the scale is a power of two: times its inverse is divided by it
    for (std::size_t n = 0; n < whole; n += together) {
        const Pack mass = Pack::load_anywhere(&nodes.mass[n]);
        const std::int64_t* force = nodes.force[n].data();
        double *v = nodes.v[n].data(), *x = nodes.x[n].data();
        for_blocks([&]<int block>() __attribute__((always_inline)) {
            constexpr auto at = block * together;
            const Pack f = to_pack(fabric::Integers::load(force + at)) * quantum;
            const Pack next = Pack::load_anywhere(v + at) + step * (f / fabric::spread<block>(mass));
            next.store_anywhere(v + at);
            (Pack::load_anywhere(x + at) + dt * next).store_anywhere(x + at);
        });
    }
    for (std::size_t n = whole; n < count; ++n)
        for (std::size_t d = 0; d < 3; ++d) {
            const auto i = static_cast<Eigen::Index>(d);
            nodes.v[n][i] += step * (scale.to(nodes.force[n][d]) / nodes.mass[n]);
            nodes.x[n][i] += dt * nodes.v[n][i];
        }
}

bool any_moved_across(std::span<const Vec3> now, std::span<const Vec3> before, double limit) {
    constexpr double any = std::numeric_limits<double>::infinity();
    alignas(64) const double limits[3 * together] = {limit, limit, any, limit, limit, any, limit, limit, any, limit, limit, any,
                                                     limit, limit, any, limit, limit, any, limit, limit, any, limit, limit, any};
    const auto whole = before.size() / together * together;
    fabric::Mask far{};
    for (std::size_t n = 0; n < whole; n += together)
        for (std::size_t block = 0; block < 3; ++block) {
            const auto at = block * together;
            const Pack way = Pack::load_anywhere(now[n].data() + at) - Pack::load_anywhere(before[n].data() + at);
            far = far | (abs(way) > Pack::load(limits + at));
        }
    bool found = fabric::any(far);
    for (std::size_t n = whole; n < before.size(); ++n)
        found = found || std::abs(now[n].x() - before[n].x()) > limit || std::abs(now[n].y() - before[n].y()) > limit;
    return found;
}

}  // namespace weavefront::solver
