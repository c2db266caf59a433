#include "weavefront/study/strip.hpp"

#include <algorithm>
#include <stdexcept>

namespace weavefront::study {
namespace {

struct Line {
    double slope, height;
};

Line fit(std::span<const double> x, std::span<const double> y) {
    if (x.size() < 2) throw std::runtime_error("the strip shows no wave to measure");
    const auto n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return {xy / xx, mean_y - xy / xx * mean_x};
}

/// Where the straight flank between 20 % and 80 % of the height meets the plane of the strip, m.
double kink(const StripFrame& frame) {
    const double top = std::ranges::max(frame.z);
    std::vector<double> x, z;
    for (std::size_t i = 0; i < frame.x.size(); ++i) {
        if (frame.z[i] <= 0.2 * top || frame.z[i] >= 0.8 * top) continue;
        x.push_back(frame.x[i]);
        z.push_back(frame.z[i]);
    }
    const Line flank = fit(x, z);
    return -flank.height / flank.slope;
}

/// Where the strain falls through half of its plateau, m.
double front(const StripFrame& frame, double plateau) {
    for (std::size_t i = frame.strain.size() - 1; i-- > 0;) {
        if (frame.strain[i] <= plateau / 2) continue;
        const double share = (frame.strain[i] - plateau / 2) / (frame.strain[i] - frame.strain[i + 1]);
        return frame.centre[i] + share * (frame.centre[i + 1] - frame.centre[i]);
    }
    throw std::runtime_error("the strip shows no longitudinal front");
}

}  // namespace

StripWaves measure_strip(std::span<const StripFrame> frames, double expected) {
    std::vector<double> times, kinks, fronts;
    for (const StripFrame& frame : frames) {
        if (frame.time < frames.back().time / 4) continue;
        times.push_back(frame.time);
        kinks.push_back(kink(frame));
        fronts.push_back(front(frame, expected));
    }
    if (times.size() < 2)
        throw std::runtime_error("the strip needs at least two frames in the last three quarters of the run");
    const StripFrame& last = frames.back();
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < last.centre.size(); ++i) {
        if (last.centre[i] <= 1.3 * kinks.back() || last.centre[i] >= 0.9 * fronts.back()) continue;
        sum += last.strain[i];
        ++count;
    }
    if (count == 0)
        throw std::runtime_error("the strip shows no plateau of strain behind its longitudinal front");
    return {sum / count, fit(times, kinks).slope, fit(times, fronts).slope};
}

}  // namespace weavefront::study
