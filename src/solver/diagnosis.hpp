#pragma once
/// @file
/// Where and why the guard has stopped a run.

#include <cstdint>
#include <string>

#include "weavefront/mesh/panel.hpp"

namespace weavefront::solver {

/// Element, ply and initial place for messages. @param element global id
std::string place_of(const mesh::Panel& panel, std::int64_t element);

}  // namespace weavefront::solver
