#include "weavefront/study/rank_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace weavefront::study {
namespace {

/// A plan that gains less than a hundredth is no better than a simpler one.
constexpr double worthwhile = 0.99;

/// Time of a job on so many ranks: halo and imbalance eat a tenth of every doubling.
double duration(const Job& job, int ranks) {
    return job.cost / std::pow(std::min(ranks, job.columns), std::log2(1.8));
}

/// When the last group is done if each takes the next longest.
double side_by_side(std::span<const Job> jobs, std::span<const std::size_t> order, int groups,
                    int ranks_each) {
    std::vector<double> busy(static_cast<std::size_t>(groups), 0.0);
    for (const std::size_t job : order) *std::ranges::min_element(busy) += duration(jobs[job], ranks_each);
    return *std::ranges::max_element(busy);
}

}  // namespace

RankPlan plan_ranks(std::span<const Job> jobs, int ranks) {
    RankPlan best;
    best.order.resize(jobs.size());
    std::iota(best.order.begin(), best.order.end(), std::size_t{0});
    std::ranges::stable_sort(best.order,
                             [&](std::size_t a, std::size_t b) { return jobs[a].cost > jobs[b].cost; });
    const std::vector<std::size_t> order = best.order;
    double before = 0;
    for (std::size_t together = 0; together <= jobs.size(); ++together) {
        const std::span<const std::size_t> rest = std::span(order).subspan(together);
        for (int groups = 1; groups <= std::min<int>(ranks, std::max<int>(static_cast<int>(rest.size()), 1));
             ++groups) {
            const double expected = before + side_by_side(jobs, rest, groups, ranks / groups);
            if ((together == 0 && groups == 1) || expected < worthwhile * best.expected)
                best = {order, together, groups, expected};
        }
        if (together < jobs.size()) before += duration(jobs[order[together]], ranks);
    }
    return best;
}

int group_of(int rank, int ranks, int groups) {
    return static_cast<int>(static_cast<long>(rank) * groups / ranks);
}

}  // namespace weavefront::study
