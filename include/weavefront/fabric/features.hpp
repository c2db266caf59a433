#pragma once
/// @file
/// What a fabric asks for, as a template argument: the rest is neither computed nor stored.

#include <stdexcept>

#include "weavefront/scene/scene.hpp"

namespace weavefront::fabric {

/// Parts of the model that a fabric uses.
struct Features {
    scene::Formulation formulation = scene::Formulation::consistent;
    bool crimp = false;     ///< t > 0; otherwise the yarns are straight
    bool viscous = false;   ///< mu_b > 0; otherwise sigma = E1 eps
    bool lateral = false;   ///< the yarns pack
    bool friction = false;  ///< mu > 0 (and t > 0: straight yarns do not press on each other)
    bool failure = false;   ///< yarns break
    bool unequal = false;   ///< fill and warp differ
    bool scatter = false;   ///< each point has its own strength

    [[nodiscard]] constexpr bool paper() const { return formulation == scene::Formulation::paper; }
    /// Whether a turn of the trellis meets resistance, so that the braid angle is followed.
    [[nodiscard]] constexpr bool follows_angle() const { return paper() || lateral || friction; }

    friend constexpr bool operator==(const Features&, const Features&) = default;
};

/// One set serves all fabrics whose fill and warp differ: what such a fabric does not ask for is zero there.
/// The paper's cell has equal yarns.
inline constexpr Features any_unequal_fabric{.formulation = scene::Formulation::consistent,
                                             .crimp = true,
                                             .viscous = true,
                                             .lateral = true,
                                             .friction = true,
                                             .failure = true,
                                             .unequal = true};

/// The same with scattered strength, of fabrics whose fill and warp are equal, too.
inline constexpr Features any_scattered_fabric = [] {
    auto features = any_unequal_fabric;
    features.scatter = true;
    return features;
}();

/// What `fabric` asks for.
[[nodiscard]] inline Features features_of(const scene::Fabric& fabric) {
    if (fabric.failure && fabric.failure->scatter) return any_scattered_fabric;
    if (fabric.warp) return any_unequal_fabric;
    const bool crimp = fabric.thickness > 0;
    return {.formulation = fabric.formulation,
            .crimp = crimp,
            .viscous = fabric.elastic.viscosity > 0,
            .lateral = fabric.lateral.has_value(),
            .friction = crimp && fabric.friction > 0,
            .failure = fabric.failure.has_value()};
}

/// Number of feature sets of fabrics whose fill and warp are equal.
inline constexpr int equal_feature_sets = 48;
/// Number of feature sets that `features_of` can return.
inline constexpr int feature_sets = equal_feature_sets + 2;

/// One of the feature sets. @param index 0..feature_sets-1
[[nodiscard]] constexpr Features feature_set(int index) {
    if (index == equal_feature_sets) return any_unequal_fabric;
    if (index > equal_feature_sets) return any_scattered_fabric;
    const int yarns = index / 16;  // straight, crimped, crimped with friction
    return {.formulation = index % 2 == 0 ? scene::Formulation::consistent : scene::Formulation::paper,
            .crimp = yarns > 0,
            .viscous = index / 2 % 2 == 1,
            .lateral = index / 4 % 2 == 1,
            .friction = yarns > 1,
            .failure = index / 8 % 2 == 1};
}

/// Calls `call.template operator()<F>()` with the feature set that equals `features`: the step from scene to
/// compiled kernel.
/// @throws std::logic_error when no set equals it
template <int index = 0, class Call>
decltype(auto) with_features(const Features& features, Call&& call) {
    if (features == feature_set(index)) return call.template operator()<feature_set(index)>();
    if constexpr (index + 1 < feature_sets) return with_features<index + 1>(features, call);
    throw std::logic_error("no kernel for this set of features");
}

}  // namespace weavefront::fabric
