#pragma once
/// @file
/// What a frame must be before it may be written.

#include <cstddef>
#include <string>

#include "weavefront/io/rows.hpp"

namespace weavefront::io {

/// @throws NotFinite naming the file and the array when a value of the frame is infinite or not a number
void require_finite(const Frame& frame, const std::string& path);

/// @throws std::logic_error when the frame does not hold the arrays of the layout, or not as many values as
/// there are owned items
void require_layout(const Frame& frame, const Frame& layout, std::size_t owned_nodes,
                    std::size_t owned_elements);

}  // namespace weavefront::io
