#include "weavefront/solver/joined_fabric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace weavefront::solver {

namespace {

/// Sets of local nodes that grow together.
class Sets {
  public:
    explicit Sets(std::size_t nodes) : parents_(nodes) { std::iota(parents_.begin(), parents_.end(), 0); }

    [[nodiscard]] std::size_t root(std::size_t node) {
        while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
        return node;
    }
    void join(std::int32_t a, std::int32_t b) {
        const auto of_a = root(static_cast<std::size_t>(a)), of_b = root(static_cast<std::size_t>(b));
        parents_[std::max(of_a, of_b)] = std::min(of_a, of_b);
    }

  private:
    std::vector<std::size_t> parents_;
};

/// How the yarns of a ply run through its elements.
enum class Run { along_x, along_y, aslant };

Run run_of_fill(const mesh::Panel& panel, std::int32_t ply) {
    constexpr double most_aslant = std::numbers::pi / 8;  // half of 45 deg
    const double angle = panel.plies[static_cast<std::size_t>(ply)].angle;
    if (std::abs(std::sin(angle)) < std::sin(most_aslant)) return Run::along_x;
    return std::abs(std::cos(angle)) < std::sin(most_aslant) ? Run::along_y : Run::aslant;
}

void join_along(Run run, const std::array<std::int32_t, 4>& corners, Sets& sets) {
    const auto& [a, b, c, d] = corners;
    if (run != Run::along_y) sets.join(a, b), sets.join(d, c);
    if (run != Run::along_x) sets.join(a, d), sets.join(b, c);
}

Sets joined_by_yarns(const Model& model, const mesh::Panel& panel) {
    Sets sets(static_cast<std::size_t>(model.nodes.count));
    for (std::size_t e = 0; e < static_cast<std::size_t>(model.surface.owned); ++e) {
        const auto slot = model.slots[e];
        const auto& group = *model.groups[static_cast<std::size_t>(slot.group)];
        if (!group.alive(slot.index)) continue;
        const auto& facet = model.surface.facets[e];
        const auto fill = run_of_fill(panel, facet.ply);
        const auto warp = fill == Run::along_x   ? Run::along_y
                          : fill == Run::along_y ? Run::along_x
                                                 : Run::aslant;
        const auto intact = group.intact_yarns(slot.index);
        if (intact.fill) join_along(fill, facet.nodes, sets);
        if (intact.warp) join_along(warp, facet.nodes, sets);
    }
    return sets;
}

using Marks = std::vector<std::uint8_t>;

/// Marks all nodes that belong together with marked ones, on all ranks. @note Collective
void spread(Marks& marks, Sets& sets, const Model& model, const parallel::Communicator& comm) {
    auto exchange = halo_exchange(model.halo);
    bool changed = true;
    while (comm.any(changed)) {
        for (std::size_t n = 0; n < marks.size(); ++n)
            if (marks[n]) marks[sets.root(n)] = 1;
        std::vector<FixedVector> shared(marks.size(), FixedVector{});
        for (std::size_t n = 0; n < marks.size(); ++n) shared[n][0] = marks[n] = marks[sets.root(n)];
        exchange.sum(comm, shared);
        changed = false;
        for (std::size_t n = 0; n < marks.size(); ++n) {
            if (shared[n][0] == 0 || marks[n]) continue;
            marks[n] = 1;
            changed = true;
        }
    }
}

/// Whether an edge of the target holds its nodes: planes of symmetry hold none along the shot.
bool is_held(const Nodes& nodes, std::size_t node) { return (nodes.supports[node] & 4U) != 0; }

/// The largest piece of each ply. Pieces are found one after the other until what is left cannot hold a
/// larger one. @note Collective
Marks largest_pieces(Sets& sets, const Model& model, const mesh::Panel& panel,
                     const parallel::Communicator& comm) {
    constexpr auto none = std::numeric_limits<std::int64_t>::max();
    const auto& nodes = model.nodes;
    const auto count = static_cast<std::size_t>(nodes.count);
    const auto ply_of = [&](std::size_t n) {
        return static_cast<std::size_t>(nodes.ids[n] / panel.nodes_per_ply());
    };
    std::vector<std::int64_t> left(panel.plies.size(), panel.nodes_per_ply()), best(panel.plies.size(), 0);
    Marks seen(count, 0), largest(count, 0);
    while (!std::ranges::equal(left, best, std::ranges::less_equal{})) {
        std::vector<std::int64_t> first(panel.plies.size(), none);
        for (std::size_t n = 0; n < count; ++n)
            if (!seen[n] && left[ply_of(n)] > best[ply_of(n)])
                first[ply_of(n)] = std::min(first[ply_of(n)], nodes.ids[n]);
        comm.min(first);
        Marks piece(count, 0);
        for (std::size_t n = 0; n < count; ++n) piece[n] = nodes.ids[n] == first[ply_of(n)];
        spread(piece, sets, model, comm);
        std::vector<std::int64_t> sizes(panel.plies.size(), 0);
        for (std::size_t n = 0; n < count; ++n) sizes[ply_of(n)] += piece[n] && nodes.owned[n] ? 1 : 0;
        comm.sum(sizes);
        for (std::size_t n = 0; n < count; ++n) {
            if (sizes[ply_of(n)] > best[ply_of(n)]) largest[n] = piece[n];
            seen[n] = seen[n] | piece[n];
        }
        for (std::size_t p = 0; p < sizes.size(); ++p) {
            best[p] = std::max(best[p], sizes[p]);
            left[p] -= sizes[p];
        }
    }
    return largest;
}

}  // namespace

void JoinedFabric::find(const Model& model, const mesh::Panel& panel, const parallel::Communicator& comm) {
    auto sets = joined_by_yarns(model, panel);
    Marks held(static_cast<std::size_t>(model.nodes.count), 0);
    for (std::size_t n = 0; n < held.size(); ++n) held[n] = is_held(model.nodes, n);
    if (comm.any(std::ranges::find(held, 1) != held.end())) {
        spread(held, sets, model, comm);
        nodes_ = std::move(held);
    } else {
        nodes_ = largest_pieces(sets, model, panel, comm);
    }
}

bool JoinedFabric::is_eroded(const Model& model, std::size_t element) {
    const auto slot = model.slots[element];
    return !model.groups[static_cast<std::size_t>(slot.group)]->alive(slot.index);
}

bool JoinedFabric::is_at_joined_node(const Model& model, std::size_t element) const {
    return std::ranges::any_of(model.surface.facets[element].nodes,
                               [&](auto node) { return has_node(static_cast<std::size_t>(node)); });
}

}  // namespace weavefront::solver
