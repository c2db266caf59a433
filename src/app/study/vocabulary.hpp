#pragma once
/// @file
/// What studies can measure.

#include "weavefront/scene/study.hpp"

namespace weavefront::app {

/// The names of outcomes, columns, fields and closed forms of a computation.
scene::Vocabulary vocabulary(scene::Compute compute);

}  // namespace weavefront::app
