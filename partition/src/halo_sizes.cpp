#include "weavefront/partition/halo_sizes.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace weavefront::partition {

namespace {

/// Columns [first, end) of one axis.
struct Range {
    std::int64_t first = std::numeric_limits<std::int64_t>::max(), end = 0;

    void include(std::int64_t i) { first = std::min(first, i), end = std::max(end, i + 1); }
    [[nodiscard]] bool has(std::int64_t i) const { return i >= first && i < end; }
};

struct Box {
    Range i, j;
};

std::vector<Box> bounding_boxes(const mesh::Panel& panel, const Decomposition& decomposition) {
    std::vector<Box> boxes(static_cast<std::size_t>(decomposition.parts));
    for (std::int64_t column = 0; column < panel.columns(); ++column) {
        auto& box = boxes[static_cast<std::size_t>(decomposition.owner[static_cast<std::size_t>(column)])];
        box.i.include(column % panel.columns_x());
        box.j.include(column / panel.columns_x());
    }
    return boxes;
}

/// The range and all columns within `reach` of it. @param lines grid lines of the axis, m
Range widened(const Range& range, const std::vector<double>& lines, double reach) {
    const double low = lines[static_cast<std::size_t>(range.first)] - reach, high = lines[static_cast<std::size_t>(range.end)] + reach;
    const auto first = std::lower_bound(lines.begin() + 1, lines.end(), low) - (lines.begin() + 1);
    const auto end = std::upper_bound(lines.begin(), lines.end() - 1, high) - lines.begin();
    return {first, end};
}

/// Counts each pair of parts once.
class Pairs {
  public:
    void add(std::int32_t from, std::int32_t to) { all_.emplace_back(from, to); }
    [[nodiscard]] std::span<const std::pair<std::int32_t, std::int32_t>> different() {
        std::ranges::sort(all_);
        all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
        return all_;
    }

  private:
    std::vector<std::pair<std::int32_t, std::int32_t>> all_;
};

class Counter {
  public:
    Counter(const mesh::Panel& panel, const Decomposition& decomposition)
        : panel_(panel),
          decomposition_(decomposition),
          plies_(static_cast<std::int64_t>(panel.plies.size())),
          sizes_(static_cast<std::size_t>(decomposition.parts)) {
        for (const auto part : decomposition.owner) ++at(part).columns;
        for (std::int64_t node = 0; node < panel.nodes_per_ply(); ++node) holders_.push_back(holders_of(panel, decomposition, node));
    }

    void count_shared_nodes() {
        for (const auto& [parts, count] : holders_)
            for (const auto a : std::span(parts).first(static_cast<std::size_t>(count))) {
                at(a).nodes += plies_;
                for (const auto b : std::span(parts).first(static_cast<std::size_t>(count)))
                    if (a != b) move(a, b, force_bytes, forces_);
            }
        for (const auto& [from, to] : forces_.different()) ++at(from).neighbours;
    }

    void count_ghosts(double reach) {
        const auto boxes = bounding_boxes(panel_, decomposition_);
        for (std::int32_t part = 0; part < decomposition_.parts; ++part) {
            const auto& box = boxes[static_cast<std::size_t>(part)];
            count_ghosts(part, {widened(box.i, panel_.x, reach), widened(box.j, panel_.y, reach)});
        }
    }

    std::vector<PartSizes> sizes() {
        for (auto* links : {&forces_, &ghosts_})
            for (const auto& [from, to] : links->different()) ++at(from).messages;
        return std::move(sizes_);
    }

  private:
    PartSizes& at(std::int32_t part) { return sizes_[static_cast<std::size_t>(part)]; }

    void move(std::int32_t from, std::int32_t to, std::int64_t bytes, Pairs& links) {
        at(from).bytes_sent += bytes * plies_;
        at(to).bytes_received += bytes * plies_;
        links.add(from, to);
    }

    /// @param near columns whose facets are sent to the part, its own among them
    void count_ghosts(std::int32_t part, const Box& near) {
        const auto stride = panel_.columns_x() + 1;
        for (auto j = near.j.first; j <= near.j.end; ++j)
            for (auto i = near.i.first; i <= near.i.end; ++i) {
                const auto& holders = holders_[static_cast<std::size_t>(j * stride + i)];
                if (holders.has(part)) continue;
                at(part).ghosts += plies_;
                move(provider(i, j, near), part, ghost_bytes, ghosts_);
                for (const auto holder : std::span(holders.parts).first(static_cast<std::size_t>(holders.count)))
                    move(part, holder, force_bytes, forces_);
            }
    }

    /// The first of the parts that send a facet with this node.
    [[nodiscard]] std::int32_t provider(std::int64_t i, std::int64_t j, const Box& near) const {
        auto first = std::numeric_limits<std::int32_t>::max();
        for (const auto cj : {j - 1, j})
            for (const auto ci : {i - 1, i})
                if (near.i.has(ci) && near.j.has(cj))
                    first = std::min(first, decomposition_.owner[static_cast<std::size_t>(cj * panel_.columns_x() + ci)]);
        return first;
    }

    const mesh::Panel& panel_;
    const Decomposition& decomposition_;
    std::int64_t plies_;
    std::vector<PartSizes> sizes_;
    std::vector<Holders> holders_;
    Pairs forces_, ghosts_;
};

}  // namespace

Holders holders_of(const mesh::Panel& panel, const Decomposition& decomposition, std::int64_t footprint_node) {
    const auto stride = panel.columns_x() + 1;
    const auto i = footprint_node % stride, j = footprint_node / stride;
    Holders holders;
    for (auto cj = std::max<std::int64_t>(j - 1, 0); cj <= std::min(j, panel.columns_y() - 1); ++cj)
        for (auto ci = std::max<std::int64_t>(i - 1, 0); ci <= std::min(i, panel.columns_x() - 1); ++ci) {
            const auto part = decomposition.owner[static_cast<std::size_t>(cj * panel.columns_x() + ci)];
            if (holders.has(part)) continue;
            auto place = static_cast<std::size_t>(holders.count++);
            for (; place > 0 && holders.parts[place - 1] > part; --place) holders.parts[place] = holders.parts[place - 1];
            holders.parts[place] = part;
        }
    return holders;
}

std::vector<PartSizes> halo_sizes(const mesh::Panel& panel, const Decomposition& decomposition, double ghost_reach) {
    Counter counter(panel, decomposition);
    counter.count_shared_nodes();
    if (ghost_reach > 0) counter.count_ghosts(ghost_reach);
    return counter.sizes();
}

}  // namespace weavefront::partition
