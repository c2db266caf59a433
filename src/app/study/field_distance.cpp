#include "field_distance.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "weavefront/io/read_results.hpp"

namespace weavefront::app {

namespace {

/// Displacement along z of the last ply on the grid of its initial x and y.
class DeflectedPly {
  public:
    DeflectedPly(const std::filesystem::path& results, double time) {
        const io::ResultsReader reader(results);
        const auto start = reader.points(0), now = reader.points(nearest(reader.times(), time));
        double height = start.front()[2];
        for (const auto& point : start) height = std::max(height, point[2]);
        for (std::size_t i = 0; i < start.size(); ++i) {
            if (start[i][2] < height - tolerance) continue;
            values_[{place(start[i][1]), place(start[i][0])}] = now[i][2] - start[i][2];
        }
        for (const auto& [at, value] : values_) {
            if (at.first == values_.begin()->first.first)
                x_.push_back(static_cast<double>(at.second) * tolerance);
            if (at.second == values_.begin()->first.second)
                y_.push_back(static_cast<double>(at.first) * tolerance);
        }
    }

    [[nodiscard]] const std::vector<double>& x() const { return x_; }
    [[nodiscard]] const std::vector<double>& y() const { return y_; }

    [[nodiscard]] double operator()(double x, double y) const {
        const auto [i, p] = interval(x_, x);
        const auto [j, q] = interval(y_, y);
        return (1 - q) * ((1 - p) * node(i, j) + p * node(i + 1, j)) +
               q * ((1 - p) * node(i, j + 1) + p * node(i + 1, j + 1));
    }

  private:
    static constexpr double tolerance = 1e-10;  // m; places closer than that are one

    static std::int64_t place(double x) { return std::llround(x / tolerance); }

    static std::size_t nearest(const std::vector<double>& times, double time) {
        const auto closer = [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
        return static_cast<std::size_t>(std::ranges::min_element(times, closer) - times.begin());
    }

    static std::pair<std::size_t, double> interval(const std::vector<double>& grid, double x) {
        const auto after = std::ranges::upper_bound(grid, x) - grid.begin();
        const auto i =
            static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(grid) - 1)) - 1;
        return {i, (x - grid[i]) / (grid[i + 1] - grid[i])};
    }

    [[nodiscard]] double node(std::size_t i, std::size_t j) const {
        return values_.at({place(y_[j]), place(x_[i])});
    }

    std::map<std::pair<std::int64_t, std::int64_t>, double> values_;  // by y, x
    std::vector<double> x_, y_;
};

/// The lines of both grids, and their middles: Simpson's rule is then exact for the square of what is
/// bilinear between them.
std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> both;
    std::ranges::merge(a, b, std::back_inserter(both));
    std::vector<double> lines{both.front()};
    for (const double x : both) {
        if (x - lines.back() < 1e-9) continue;
        lines.push_back((lines.back() + x) / 2);
        lines.push_back(x);
    }
    return lines;
}

/// Weights of Simpson's rule over pairs of intervals.
std::vector<double> weights(const std::vector<double>& lines) {
    std::vector<double> weights(lines.size(), 0.0);
    for (std::size_t i = 0; i + 2 < lines.size(); i += 2) {
        const double sixth = (lines[i + 2] - lines[i]) / 6;
        weights[i] += sixth;
        weights[i + 1] += 4 * sixth;
        weights[i + 2] += sixth;
    }
    return weights;
}

}  // namespace

double field_distance(const std::filesystem::path& results, const std::filesystem::path& reference,
                      double time) {
    const DeflectedPly ply(results, time), exact(reference, time);
    const std::vector<double> x = merged(ply.x(), exact.x()), y = merged(ply.y(), exact.y());
    const std::vector<double> wx = weights(x), wy = weights(y);
    double off = 0, whole = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double value = exact(x[i], y[j]), difference = ply(x[i], y[j]) - value;
            off += wx[i] * wy[j] * difference * difference;
            whole += wx[i] * wy[j] * value * value;
        }
    }
    return whole > 0 ? std::sqrt(off / whole) : std::sqrt(off);
}

}  // namespace weavefront::app
