#include "weavefront/solver/assembly.hpp"

#include <algorithm>

#include "weavefront/simd/integers.hpp"

namespace weavefront::solver {

void Assembly::start(std::vector<FixedVector>& sums) {
    std::ranges::fill(sums, FixedVector{});
    faulty_element_ = -1;
    faulty_contacts_.clear();
    faulty_moment_ = faulty_force_ = false;
}

void Assembly::add_lane(const std::array<std::int32_t, 4>& nodes, std::span<const double> forces,
                        std::size_t lane, std::vector<FixedVector>& sums, std::int32_t element) {
    constexpr std::size_t width = shell::pack_width;
    std::array<FixedVector, 4> corner{};
    for (std::size_t d = 0; d < 3; ++d) {
        for (std::size_t a = 0; a < 3; ++a) {
            const double force = forces[(a * 3 + d) * width + lane];
            if (!scale_.fits(force)) {
                if (faulty_element_ < 0 || element < faulty_element_) faulty_element_ = element;
                return;
            }
            corner[a][d] = scale_.from(force);
        }
        corner[3][d] = -(corner[0][d] + corner[1][d] + corner[2][d]);
    }
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t d = 0; d < 3; ++d) sums[static_cast<std::size_t>(nodes[a])][d] += corner[a][d];
}

bool Assembly::add_pack(const std::array<std::array<std::int32_t, shell::pack_width>, 4>& nodes,
                        const double* forces, std::size_t lanes, std::vector<FixedVector>& sums) const {
    constexpr std::size_t width = shell::pack_width;
    const simd::Pack scale = scale_.scale();
    alignas(64) std::int64_t corner[4][3][width];
    simd::Mask fits = simd::Pack(0.0) < simd::Pack(1.0);
    for (std::size_t d = 0; d < 3; ++d) {
        simd::Integers rest{};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto scaled = simd::Pack::load(forces + (a * 3 + d) * width) * scale;
            fits = fits & (abs(scaled) < simd::Pack(parallel::FixedPoint::limit));
            const auto whole = simd::nearest(scaled);
            whole.store(corner[a][d]);
            rest = rest + whole;
        }
        (-rest).store(corner[3][d]);
    }
    if (!simd::all(fits)) return false;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        for (std::size_t a = 0; a < 4; ++a) {
            auto& sum = sums[static_cast<std::size_t>(nodes[a][lane])];
            for (std::size_t d = 0; d < 3; ++d) sum[d] += corner[a][d][lane];
        }
    return true;
}

void Assembly::add_packs(const shell::ElementGroup& group, std::int32_t first, std::int32_t count,
                         std::span<const double> forces, std::vector<FixedVector>& sums) {
    for (std::int32_t p = 0; p < count; ++p) {
        const auto& nodes = group.nodes(first + p);
        const auto pack_forces =
            forces.subspan(static_cast<std::size_t>(p) * shell::forces_per_pack, shell::forces_per_pack);
        const auto lanes = static_cast<std::size_t>(
            std::min(group.size() - (first + p) * shell::pack_width, shell::pack_width));
        if (add_pack(nodes, pack_forces.data(), lanes, sums)) continue;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const auto element =
                group.element((first + p) * shell::pack_width + static_cast<std::int32_t>(lane));
            add_lane({nodes[0][lane], nodes[1][lane], nodes[2][lane], nodes[3][lane]}, pack_forces, lane,
                     sums, element);
        }
    }
}

void Assembly::distribute(const std::array<std::int32_t, 4>& nodes, const std::array<Vec3, 4>& forces,
                          const FixedVector& total, std::vector<FixedVector>& sums) const {
    for (std::size_t d = 0; d < 3; ++d) {
        std::int64_t rest = total[d];
        for (std::size_t a = 0; a < 3; ++a) {
            const std::int64_t part = scale_.from(forces[a][static_cast<Eigen::Index>(d)]);
            rest -= part;
            sums[static_cast<std::size_t>(nodes[a])][d] += part;
        }
        sums[static_cast<std::size_t>(nodes[3])][d] += rest;
    }
}

void Assembly::add_pair(const contact::PairForce& pair, std::vector<FixedVector>& sums,
                        FixedVector* on_projectile) {
    FixedVector total{}, opposite{};
    for (std::size_t d = 0; d < 3; ++d) {
        const auto component = static_cast<Eigen::Index>(d);
        bool fits = scale_.fits(pair.total[component]);
        for (std::size_t a = 0; a < 4; ++a)
            fits =
                fits && scale_.fits(pair.on_slave[a][component]) && scale_.fits(pair.on_master[a][component]);
        if (!fits) {
            faulty_contacts_.push_back(pair.slave);
            return;
        }
        total[d] = scale_.from(pair.total[component]);
        opposite[d] = -total[d];
    }
    distribute(pair.slave, pair.on_slave, total, sums);
    if (pair.kind == contact::Master::projectile)
        for (std::size_t d = 0; d < 3; ++d) (*on_projectile)[d] += opposite[d];
    else if (pair.kind == contact::Master::facet)
        distribute(pair.master, pair.on_master, opposite, sums);
}

void Assembly::add_force(const Vec3& force, FixedVector& sum) {
    for (std::size_t d = 0; d < 3; ++d) {
        const double component = force[static_cast<Eigen::Index>(d)];
        if (scale_.fits(component))
            sum[d] += scale_.from(component);
        else
            faulty_force_ = true;
    }
}

void Assembly::add_moment(const Vec3& moment, FixedVector& sum) {
    for (std::size_t d = 0; d < 3; ++d) {
        const double component = moment[static_cast<Eigen::Index>(d)];
        if (moment_scale_.fits(component))
            sum[d] += moment_scale_.from(component);
        else
            faulty_moment_ = true;
    }
}

}  // namespace weavefront::solver
