#pragma once
/// @file
/// Histories as columns, and how far two of them are apart.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "weavefront/scene/study.hpp"

namespace weavefront::study {

/// The columns of a CSV file by their names.
using Columns = std::map<std::string, std::vector<double>>;

/// Reads the history of a run: a header, then rows of numbers; empty cells are NaN. A last line cut short, as
/// by a kill, is left out.
/// @throws std::runtime_error naming the file and the place when it cannot be read or holds no such table
Columns read_columns(const std::filesystem::path& path);

/// The same from the text of a table that a user has written, where a line cut short is a fault. Lines that
/// begin with # are left out.
/// @param name of the file, for messages
/// @throws scene::InputError with every finding as `name:line:column: COLUMN: found ..., allowed ...`
Columns parse_columns(const std::string& text, const std::string& name);

/// A value over time, linear between its points.
struct Curve {
    std::vector<double> time;   ///< s, ascending
    std::vector<double> value;  ///< one a time
};

/// Distance of two curves in a norm over the time that both cover, over the norm of `reference` there
/// (absolute where that is zero). Both are linear between their points, and the norm is that of their
/// difference: l1 and max exactly, but for changes of sign inside an interval of l1; l2 exactly.
/// @returns NaN when they share no interval of time
double distance(const Curve& curve, const Curve& reference, scene::Norm norm);

}  // namespace weavefront::study
