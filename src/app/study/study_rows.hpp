#pragma once
/// @file
/// What a study finds of its variants.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace weavefront::app {

/// Least and largest of some values.
struct ValueRange {
    double least, most;
};

/// The row of one variant.
struct StudyRow {
    std::string outcome;                        ///< finished or stopped
    std::string reason;                         ///< why
    std::vector<std::optional<double>> values;  ///< one a quantity, SI; none for histories and fields
    std::vector<std::optional<double>>
        errors;  ///< one a quantity, relative (absolute where the reference is zero); none without reference
    std::vector<std::optional<ValueRange>>
        history;              ///< one a quantity, of the column that it compares; none for fields
    double wall_seconds = 0;  ///< of the computation, without setting up
    std::int64_t element_steps = 0;
    int ranks = 1;
};

}  // namespace weavefront::app
