#include "deformation_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"
#include "weavefront/scene/text.hpp"
#include "weavefront/study/text_table.hpp"

namespace weavefront::app {
namespace {

const std::array<std::string, 5> columns{"time", "F11", "F12", "F21", "F22"};

// Yarns break at some per cent and their crimp adds some ten: beyond, a number or its unit is wrong, and
// powers of it overflow.
constexpr double most_stretch = 100, least_stretch = 0.01;

class Reader {
  public:
    Reader(const std::string& text, std::string name) : lines_(text), name_(std::move(name)) {}

    std::vector<Deformation> read() {
        std::string line;
        if (!next(line))
            report(1, fmt::format("found nothing, allowed the columns {}", fmt::join(columns, ",")));
        else
            read_header(study::cells_of(line));
        messages_.raise();
        while (next(line))
            if (!scene::trimmed(line).empty()) read_row(study::cells_of(line));
        if (path_.empty() && messages_.empty())
            report(1, "found no row, allowed one row a step, the first of them the identity");
        messages_.raise();
        return path_;
    }

  private:
    using Cells = std::vector<study::Cell>;

    bool next(std::string& line) {
        if (!std::getline(lines_, line)) return false;
        ++line_;
        return true;
    }

    void report(std::size_t column, const std::string& finding) {
        messages_.add(fmt::format("{}:{}:{}: {}", name_, std::max<std::size_t>(line_, 1), column, finding));
    }

    void read_header(const Cells& cells) {
        for (std::size_t i = 0; i < std::max(cells.size(), columns.size()); ++i) {
            if (i >= cells.size()) {
                report(cells.back().column + cells.back().text.size(),
                       fmt::format("found no column '{}', allowed the columns {}", columns[i],
                                   fmt::join(columns, ",")));
            } else if (i >= columns.size() || cells[i].text != columns[i]) {
                const std::string hint = scene::nearest(cells[i].text, columns);
                const std::string question =
                    hint.empty() || hint == cells[i].text ? "" : fmt::format(", did you mean '{}'?", hint);
                report(cells[i].column,
                       fmt::format("found column '{}', allowed the columns {}, in this order{}",
                                   scene::printable(cells[i].text), fmt::join(columns, ","), question));
            }
        }
    }

    void read_row(const Cells& cells) {
        if (cells.size() != columns.size())
            return report(1, fmt::format("found {} fields, allowed {}: {}", cells.size(), columns.size(),
                                         fmt::join(columns, ",")));
        std::array<double, 5> values{};
        bool good = true;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto value = scene::finite_number(cells[i].text);
            if (!value)
                report(cells[i].column, fmt::format("{}: found '{}', allowed a finite number", columns[i],
                                                    scene::printable(cells[i].text)));
            good = good && value;
            values[i] = value.value_or(0);
        }
        if (good) append({values[0], values[1], values[2], values[3], values[4], line_}, cells);
    }

    /// @param yarn whose vector in the plane has these components
    void check_stretch(const char* yarn, double x, double y, const study::Cell& first) {
        const double stretch = std::hypot(x, y);
        if (!(stretch >= least_stretch && stretch <= most_stretch))
            report(first.column,
                   fmt::format("found a stretch of {:.6g} of the {} yarns, allowed one from {} to {}",
                               stretch, yarn, least_stretch, most_stretch));
    }

    void append(const Deformation& row, const Cells& cells) {
        if (path_.empty() && (row.F11 != 1 || row.F12 != 0 || row.F21 != 0 || row.F22 != 1))
            report(cells[1].column, "found a deformed first row, allowed the identity 1,0,0,1");
        if (!path_.empty() && !(row.time > path_.back().time))
            report(cells[0].column, fmt::format("time: found {}, allowed more than the {} of the row before",
                                                row.time, path_.back().time));
        check_stretch("fill", row.F11, row.F21, cells[1]);
        check_stretch("warp", row.F12, row.F22, cells[2]);
        if (!(row.determinant() > 0))
            report(cells[1].column,
                   fmt::format("found F with determinant {:.6g}, allowed a positive one", row.determinant()));
        path_.push_back(row);
    }

    std::istringstream lines_;
    std::string name_;
    std::size_t line_ = 0;
    std::vector<Deformation> path_;
    scene::MessageList messages_;
};

}  // namespace

Kinematics kinematics(const Deformation& d) {
    const double lambda_f = std::hypot(d.F11, d.F21), lambda_w = std::hypot(d.F12, d.F22);
    return {lambda_f, lambda_w,
            d.F11 / lambda_f * (d.F12 / lambda_w) + d.F21 / lambda_f * (d.F22 / lambda_w)};
}

std::vector<Deformation> read_deformation_path(const std::filesystem::path& path) {
    return Reader(scene::read_text(path, scene::most_of_table), path.string()).read();
}

}  // namespace weavefront::app
