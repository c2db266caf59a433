#pragma once
/// @file
/// The names that scene files give to the values of enumerations. Of several names for one value the first is
/// written.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::scene {

template <typename Enum, std::size_t N>
using Names = std::array<std::pair<std::string_view, Enum>, N>;

inline constexpr Names<Formulation, 2> formulation_names{
    {{"consistent", Formulation::consistent}, {"paper", Formulation::paper}}};
inline constexpr Names<Erode, 2> erode_names{
    {{"both_yarns", Erode::both_yarns}, {"any_yarn", Erode::any_yarn}}};
// Without rotations at the nodes a clamp and a pin are the same.
inline constexpr Names<Edge, 6> edge_names{{{"fixed", Edge::fixed},
                                            {"sliding", Edge::sliding},
                                            {"frame", Edge::frame},
                                            {"free", Edge::free},
                                            {"clamped", Edge::fixed},
                                            {"pinned", Edge::fixed}}};
inline constexpr Names<Shape, 11> shape_names{{{"cylinder", Shape::cylinder},
                                               {"sphere", Shape::sphere},
                                               {"hemisphere", Shape::hemisphere},
                                               {"cone", Shape::cone},
                                               {"truncated_cone", Shape::truncated_cone},
                                               {"ogive", Shape::ogive},
                                               {"profile", Shape::profile},
                                               {"fsp", Shape::fsp},
                                               {"box", Shape::box},
                                               {"ring_segment", Shape::ring_segment},
                                               {"mesh", Shape::mesh}}};
/// What of the projectile's motion is held.
enum class Fixed { nothing, rotation };
inline constexpr Names<Fixed, 1> fixed_names{{{"rotation", Fixed::rotation}}};
inline constexpr Names<Stop, 2> stop_names{{{"end", Stop::end}, {"decided", Stop::decided}}};
inline constexpr Names<std::size_t, 2> axis_names{{{"x", 0}, {"y", 1}}};
inline constexpr Names<Field, 7> field_names{{{"displacement", Field::displacement},
                                              {"velocity", Field::velocity},
                                              {"strain", Field::strain},
                                              {"stress", Field::stress},
                                              {"braid_angle", Field::braid_angle},
                                              {"crimp", Field::crimp},
                                              {"broken", Field::broken}}};

/// The names of a table.
template <typename Table>
std::vector<std::string> names_in(const Table& table) {
    std::vector<std::string> names;
    for (const auto& entry : table) names.emplace_back(entry.first);
    return names;
}

/// The name of a value.
template <typename Table>
std::string_view name_of(typename Table::value_type::second_type value, const Table& table) {
    return std::ranges::find(table, value, &Table::value_type::second)->first;
}

}  // namespace weavefront::scene
