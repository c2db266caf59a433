#include "weavefront/partition/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "weavefront/partition/contact_zone.hpp"

namespace weavefront::partition {

namespace {

// Moments of the run at which the work of all ranks is compared, since the contact zone grows from rank to
// rank.
constexpr int moments = 16;

// Every step sums over all ranks once. Every fifth step also finds the smallest time step of all ranks.
constexpr double reductions_per_step = 1.2;

double crowding(const Machine& machine, int ranks) {
    if (machine.ranks < 2) return 1;
    const double share = std::min(1.0, (ranks - 1.0) / (machine.ranks - 1.0));
    return 1 + share * (machine.crowding - 1);
}

double exchange(const Machine& machine, const PartSizes& sizes) {
    return static_cast<double>(sizes.messages) * machine.latency +
           static_cast<double>(std::max(sizes.bytes_sent, sizes.bytes_received)) / machine.bandwidth;
}

/// Work of each part at the moments of the run, s.
class Work {
  public:
    Work(const scene::Scene& scene, const mesh::Panel& panel, const Decomposition& decomposition,
         std::span<const PartSizes> sizes, const Machine& machine)
        : scene_(scene),
          decomposition_(decomposition),
          plies_(static_cast<double>(panel.plies.size())),
          zone_(scene),
          distances_(zone_.distances(panel)),
          touch_(machine.touch * crowding(machine, decomposition.parts)),
          relief_(machine.decay) {
        const double crowded = crowding(machine, decomposition.parts);
        const double watched = zone_.plies() ? machine.watch + renewals(scene, machine) * machine.search : 0;
        for (const auto& part : sizes)
            everywhere_.push_back(crowded *
                                  (static_cast<double>(part.columns) * plies_ * (machine.element + watched) +
                                   static_cast<double>(part.nodes) * machine.node));
        for (std::size_t c = 0; c < distances_.size(); ++c)
            everywhere_[part_of(c)] += crowded * plies_ * zone_.press_weight(distances_[c]) * machine.press;
    }

    [[nodiscard]] std::vector<double> at(int moment) const {
        auto work = everywhere_;
        const double passed = (moment + 0.5) / moments, radius = zone_.radius(scene_.time.end * passed);
        const double touch = plies_ * touch_ * (1 - relief_ * passed);
        for (std::size_t c = 0; c < distances_.size(); ++c)
            if (distances_[c] < radius) work[part_of(c)] += touch;
        return work;
    }

  private:
    [[nodiscard]] std::size_t part_of(std::size_t column) const {
        return static_cast<std::size_t>(decomposition_.owner[column]);
    }

    const scene::Scene& scene_;
    const Decomposition& decomposition_;
    double plies_;
    ContactZone zone_;
    std::vector<double> distances_;
    double touch_, relief_;
    std::vector<double> everywhere_;
};

double over_mean(std::span<const double> values) {
    return *std::ranges::max_element(values) * static_cast<double>(values.size()) /
           std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

double renewals(const scene::Scene& scene, const Machine& machine) {
    return machine.searches_per_step * 100 * scene.largest_speed() / largest_wave_speed(scene);
}

Forecast forecast(const scene::Scene& scene, const mesh::Panel& panel, const Decomposition& decomposition,
                  double ghost_reach, const Machine& machine) {
    const auto sizes = halo_sizes(panel, decomposition, ghost_reach);
    const Work work(scene, panel, decomposition, sizes, machine);
    Forecast result{.ranks = decomposition.parts, .columns = panel.columns(), .elements = panel.elements()};
    std::vector<double> elements;
    double most_work = 0, all_work = 0;
    for (int moment = 0; moment < moments; ++moment) {
        const auto now = work.at(moment);
        double most = 0;
        for (std::size_t p = 0; p < now.size(); ++p)
            most = std::max(most, now[p] + exchange(machine, sizes[p]));
        most_work += *std::ranges::max_element(now);
        all_work += std::accumulate(now.begin(), now.end(), 0.0);
        result.seconds += most / moments;
    }
    if (decomposition.parts > 1)
        result.seconds += reductions_per_step * machine.reduction * std::ceil(std::log2(decomposition.parts));
    for (const auto& part : sizes) {
        elements.push_back(static_cast<double>(part.columns));
        result.most_neighbours = std::max(result.most_neighbours, part.neighbours);
        result.most_halo_bytes = std::max({result.most_halo_bytes, part.bytes_sent, part.bytes_received});
        result.halo_bytes += part.bytes_sent;
    }
    result.element_imbalance = over_mean(elements);
    result.cost_imbalance = most_work * static_cast<double>(sizes.size()) / all_work;
    result.cut_edges = cut_edges(decomposition, panel);
    return result;
}

double efficiency(const Forecast& forecast, const Forecast& alone) {
    const auto rate = [](const Forecast& f) { return static_cast<double>(f.elements) / f.ranks / f.seconds; };
    return rate(forecast) / rate(alone);
}

}  // namespace weavefront::partition
