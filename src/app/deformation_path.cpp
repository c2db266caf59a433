#include "deformation_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/read.hpp"

namespace weavefront::app {
namespace {

const std::array<std::string, 5> columns{"time", "F11", "F12", "F21", "F22"};

/// A field of a line and where it begins, counted from 1.
struct Field {
    std::string_view text;
    std::size_t column;
};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? text.substr(0, 0) : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<Field> split(std::string_view line) {
    std::vector<Field> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        const std::string_view whole = line.substr(begin, end - begin), text = trimmed(whole);
        const std::size_t blanks = text.empty() ? 0 : static_cast<std::size_t>(text.data() - whole.data());
        fields.push_back({text, begin + blanks + 1});
        begin = end + 1;
    }
    return fields;
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : name_(path.string()), file_(path) {
        if (!file_) throw std::runtime_error(fmt::format("{}: cannot be read: {}", name_, std::generic_category().message(errno)));
    }

    std::vector<Deformation> read() {
        std::string line;
        if (next(line)) read_header(line);
        if (line_ == 0) report(1, fmt::format("found nothing, allowed the columns {}", fmt::join(columns, ",")));
        while (messages_.empty() || header_is_good_) {
            if (!next(line)) break;
            if (!trimmed(line).empty()) read_row(line);
        }
        if (file_.bad()) throw std::runtime_error(fmt::format("{}: cannot be read: {}", name_, std::generic_category().message(errno)));
        if (path_.empty() && messages_.empty()) report(1, "found no row, allowed one row a step, the first of them the identity");
        if (!messages_.empty()) throw scene::InputError(messages_);
        return path_;
    }

  private:
    bool next(std::string& line) {
        if (!std::getline(file_, line)) return false;
        ++line_;
        return true;
    }

    void report(std::size_t column, const std::string& finding) {
        messages_.push_back(fmt::format("{}:{}:{}: {}", name_, std::max<std::size_t>(line_, 1), column, finding));
    }

    void read_header(const std::string& line) {
        const std::vector<Field> fields = split(line);
        for (std::size_t i = 0; i < std::max(fields.size(), columns.size()); ++i) {
            if (i >= fields.size()) {
                report(line.size() + 1, fmt::format("found no column '{}', allowed the columns {}", columns[i], fmt::join(columns, ",")));
            } else if (i >= columns.size() || fields[i].text != columns[i]) {
                const std::string hint = scene::nearest(fields[i].text, columns);
                const std::string question = hint.empty() || hint == fields[i].text ? "" : fmt::format(", did you mean '{}'?", hint);
                report(fields[i].column, fmt::format("found column '{}', allowed the columns {}, in this order{}", fields[i].text,
                                                     fmt::join(columns, ","), question));
            }
        }
        header_is_good_ = messages_.empty();
    }

    std::optional<double> number(const Field& field, const std::string& column) {
        double value = 0;
        const std::string_view digits = field.text.starts_with('+') ? field.text.substr(1) : field.text;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value)) return value;
        report(field.column, fmt::format("{}: found '{}', allowed a finite number", column, field.text));
        return std::nullopt;
    }

    void read_row(const std::string& line) {
        const std::vector<Field> fields = split(line);
        if (fields.size() != columns.size()) {
            report(1, fmt::format("found {} fields, allowed {}: {}", fields.size(), columns.size(), fmt::join(columns, ",")));
            return;
        }
        std::array<double, 5> values{};
        bool good = true;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::optional<double> value = number(fields[i], columns[i]);
            good = good && value;
            values[i] = value.value_or(0);
        }
        if (good) append({values[0], values[1], values[2], values[3], values[4]}, fields);
    }

    void append(const Deformation& row, const std::vector<Field>& fields) {
        if (path_.empty() && (row.F11 != 1 || row.F12 != 0 || row.F21 != 0 || row.F22 != 1)) {
            report(fields[1].column, "found a deformed first row, allowed the identity 1,0,0,1");
        }
        if (!path_.empty() && !(row.time > path_.back().time)) {
            report(fields[0].column,
                   fmt::format("time: found {}, allowed more than the {} of the row before", row.time, path_.back().time));
        }
        if (!(row.determinant() > 0)) {
            report(fields[1].column, fmt::format("found F with determinant {:.6g}, allowed a positive one", row.determinant()));
        }
        path_.push_back(row);
    }

    std::string name_;
    std::ifstream file_;
    std::size_t line_ = 0;
    bool header_is_good_ = false;
    std::vector<Deformation> path_;
    std::vector<std::string> messages_;
};

}  // namespace

Kinematics kinematics(const Deformation& d) {
    const double lambda_f = std::hypot(d.F11, d.F21), lambda_w = std::hypot(d.F12, d.F22);
    return {lambda_f, lambda_w, d.F11 / lambda_f * (d.F12 / lambda_w) + d.F21 / lambda_f * (d.F22 / lambda_w)};
}

std::vector<Deformation> read_deformation_path(const std::filesystem::path& path) { return Reader(path).read(); }

}  // namespace weavefront::app
