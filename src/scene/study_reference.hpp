#pragma once
/// @file
/// The variant with which a study compares.

#include <span>

#include "section.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {

/// `reference.variant`: a map of paths and values, and of axes and their labels; or the name of a variant, or
/// a label of one axis.
/// @param study with its axes
void read_reference_variant(const Value& value, const Study& study, Context& context, Reference& reference);

}  // namespace weavefront::scene
