#pragma once
/// @file
/// Strength of the yarns as drawn for each of them along its length.

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "weavefront/scene/scene.hpp"

namespace weavefront::shell {

/// Failure strains of an element's yarns over those of the fabric, 1.
struct RelativeStrength {
    double fill = 1, warp = 1;
};

/// Where a link lies: the piece of a yarn between two neighbouring halves of spans, with one crossover in its
/// middle.
struct LinkPlace {
    std::int32_t ply = 0;
    bool warp = false;      ///< a yarn of the warp
    std::int64_t yarn = 0;  ///< from the origin of x and y, across the yarns
    std::int64_t link = 0;  ///< from there, along the yarn
};

/// Exponentially distributed number of mean 1, a function of seed and place alone.
///
/// The bits are those of integer arithmetic and of simd/math.hpp, on every processor and rank.
double exponential_draw(std::int64_t seed, const LinkPlace& place);

/// Relative strength of a link by the weakest-link law: the part exp(-(L/L0) (x G)^m) of the links of length
/// L is stronger than x, with the Weibull modulus m and the gauge length L0. G = Gamma(1 + 1/m) makes 1 the
/// mean at the gauge length.
/// @param length L, m @param draw exponentially distributed; the smallest draw belongs to the weakest link
double relative_strength(const scene::Scatter& scatter, double length, double draw);

/// The strengths of one ply.
///
/// Strength belongs to the weave, not to the mesh. Each link of each yarn has its own strength. An element's
/// part of a yarn is as strong as the weakest link whose middle lies in it, or else as the link at its own
/// middle. The yarns of an element share its strain and break one after the other as it grows; the element
/// breaks all of them at once, at the mean of their strengths. An element without the middle of a yarn has
/// the strength of the yarn that covers its own middle.
class ScatteredStrength {
  public:
    /// @param fabric that breaks, with scatter @param ply index in the target, 0 = struck first
    /// @param angle of the fill yarns to the x axis, rad
    ScatteredStrength(const scene::Fabric& fabric, std::int32_t ply, double angle);

    /// @param corners of a convex element, initial, counter-clockwise about +z, m
    [[nodiscard]] RelativeStrength of(const std::array<Eigen::Vector3d, 4>& corners) const;

  private:
    /// Yarns of one direction.
    struct Yarns {
        bool warp;
        Eigen::Vector2d along, across;
        double spacing, link_length;  ///< m
    };

    [[nodiscard]] double mean_of_yarns(const Yarns& yarns,
                                       const std::array<Eigen::Vector3d, 4>& corners) const;
    /// Smallest draw of a yarn's links between two places along it, m.
    [[nodiscard]] double weakest(const Yarns& yarns, std::int64_t yarn, double begin, double end) const;

    scene::Scatter scatter_;
    std::int32_t ply_;
    std::array<Yarns, 2> yarns_;
};

}  // namespace weavefront::shell
