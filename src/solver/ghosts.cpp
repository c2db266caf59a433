#include "weavefront/solver/ghosts.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "weavefront/contact/footprint_bins.hpp"
#include "weavefront/mesh/adjacency_list.hpp"
#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::solver {

using contact::Footprint;

namespace {

/// A facet as it travels.
struct FacetMessage {
    std::int64_t id;
    std::array<std::int32_t, 4> nodes;  ///< among those that travel with it; on arrival, local
    std::int32_t ply, on_free_edge;
};

/// A node as it travels; the same from every rank that sends it, but for its index on this rank.
struct NodeMessage {
    std::int64_t id;
    std::array<double, 3> x, v;
    double mass;
    std::int32_t owner, supports;
};

template <class T>
using ByRank = std::vector<std::vector<T>>;

/// Bisection without branches, of which every other one would be mispredicted. @param ids ascending @return
/// -1: none
std::int32_t index_in(std::span<const std::int64_t> ids, std::int64_t id) {
    if (ids.empty()) return -1;
    const auto* first = ids.data();
    for (auto count = ids.size(); count > 1; count -= count / 2)
        first += first[count / 2 - 1] < id ? count / 2 : 0;
    return *first == id ? static_cast<std::int32_t>(first - ids.data()) : -1;
}

/// Own nodes and ghosts by their global ids.
class LocalIndices {
  public:
    explicit LocalIndices(const Nodes& nodes) : own_(nodes.ids), count_(nodes.count) {}

    /// @param ids ascending
    void set_ghosts(std::vector<std::int64_t> ids) { ghosts_ = std::move(ids); }

    [[nodiscard]] std::int32_t own(std::int64_t id) const { return index_in(own_, id); }
    [[nodiscard]] std::int32_t ghost(std::int64_t id) const { return count_ + index_in(ghosts_, id); }
    [[nodiscard]] std::int32_t of(std::int64_t id) const {
        const auto index = own(id);
        return index >= 0 ? index : ghost(id);
    }
    [[nodiscard]] bool is_own(std::int32_t index) const { return index < count_; }
    [[nodiscard]] std::int64_t id(std::int32_t index) const {
        return is_own(index) ? own_[static_cast<std::size_t>(index)]
                             : ghosts_[static_cast<std::size_t>(index - count_)];
    }

  private:
    std::span<const std::int64_t> own_;
    std::int32_t count_;
    std::vector<std::int64_t> ghosts_;
};

/// The lowest rank that holds each node.
std::vector<std::int32_t> owners(const partition::HaloPlan& plan, int rank) {
    std::vector<std::int32_t> owners(plan.owned.size(), rank);
    for (const auto& neighbour : plan.neighbours)
        for (const auto node : neighbour.nodes) {
            auto& owner = owners[static_cast<std::size_t>(node)];
            owner = std::min(owner, neighbour.rank);
        }
    return owners;
}

double width(const Footprint& footprint) {
    return std::max(footprint.x_high - footprint.x_low, footprint.y_high - footprint.y_low);
}

/// The alive facets of all plies over each of a rank's columns.
class ColumnFootprints {
  public:
    ColumnFootprints(const contact::SweptBounds& swept, const contact::Surface& surface)
        : columns(static_cast<std::size_t>(surface.owned) / surface.plies.size()) {
        std::vector<double> widest(columns.size(), 0);
        for_each(surface, [&](std::size_t f, std::size_t column) {
            const auto footprint = swept.of(surface.facets[f]);
            columns[column].include(footprint);
            widest[column] = std::max(widest[column], width(footprint));
        });
        // Fragments have flown away from some columns: what lies between is nobody's.
        const auto is_torn = [&](std::size_t column) { return width(columns[column]) > 2 * widest[column]; };
        for (std::size_t column = 0; column < columns.size(); ++column)
            if (!is_torn(column)) covering.push_back(columns[column]);
        for_each(surface, [&](std::size_t f, std::size_t column) {
            if (is_torn(column)) covering.push_back(swept.of(surface.facets[f]));
        });
    }

    std::vector<Footprint> columns;  ///< around all facets of each; empty: none is left
    std::vector<Footprint>
        covering;  ///< together over all facets: of columns where they are still in place, else of facets

  private:
    template <class Use>
    void for_each(const contact::Surface& surface, Use use) const {
        for (std::size_t f = 0; f < static_cast<std::size_t>(surface.owned); ++f)
            if (surface.alive[f]) use(f, f % columns.size());
    }
};

/// Footprints of other ranks' columns and facets that may be near this one's. @param of this one's
ByRank<Footprint> footprints_around(const parallel::Communicator& comm, double reach,
                                    const std::vector<Footprint>& of) {
    Footprint mine;
    for (const auto& footprint : of) mine.include(footprint);
    ByRank<Footprint> outgoing(static_cast<std::size_t>(comm.size()));
    const auto theirs = parallel::all_gather(comm, mine);
    for (std::size_t r = 0; r < theirs.size(); ++r) {
        if (static_cast<int>(r) == comm.rank() || !theirs[r].near(mine, reach)) continue;
        for (const auto& footprint : of)
            if (theirs[r].near(footprint, reach)) outgoing[r].push_back(footprint);
    }
    return parallel::all_to_all(comm, outgoing);
}

bool is_on_free_edge(const contact::Surface& surface, std::size_t facet) {
    return !surface.on_free_edge.empty() && surface.on_free_edge[facet] != 0;
}

/// Facets of this rank, by the rank that needs them, each list column by column.
struct Choice {
    ByRank<GhostFacet> all, needed;  ///< needed: until the next renewal
};

Choice choose(const parallel::Communicator& comm, const contact::SweptBounds& swept, double reach,
              double spare, const contact::Surface& surface) {
    const auto ranks = static_cast<std::size_t>(comm.size());
    Choice choice{ByRank<GhostFacet>(ranks), ByRank<GhostFacet>(ranks)};
    if (ranks == 1) return choice;
    const ColumnFootprints footprints(swept, surface);
    const auto& columns = footprints.columns;
    const auto around = footprints_around(comm, reach, footprints.covering);
    for (std::size_t r = 0; r < ranks; ++r) {
        if (around[r].empty()) continue;
        const contact::FootprintBins bins(around[r], reach);
        for (std::size_t column = 0; column < columns.size(); ++column) {
            if (!bins.any_near(columns[column], reach)) continue;
            for (auto f = column; f < static_cast<std::size_t>(surface.owned); f += columns.size()) {
                const auto footprint = swept.of(surface.facets[f]);
                if (!surface.alive[f] || !bins.any_near(footprint, reach)) continue;
                const GhostFacet facet{static_cast<std::int32_t>(f), is_on_free_edge(surface, f)};
                choice.all[r].push_back(facet);
                if (bins.any_near(footprint, reach - spare)) choice.needed[r].push_back(facet);
            }
        }
    }
    return choice;
}

/// What other ranks are told.
struct Outgoing {
    ByRank<FacetMessage> facets;
    ByRank<NodeMessage> nodes;
};

Outgoing messages_of(const ByRank<GhostFacet>& chosen, const partition::HaloPlan& plan,
                     const contact::Surface& surface, const Nodes& nodes, int rank) {
    const auto owner = owners(plan, rank);
    Outgoing out{ByRank<FacetMessage>(chosen.size()), ByRank<NodeMessage>(chosen.size())};
    std::vector<std::int32_t> sent_slot(
        owner.size());  // its position in the message to the rank at hand, or -1
    for (std::size_t r = 0; r < chosen.size(); ++r) {
        if (chosen[r].empty()) continue;
        std::ranges::fill(sent_slot, -1);
        const auto send_node = [&](std::int32_t node) {
            const auto n = static_cast<std::size_t>(node);
            if (sent_slot[n] < 0) {
                const Vec3 &x = nodes.x[n], &v = nodes.v[n];
                sent_slot[n] = static_cast<std::int32_t>(out.nodes[r].size());
                out.nodes[r].push_back({nodes.ids[n],
                                        {x[0], x[1], x[2]},
                                        {v[0], v[1], v[2]},
                                        nodes.mass[n],
                                        owner[n],
                                        nodes.supports[n]});
            }
            return sent_slot[n];
        };
        for (const auto& [f, on_free_edge] : chosen[r]) {
            const auto& facet = surface.facets[static_cast<std::size_t>(f)];
            auto& message = out.facets[r].emplace_back(FacetMessage{facet.id, {}, facet.ply, on_free_edge});
            std::ranges::transform(facet.nodes, message.nodes.begin(), send_node);
        }
    }
    return out;
}

/// What arrives of nodes.
struct Arrived {
    ByRank<std::int32_t> indices;  ///< of the nodes from each rank
    ByRank<std::int64_t> wanted;   ///< ids of the ghosts, by the rank that owns them
};

/// Takes the ghost nodes in, in ascending global order.
Arrived take_in(const ByRank<NodeMessage>& incoming, LocalIndices& indices, Nodes& nodes) {
    Arrived arrived{ByRank<std::int32_t>(incoming.size()), ByRank<std::int64_t>(incoming.size())};
    std::vector<NodeMessage> ghosts;
    for (std::size_t r = 0; r < incoming.size(); ++r)
        for (const auto& message : incoming[r])
            if (arrived.indices[r].emplace_back(indices.own(message.id)) < 0) ghosts.push_back(message);
    std::ranges::sort(ghosts, {}, &NodeMessage::id);
    const auto is_same = [](const NodeMessage& a, const NodeMessage& b) { return a.id == b.id; };
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end(), is_same), ghosts.end());

    std::vector<std::int64_t> ids;
    nodes.resize_ghosts(ghosts.size());
    auto n = static_cast<std::size_t>(nodes.count);
    for (const auto& ghost : ghosts) {
        nodes.x[n] = Vec3(ghost.x.data());
        nodes.v[n] = Vec3(ghost.v.data());
        nodes.mass[n] = ghost.mass;
        nodes.supports[n++] = static_cast<std::uint8_t>(ghost.supports);
        ids.push_back(ghost.id);
        arrived.wanted[static_cast<std::size_t>(ghost.owner)].push_back(ghost.id);
    }
    indices.set_ghosts(std::move(ids));
    for (std::size_t r = 0; r < incoming.size(); ++r)
        for (std::size_t k = 0; k < incoming[r].size(); ++k)
            if (auto& index = arrived.indices[r][k]; index < 0) index = indices.ghost(incoming[r][k].id);
    return arrived;
}

/// Takes the ghost facets in, in ascending global order. @param indices of the nodes that came with them
void take_in_facets(ByRank<FacetMessage> incoming, const ByRank<std::int32_t>& indices,
                    contact::Surface& surface) {
    std::vector<FacetMessage> ghosts;
    for (std::size_t r = 0; r < incoming.size(); ++r)
        for (auto& message : incoming[r]) {
            for (auto& node : message.nodes) node = indices[r][static_cast<std::size_t>(node)];
            ghosts.push_back(message);
        }
    std::ranges::sort(ghosts, {}, &FacetMessage::id);
    surface.facets.resize(static_cast<std::size_t>(surface.owned));
    surface.alive.resize(static_cast<std::size_t>(surface.owned));
    const bool has_free_edges = !surface.on_free_edge.empty();
    if (has_free_edges) surface.on_free_edge.resize(static_cast<std::size_t>(surface.owned));
    for (const auto& ghost : ghosts) {
        surface.facets.push_back({ghost.id, ghost.nodes, ghost.ply});
        surface.alive.push_back(1);
        if (has_free_edges) surface.on_free_edge.push_back(static_cast<std::uint8_t>(ghost.on_free_edge));
    }
}

/// By own node: the other ranks that hold it.
mesh::AdjacencyList<std::int32_t> other_holders(const partition::HaloPlan& plan) {
    return {plan.owned.size(), [&](const auto& use) {
                for (const auto& neighbour : plan.neighbours)
                    for (const auto node : neighbour.nodes) use(node, neighbour.rank);
            }};
}

/// What the owner of a node tells those that know it: the node, and one other rank that knows it.
struct Sharer {
    std::int64_t node;
    std::int32_t rank, has_it_as_ghost;
};

/// Introduces all ranks to each other that hold a node or have it as a ghost. @param wanted by each rank of
/// this one's nodes
ByRank<Sharer> announce_sharers(const ByRank<std::int64_t>& wanted, const partition::HaloPlan& plan,
                                const LocalIndices& indices, int rank) {
    std::vector<std::pair<std::int64_t, std::int32_t>> ghosts;  // id, rank
    for (std::size_t r = 0; r < wanted.size(); ++r)
        for (const auto id : wanted[r]) ghosts.emplace_back(id, static_cast<std::int32_t>(r));
    std::ranges::sort(ghosts);
    const auto holders = other_holders(plan);
    ByRank<Sharer> outgoing(wanted.size());
    struct KnownBy {
        std::int32_t rank, as_ghost;
    };
    std::vector<KnownBy> known_by;
    for (std::size_t g = 0; g < ghosts.size();) {
        const auto id = ghosts[g].first;
        const auto others = holders[indices.own(id)];
        known_by.assign(1, {rank, 0});
        for (const auto other : others) known_by.push_back({other, 0});
        for (; g < ghosts.size() && ghosts[g].first == id; ++g) known_by.push_back({ghosts[g].second, 1});
        for (const auto& to : known_by)
            for (const auto& other : known_by)
                if (to.rank != other.rank)
                    outgoing[static_cast<std::size_t>(to.rank)].push_back({id, other.rank, other.as_ghost});
    }
    return outgoing;
}

/// A node that another rank knows, too.
struct Shared {
    std::int64_t id;
    std::int32_t index;
    bool ghost_here, ghost_there;
};

/// A rank has something to add to a ghost only where its plies press on others, so that most of that is zero.
/// @param nodes in global order
parallel::SendList send_list_of(std::span<const Shared> nodes, bool Shared::*ghost) {
    parallel::SendList list;
    for (const auto& node : nodes)
        if (!(node.*ghost)) list.nodes.push_back(node.index);
    list.dense_count = list.nodes.size();
    for (const auto& node : nodes)
        if (node.*ghost) list.nodes.push_back(node.index);
    return list;
}

/// @param announced by the owners, nodes that are ghosts somewhere; all others are shared as the plan says
std::vector<parallel::Neighbour> neighbours_of(const ByRank<Sharer>& announced,
                                               const partition::HaloPlan& plan, const LocalIndices& indices) {
    ByRank<Shared> shared(announced.size());
    std::vector<bool> is_announced(plan.owned.size(), false);
    for (const auto& messages : announced)
        for (const auto& [node, rank, has_it_as_ghost] : messages) {
            const auto index = indices.of(node);
            const bool own = indices.is_own(index);
            shared[static_cast<std::size_t>(rank)].push_back({node, index, !own, has_it_as_ghost != 0});
            if (own) is_announced[static_cast<std::size_t>(index)] = true;
        }
    for (const auto& neighbour : plan.neighbours)
        for (const auto node : neighbour.nodes)
            if (!is_announced[static_cast<std::size_t>(node)])
                shared[static_cast<std::size_t>(neighbour.rank)].push_back(
                    {indices.id(node), node, false, false});
    std::vector<parallel::Neighbour> neighbours;
    for (std::size_t r = 0; r < shared.size(); ++r) {
        if (shared[r].empty()) continue;
        std::ranges::sort(shared[r], {}, &Shared::id);
        neighbours.emplace_back(static_cast<int>(r), send_list_of(shared[r], &Shared::ghost_here),
                                send_list_of(shared[r], &Shared::ghost_there));
    }
    return neighbours;
}

}  // namespace

ForceExchange halo_exchange(const partition::HaloPlan& plan) {
    std::vector<parallel::Neighbour> neighbours;
    for (const auto& neighbour : plan.neighbours) neighbours.emplace_back(neighbour.rank, neighbour.nodes);
    return ForceExchange(std::move(neighbours));
}

bool Ghosts::suffice(std::span<const GhostFacet> needed, std::span<const GhostFacet> known,
                     const contact::Surface& surface) {
    const auto columns = surface.owned / static_cast<std::int32_t>(surface.plies.size());
    const auto index = [&](const GhostFacet& ghost) { return std::pair(ghost.facet % columns, ghost.facet); };
    return std::ranges::includes(known, needed, {}, index, index) &&
           std::ranges::all_of(known, [&](const GhostFacet& ghost) {
               const auto f = static_cast<std::size_t>(ghost.facet);
               return surface.alive[f] && ghost.on_free_edge == is_on_free_edge(surface, f);
           });
}

bool Ghosts::renew(const parallel::Communicator& comm, const partition::HaloPlan& plan,
                   const contact::SweptBounds& swept, double reach, double spare, contact::Surface& surface,
                   Nodes& nodes, ForceExchange& exchange) {
    auto choice = choose(comm, swept, reach, spare, surface);
    bool suffices = known_.size() == choice.needed.size();
    for (std::size_t r = 0; suffices && r < known_.size(); ++r)
        suffices = suffice(choice.needed[r], known_[r], surface);
    if (!comm.any(!suffices)) return false;
    known_ = std::move(choice.all);
    LocalIndices indices(nodes);
    const auto out = messages_of(known_, plan, surface, nodes, comm.rank());
    const auto arrived = take_in(parallel::all_to_all(comm, out.nodes), indices, nodes);
    take_in_facets(parallel::all_to_all(comm, out.facets), arrived.indices, surface);
    const auto announced =
        announce_sharers(parallel::all_to_all(comm, arrived.wanted), plan, indices, comm.rank());
    exchange = ForceExchange(neighbours_of(parallel::all_to_all(comm, announced), plan, indices));
    return true;
}

}  // namespace weavefront::solver
