#include "weavefront/partition/halo_sizes.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace weavefront::partition {

namespace {

/// Columns [first, end) of one axis.
struct Range {
    std::int64_t first, end;
};

/// By column of an axis: the columns within `reach` of it. @param lines grid lines of the axis, m
std::vector<Range> within_reach(const std::vector<double>& lines, double reach) {
    std::vector<Range> ranges;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
        ranges.push_back(
            {std::lower_bound(lines.begin() + 1, lines.end(), lines[i] - reach) - (lines.begin() + 1),
             std::upper_bound(lines.begin(), lines.end() - 1, lines[i + 1] + reach) - lines.begin()});
    return ranges;
}

/// Sorts values and removes duplicates.
template <class T>
void leave_each_once(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

class Counter {
  public:
    Counter(const mesh::Panel& panel, const Decomposition& decomposition)
        : panel_(panel),
          decomposition_(decomposition),
          plies_(static_cast<std::int64_t>(panel.plies.size())),
          sizes_(static_cast<std::size_t>(decomposition.parts)) {
        for (const auto part : decomposition.owner) ++at(part).columns;
        for (std::int64_t node = 0; node < panel.nodes_per_ply(); ++node)
            holders_.push_back(holders_of(panel, decomposition, node));
    }

    void find_ghosts(double reach) {
        const auto near_x = within_reach(panel_.x, reach), near_y = within_reach(panel_.y, reach);
        for (std::int64_t j = 0; j < panel_.columns_y(); ++j)
            for (std::int64_t i = 0; i < panel_.columns_x(); ++i) {
                const auto part = owner(i, j);
                const auto [first_i, end_i] = near_x[static_cast<std::size_t>(i)];
                const auto [first_j, end_j] = near_y[static_cast<std::size_t>(j)];
                for (auto other_j = first_j; other_j < end_j; ++other_j)
                    for (auto other_i = first_i; other_i < end_i; ++other_i)
                        if (owner(other_i, other_j) != part) add_corners(other_i, other_j, part);
            }
        leave_each_once(ghosts_);
    }

    std::vector<PartSizes> sizes() {
        std::vector<std::int32_t> knowing;
        auto ghost = ghosts_.begin();
        for (std::size_t node = 0; node < holders_.size(); ++node) {
            const auto& holders = holders_[node];
            knowing.assign(holders.parts.begin(), holders.parts.begin() + holders.count);
            for (const auto part : knowing) at(part).nodes += plies_;
            for (; ghost != ghosts_.end() && ghost->first == static_cast<std::int64_t>(node); ++ghost) {
                at(ghost->second).ghosts += plies_;
                knowing.push_back(ghost->second);
            }
            share(knowing, static_cast<std::size_t>(holders.count));
        }
        leave_each_once(neighbours_);
        leave_each_once(linked_);
        for (const auto& [from, to] : neighbours_) ++at(from).neighbours;
        for (const auto& [from, to] : linked_) ++at(from).messages;
        return std::move(sizes_);
    }

  private:
    using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

    PartSizes& at(std::int32_t part) { return sizes_[static_cast<std::size_t>(part)]; }
    [[nodiscard]] std::int32_t owner(std::int64_t i, std::int64_t j) const {
        return decomposition_.owner[static_cast<std::size_t>(j * panel_.columns_x() + i)];
    }

    /// Adds the corners of a column that a part does not hold to its ghosts.
    void add_corners(std::int64_t i, std::int64_t j, std::int32_t part) {
        for (const auto node_j : {j, j + 1})
            for (const auto node_i : {i, i + 1}) {
                const auto node = node_j * (panel_.columns_x() + 1) + node_i;
                if (!holders_[static_cast<std::size_t>(node)].has(part)) ghosts_.emplace_back(node, part);
            }
    }

    /// Counts the exchange of a node. @param knowing parts that know it; the first `holding` of them hold it
    void share(std::span<const std::int32_t> knowing, std::size_t holding) {
        for (std::size_t a = 0; a < knowing.size(); ++a)
            for (std::size_t b = 0; b < knowing.size(); ++b) {
                if (a == b) continue;
                if (a < holding) {
                    at(knowing[a]).bytes_sent += force_bytes * plies_;
                    at(knowing[b]).bytes_received += force_bytes * plies_;
                }
                linked_.emplace_back(knowing[a], knowing[b]);
                if (a < holding && b < holding) neighbours_.emplace_back(knowing[a], knowing[b]);
            }
    }

    const mesh::Panel& panel_;
    const Decomposition& decomposition_;
    std::int64_t plies_;
    std::vector<PartSizes> sizes_;
    std::vector<Holders> holders_;
    std::vector<std::pair<std::int64_t, std::int32_t>> ghosts_;  // footprint node, part
    Pairs linked_, neighbours_;
};

}  // namespace

Holders holders_of(const mesh::Panel& panel, const Decomposition& decomposition,
                   std::int64_t footprint_node) {
    const auto stride = panel.columns_x() + 1;
    const auto i = footprint_node % stride, j = footprint_node / stride;
    Holders holders;
    for (auto cj = std::max<std::int64_t>(j - 1, 0); cj <= std::min(j, panel.columns_y() - 1); ++cj)
        for (auto ci = std::max<std::int64_t>(i - 1, 0); ci <= std::min(i, panel.columns_x() - 1); ++ci) {
            const auto part = decomposition.owner[static_cast<std::size_t>(cj * panel.columns_x() + ci)];
            if (holders.has(part)) continue;
            auto place = static_cast<std::size_t>(holders.count++);
            for (; place > 0 && holders.parts[place - 1] > part; --place)
                holders.parts[place] = holders.parts[place - 1];
            holders.parts[place] = part;
        }
    return holders;
}

std::vector<PartSizes> halo_sizes(const mesh::Panel& panel, const Decomposition& decomposition,
                                  double ghost_reach) {
    Counter counter(panel, decomposition);
    if (ghost_reach > 0) counter.find_ghosts(ghost_reach);
    return counter.sizes();
}

}  // namespace weavefront::partition
