#include "weavefront/study/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::study {
namespace {

/// The columns of a table while its lines are read.
class Table {
  public:
    Table(const std::string& text, std::string name) : lines_(text), name_(std::move(name)) {}

    /// @param may_be_cut the last line, as of a history whose run was killed
    Columns read(bool may_be_cut) {
        std::string line;
        if (!std::getline(lines_, line))
            throw scene::InputError({name_ + ":1:1: found nothing, allowed a header and rows of numbers"});
        read_header(line);
        while (std::getline(lines_, line)) {
            ++line_;
            if (scene::trimmed(line).empty() || line.front() == '#') continue;
            const auto cells = cells_of(line);
            if (may_be_cut && lines_.eof() && cells.size() < names_.size()) break;
            read_row(cells);
        }
        findings_.raise();
        Columns result;
        for (std::size_t i = 0; i < names_.size(); ++i) result[names_[i]] = std::move(columns_[i]);
        return result;
    }

  private:
    void report(std::size_t column, const std::string& what) {
        findings_.add(fmt::format("{}:{}:{}: {}", name_, line_, column, what));
    }

    void read_header(const std::string& line) {
        for (const Cell& cell : cells_of(line)) {
            if (std::ranges::find(names_, cell.text) != names_.end())
                report(cell.column,
                       fmt::format("found the column '{}' again, allowed once", scene::printable(cell.text)));
            names_.push_back(cell.text);
        }
        columns_.resize(names_.size());
    }

    void read_row(const std::vector<Cell>& cells) {
        if (cells.size() != names_.size())
            return report(1, fmt::format("found {} cells, allowed {}, one a column of the header",
                                         cells.size(), names_.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto value = scene::finite_number(cells[i].text);
            if (!value && !cells[i].text.empty())
                report(cells[i].column,
                       fmt::format("{}: found '{}', allowed a finite number or an empty cell",
                                   scene::printable(names_[i]), scene::printable(cells[i].text)));
            columns_[i].push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
        }
    }

    std::istringstream lines_;
    std::string name_;
    std::size_t line_ = 1;
    std::vector<std::string> names_;
    std::vector<std::vector<double>> columns_;
    scene::MessageList findings_;
};

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
    try {
        return Table(scene::read_text(path, scene::most_of_table), path.string()).read(true);
    } catch (const scene::InputError& fault) {
        throw std::runtime_error(fault.what());  // no user has written it
    }
}

Columns parse_columns(const std::string& text, const std::string& name) {
    return Table(text, name).read(false);
}

double distance(const Curve& curve, const Curve& reference, scene::Norm norm) {
    if (curve.time.size() < 2 || reference.time.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const double from = std::max(curve.time.front(), reference.time.front()),
                 to = std::min(curve.time.back(), reference.time.back());
    if (!(to > from)) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> times{from, to};
    for (const auto* all : {&curve.time, &reference.time})
        std::ranges::copy_if(*all, std::back_inserter(times),
                             [&](double time) { return time > from && time < to; });
    std::ranges::sort(times);
    Sum off(norm), whole(norm);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double left = at(reference, times[i - 1]), right = at(reference, times[i]),
                     width = times[i] - times[i - 1];
        whole.add(width, left, right);
        off.add(width, at(curve, times[i - 1]) - left, at(curve, times[i]) - right);
    }
    return whole.value() > 0 ? off.value() / whole.value() : off.value();
}

}  // namespace weavefront::study
