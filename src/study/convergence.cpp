#include "weavefront/study/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::study {
namespace {

double slope(std::span<const Point> points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(points.size());
    for (const Point& point : points) {
        x += std::log(point.size) / n;
        y += std::log(point.error) / n;
    }
    for (const Point& point : points) {
        xx += (std::log(point.size) - x) * (std::log(point.size) - x);
        xy += (std::log(point.size) - x) * (std::log(point.error) - y);
    }
    return xy / xx;
}

/// +1 where a smaller size costs more (a mesh), -1 where it costs less (a number of steps).
double sense(std::span<const Point> series) {
    const Point &first = series.front(), &last = series.back();
    return (first.size - last.size) * (last.cost - first.cost) < 0 ? -1 : 1;
}

}  // namespace

std::vector<std::optional<double>> local_orders(std::span<const Point> series) {
    std::vector<std::optional<double>> orders;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const bool known = series[i - 1].error > rounding && series[i].error > rounding &&
                           series[i - 1].size != series[i].size;
        orders.push_back(known ? std::optional(sense(series) * slope(series.subspan(i - 1, 2)))
                               : std::nullopt);
    }
    return orders;
}

std::optional<double> observed_order(std::span<const Point> series) {
    const auto orders = local_orders(series);
    double largest = 0;
    for (const auto& order : orders) largest = std::max(largest, order.value_or(0));
    if (!(largest > least_order)) return std::nullopt;
    std::size_t begin = 0, length = 0;
    for (std::size_t i = 0, run = 0; i < orders.size(); ++i) {
        run = orders[i].value_or(0) >= largest / 2 ? run + 1 : 0;
        if (run > length) {
            length = run;
            begin = i + 1 - run;
        }
    }
    if (length < std::min<std::size_t>(2, orders.size())) return std::nullopt;
    return sense(series) * slope(series.subspan(begin, length + 1));
}

std::vector<bool> pareto_front(std::span<const double> costs, std::span<const double> errors) {
    std::vector<bool> front(costs.size(), false);
    const auto finite = [&](std::size_t i) { return std::isfinite(costs[i]) && std::isfinite(errors[i]); };
    for (std::size_t i = 0; i < costs.size(); ++i) {
        front[i] = finite(i);
        for (std::size_t j = 0; j < costs.size() && front[i]; ++j) {
            const bool no_worse = costs[j] <= costs[i] && errors[j] <= errors[i];
            const bool better = costs[j] < costs[i] || errors[j] < errors[i];
            if (finite(j) && no_worse && better) front[i] = false;
        }
    }
    return front;
}

}  // namespace weavefront::study
