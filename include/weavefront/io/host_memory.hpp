#pragma once
/// @file
/// Memory that the machine has to give.

#include <filesystem>

namespace weavefront::io {

/// Bytes that new processes may take: what the kernel has available, and what the limits of the control
/// groups (version 1 and 2) of this process leave, of which memory that only holds files counts as free.
/// @param root  of the file system in which /proc and /sys are looked for
double host_memory(const std::filesystem::path& root = "/");

}  // namespace weavefront::io
