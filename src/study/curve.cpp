#include "weavefront/study/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "weavefront/study/text_table.hpp"

namespace weavefront::study {
namespace {

double number(const std::string& cell, const std::string& where) {
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
        throw std::runtime_error(fmt::format("{}: found '{}', allowed a number", where, cell));
    return value;
}

double at(const Curve& curve, double time) {
    const auto after = std::ranges::upper_bound(curve.time, time);
    const auto j = std::clamp<std::ptrdiff_t>(after - curve.time.begin(), 1, std::ssize(curve.time) - 1);
    const auto i = static_cast<std::size_t>(j);
    const double share = (time - curve.time[i - 1]) / (curve.time[i] - curve.time[i - 1]);
    return (1 - share) * curve.value[i - 1] + share * curve.value[i];
}

/// Adds up a piecewise linear function's norm.
class Sum {
  public:
    explicit Sum(scene::Norm norm) : norm_(norm) {}

    void add(double width, double left, double right) {
        if (norm_ == scene::Norm::max) sum_ = std::max({sum_, std::abs(left), std::abs(right)});
        if (norm_ == scene::Norm::l1) sum_ += width * (std::abs(left) + std::abs(right)) / 2;
        if (norm_ == scene::Norm::l2) sum_ += width * (left * left + left * right + right * right) / 3;
    }

    [[nodiscard]] double value() const { return norm_ == scene::Norm::l2 ? std::sqrt(sum_) : sum_; }

  private:
    scene::Norm norm_;
    double sum_ = 0;
};

}  // namespace

Columns read_columns(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) throw std::runtime_error(fmt::format("{}: cannot be read, or is empty", path.string()));
    return parse_columns(text.str(), path.string());
}

Columns parse_columns(const std::string& text, const std::string& name) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    std::istringstream file(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text);
    std::string line;
    if (!std::getline(file, line)) throw std::runtime_error(fmt::format("{}: empty, allowed a header and rows of numbers", name));
    const std::vector<std::string> names = cells_of(line);
    std::vector<std::vector<double>> columns(names.size());
    for (int number_of_line = 2; std::getline(file, line); ++number_of_line) {
        if (line.empty() || line.front() == '#') continue;
        const std::vector<std::string> cells = cells_of(line);
        const std::string where = fmt::format("{}:{}", name, number_of_line);
        if (cells.size() < names.size() && file.eof()) break;
        if (cells.size() != names.size())
            throw std::runtime_error(fmt::format("{}: found {} cells, allowed {}", where, cells.size(), names.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) columns[i].push_back(number(cells[i], where));
    }
    Columns result;
    for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = std::move(columns[i]);
    return result;
}

double distance(const Curve& curve, const Curve& reference, scene::Norm norm) {
    if (curve.time.size() < 2 || reference.time.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const double from = std::max(curve.time.front(), reference.time.front()), to = std::min(curve.time.back(), reference.time.back());
    if (!(to > from)) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> times{from, to};
    for (const auto* all : {&curve.time, &reference.time})
        std::ranges::copy_if(*all, std::back_inserter(times), [&](double time) { return time > from && time < to; });
    std::ranges::sort(times);
    Sum off(norm), whole(norm);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double left = at(reference, times[i - 1]), right = at(reference, times[i]), width = times[i] - times[i - 1];
        whole.add(width, left, right);
        off.add(width, at(curve, times[i - 1]) - left, at(curve, times[i]) - right);
    }
    return whole.value() > 0 ? off.value() / whole.value() : off.value();
}

}  // namespace weavefront::study
