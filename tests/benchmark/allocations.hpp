#pragma once
/// @file
/// Counts what the program takes from the heap.

#include <cstddef>
#include <cstdint>

namespace weavefront::benchmark {

/// Calls of operator new since the program started.
[[nodiscard]] std::int64_t allocations();

/// Bytes that operator new has given out and not got back.
[[nodiscard]] std::size_t bytes_held();

}  // namespace weavefront::benchmark
