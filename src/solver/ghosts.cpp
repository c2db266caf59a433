#include "weavefront/solver/ghosts.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::solver {

namespace {

struct Footprint {
    double x_low = std::numeric_limits<double>::max(), x_high = -x_low, y_low = x_low, y_high = -x_low;

    void include(const contact::Box& box) {
        x_low = std::min(x_low, box.low.x()), x_high = std::max(x_high, box.high.x());
        y_low = std::min(y_low, box.low.y()), y_high = std::max(y_high, box.high.y());
    }
    [[nodiscard]] contact::Box box() const { return {Vec3(x_low, y_low, 0), Vec3(x_high, y_high, 0)}; }
    [[nodiscard]] bool meets(const contact::Box& box, double reach) const {
        return box.low.x() <= x_high + reach && box.high.x() >= x_low - reach && box.low.y() <= y_high + reach &&
               box.high.y() >= y_low - reach;
    }
};

/// A facet as it travels.
struct FacetMessage {
    std::int64_t id;
    std::array<std::int64_t, 4> nodes;  ///< global
    std::int32_t ply, alive;
};

using Lists = std::vector<std::vector<std::int64_t>>;  // by rank

std::int32_t own_node(const Nodes& nodes, std::int64_t id) {
    const auto end = nodes.ids.begin() + nodes.count;
    const auto found = std::lower_bound(nodes.ids.begin(), end, id);
    return found != end && *found == id ? static_cast<std::int32_t>(found - nodes.ids.begin()) : -1;
}

/// All ranks that hold each node, this one first.
std::vector<std::vector<int>> holders(const partition::HaloPlan& plan, std::int32_t count, int rank) {
    std::vector<std::vector<int>> ranks(static_cast<std::size_t>(count), {rank});
    for (const auto& neighbour : plan.neighbours)
        for (const auto node : neighbour.nodes) ranks[static_cast<std::size_t>(node)].push_back(neighbour.rank);
    return ranks;
}

/// What other ranks need of this one's facets, and, as [node, number of holders, holders...], of their nodes.
struct Outgoing {
    std::vector<std::vector<FacetMessage>> facets;
    Lists nodes;
};

Outgoing select(const parallel::Communicator& comm, const partition::HaloPlan& plan, double reach, const contact::Surface& surface,
                const Nodes& nodes) {
    const auto ranks = static_cast<std::size_t>(comm.size());
    Footprint mine;
    std::vector<contact::Box> boxes;
    for (std::int32_t f = 0; f < surface.owned; ++f) {
        boxes.push_back(contact::Box::around(surface.facets[static_cast<std::size_t>(f)], nodes.x));
        mine.include(boxes.back());
    }
    const auto footprints = parallel::all_gather(comm, mine);
    const auto holding = holders(plan, nodes.count, comm.rank());
    Outgoing out{std::vector<std::vector<FacetMessage>>(ranks), Lists(ranks)};
    std::vector<std::size_t> told(static_cast<std::size_t>(nodes.count), ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
        if (static_cast<int>(r) == comm.rank() || !footprints[r].meets(mine.box(), reach)) continue;
        for (std::size_t f = 0; f < boxes.size(); ++f) {
            if (!footprints[r].meets(boxes[f], reach)) continue;
            const auto& facet = surface.facets[f];
            FacetMessage message{facet.id, {}, facet.ply, surface.alive[f]};
            for (std::size_t a = 0; a < 4; ++a) {
                const auto n = static_cast<std::size_t>(facet.nodes[a]);
                message.nodes[a] = nodes.ids[n];
                if (told[n] == r) continue;
                told[n] = r;
                out.nodes[r].push_back(nodes.ids[n]);
                out.nodes[r].push_back(static_cast<std::int64_t>(holding[n].size()));
                out.nodes[r].insert(out.nodes[r].end(), holding[n].begin(), holding[n].end());
            }
            out.facets[r].push_back(message);
        }
    }
    return out;
}

/// Takes the ghost nodes in: the first rank that sends one provides it; all holders will be sent what contact adds to it.
struct GhostNodes {
    std::map<std::int64_t, std::int32_t> local;  ///< of global ids
    Lists from_provider, to_holder;              ///< global ids by rank
};

GhostNodes take_in(const Lists& incoming, Nodes& nodes) {
    GhostNodes ghosts{{}, Lists(incoming.size()), Lists(incoming.size())};
    for (std::size_t r = 0; r < incoming.size(); ++r) {
        for (std::size_t at = 0; at < incoming[r].size();) {
            const auto id = incoming[r][at];
            const auto holders_count = static_cast<std::size_t>(incoming[r][at + 1]);
            if (own_node(nodes, id) < 0 &&
                ghosts.local.try_emplace(id, nodes.count + static_cast<std::int32_t>(ghosts.local.size())).second) {
                ghosts.from_provider[r].push_back(id);
                for (std::size_t h = 0; h < holders_count; ++h)
                    ghosts.to_holder[static_cast<std::size_t>(incoming[r][at + 2 + h])].push_back(id);
            }
            at += 2 + holders_count;
        }
    }
    const auto all = static_cast<std::size_t>(nodes.count) + ghosts.local.size();
    nodes.x.resize(all);
    nodes.v.resize(all);
    nodes.force.resize(all);
    return ghosts;
}

void take_in_facets(const std::vector<std::vector<FacetMessage>>& incoming, const GhostNodes& ghosts, const Nodes& nodes,
                    contact::Surface& surface) {
    surface.facets.resize(static_cast<std::size_t>(surface.owned));
    surface.alive.resize(static_cast<std::size_t>(surface.owned));
    for (const auto& messages : incoming)
        for (const auto& message : messages) {
            contact::Facet facet{message.id, {}, message.ply};
            for (std::size_t a = 0; a < 4; ++a) {
                const auto own = own_node(nodes, message.nodes[a]);
                facet.nodes[a] = own >= 0 ? own : ghosts.local.at(message.nodes[a]);
            }
            surface.facets.push_back(facet);
            surface.alive.push_back(static_cast<std::uint8_t>(message.alive));
        }
}

}  // namespace

Links halo_links(const partition::HaloPlan& plan) {
    std::vector<parallel::Link> links;
    for (const auto& neighbour : plan.neighbours) links.push_back({neighbour.rank, neighbour.nodes, neighbour.nodes});
    return {parallel::Exchange<FixedVector>(std::move(links)), {}, {}};
}

Links rebuild_ghosts(const parallel::Communicator& comm, const partition::HaloPlan& plan, double reach, contact::Surface& surface,
                     Nodes& nodes) {
    if (comm.size() == 1) return {};
    const auto out = select(comm, plan, reach, surface, nodes);
    const auto facets = parallel::all_to_all(comm, out.facets);
    const auto ghosts = take_in(parallel::all_to_all(comm, out.nodes), nodes);
    take_in_facets(facets, ghosts, nodes, surface);
    const auto wanted = parallel::all_to_all(comm, ghosts.from_provider), added = parallel::all_to_all(comm, ghosts.to_holder);

    const auto own = [&](const std::vector<std::int64_t>& ids, std::vector<std::int32_t>& to) {
        for (const auto id : ids) to.push_back(own_node(nodes, id));
    };
    const auto ghost = [&](const std::vector<std::int64_t>& ids, std::vector<std::int32_t>& to) {
        for (const auto id : ids) to.push_back(ghosts.local.at(id));
    };
    std::map<int, parallel::Link> forces, positions;
    for (const auto& neighbour : plan.neighbours) forces[neighbour.rank] = {neighbour.rank, neighbour.nodes, neighbour.nodes};
    for (std::size_t r = 0; r < wanted.size(); ++r) {
        const auto rank = static_cast<int>(r);
        if (!wanted[r].empty() || !ghosts.from_provider[r].empty()) {
            positions[rank].rank = rank;
            own(wanted[r], positions[rank].send);
            ghost(ghosts.from_provider[r], positions[rank].receive);
        }
        if (!added[r].empty() || !ghosts.to_holder[r].empty()) {
            forces[rank].rank = rank;
            ghost(ghosts.to_holder[r], forces[rank].send);
            own(added[r], forces[rank].receive);
        }
    }
    const auto values = [](std::map<int, parallel::Link>& map) {
        std::vector<parallel::Link> links;
        for (auto& [rank, link] : map) links.push_back(std::move(link));
        return links;
    };
    Links links{parallel::Exchange<FixedVector>(values(forces)), parallel::Exchange<std::array<double, 6>>(values(positions)), {}};
    update_ghosts(comm, links, nodes);
    return links;
}

void update_ghosts(const parallel::Communicator& comm, Links& links, Nodes& nodes) {
    if (links.ghosts.links().empty()) return;
    auto& values = links.values;
    values.resize(nodes.x.size());
    for (const auto& link : links.ghosts.links())
        for (const auto node : link.send) {
            const auto n = static_cast<std::size_t>(node);
            values[n] = {nodes.x[n].x(), nodes.x[n].y(), nodes.x[n].z(), nodes.v[n].x(), nodes.v[n].y(), nodes.v[n].z()};
        }
    links.ghosts.copy(comm, values);
    for (const auto& link : links.ghosts.links())
        for (const auto node : link.receive) {
            const auto n = static_cast<std::size_t>(node);
            nodes.x[n] = {values[n][0], values[n][1], values[n][2]};
            nodes.v[n] = {values[n][3], values[n][4], values[n][5]};
        }
}

}  // namespace weavefront::solver
