#include "weavefront/contact/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace weavefront::contact {

namespace {

struct Point {
    double xi, eta, share;
};

std::vector<Point> points_of(int n, int m) {
    if (n == 0) return {{-1, -1, 0.25}, {1, -1, 0.25}, {1, 1, 0.25}, {-1, 1, 0.25}};
    std::vector<Point> points;
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            points.push_back({(2.0 * i + 1) / n - 1, (2.0 * j + 1) / m - 1, 1.0 / (n * m)});
    return points;
}

}  // namespace

QuadratureRule quadrature(int n, int m) {
    const auto points = points_of(n, m);
    QuadratureRule rule((points.size() + batch_width - 1) / batch_width);
    for (std::size_t i = 0; i < rule.size() * batch_width; ++i) {
        const auto& [xi, eta, share] = points[std::min(i, points.size() - 1)];
        auto& batch = rule[i / batch_width];
        const auto lane = i % batch_width;
        set_shape_functions(batch.N, lane, xi, eta);
        batch.share[lane] = i < points.size() ? share : 0;
        if (i < points.size()) ++batch.count;
    }
    return rule;
}

std::int32_t Quadrature::rule_for(const std::array<Vec3, 4>& corners) {
    int n = 0, m = 0;
    if (spacing_) {
        // The tolerance keeps an element of a whole number of spacings at that number of points in spite of
        // rounding.
        const auto points = [&](double length) {
            return std::clamp(static_cast<int>(std::ceil(length / *spacing_ * (1 - 1e-9))), 1, most_);
        };
        n = points(std::max((corners[1] - corners[0]).norm(), (corners[2] - corners[3]).norm()));
        m = points(std::max((corners[3] - corners[0]).norm(), (corners[2] - corners[1]).norm()));
    }
    const auto same = [&](const Rule& rule) { return rule.n == n && rule.m == m; };
    auto found = std::ranges::find_if(rules_, same);
    if (found == rules_.end()) found = rules_.insert(rules_.end(), Rule{n, m, {}});
    return static_cast<std::int32_t>(found - rules_.begin());
}

std::array<Vec3, 4> Quadrature::spanned(std::int32_t index, const std::array<Vec3, 4>& corners) const {
    const auto& rule = rules_[static_cast<std::size_t>(index)];
    const auto outermost = [](int n) { return n == 0 ? 1 : 1 - 1.0 / n; };
    const double xi = outermost(rule.n), eta = outermost(rule.m);
    const auto [c, t1, t2, t3] = BilinearMap(corners);
    const Vec3 along = t1 * xi, across = t2 * eta, twist = t3 * (xi * eta);
    return {c - along - across + twist, c + along - across - twist, c + along + across + twist,
            c - along + across - twist};
}

}  // namespace weavefront::contact
