#include "misses.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::solver {

contact::Deepest deepest_of_all(const contact::Deepest& local, const parallel::Communicator& comm) {
    struct Plain {
        double overlap, in_thicknesses, x, y, z, time;
        std::int64_t element;
    };
    const auto& [overlap, in_thicknesses, place, element, time] = local;
    contact::Deepest deepest;
    for (const auto& of : parallel::all_gather(
             comm, Plain{overlap, in_thicknesses, place.x(), place.y(), place.z(), time, element}))
        deepest.include({of.overlap, of.in_thicknesses, Vec3(of.x, of.y, of.z), of.element, of.time});
    return deepest;
}

CrossedElements elements_behind_whole_plies(const Model& model, const parallel::Communicator& comm) {
    std::vector<std::int64_t> eroded(model.surface.plies.size(), 0);
    for (std::size_t f = 0; f < static_cast<std::size_t>(model.surface.owned); ++f)
        if (!model.surface.alive[f]) ++eroded[static_cast<std::size_t>(model.surface.facets[f].ply)];
    comm.sum(eroded);
    std::array<std::int64_t, 1> count{0}, first{std::numeric_limits<std::int64_t>::max()};
    if (model.ply_contact)
        for (const auto f : model.ply_contact->behind_next_ply(model.surface, model.nodes.x)) {
            const auto& facet = model.surface.facets[static_cast<std::size_t>(f)];
            if (eroded[static_cast<std::size_t>(facet.ply) + 1] > 0) continue;
            ++count[0];
            first[0] = std::min<std::int64_t>(first[0], facet.id);
        }
    comm.sum(count);
    comm.min(first);
    return {count[0], first[0]};
}

}  // namespace weavefront::solver
