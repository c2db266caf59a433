#pragma once
/// @file
/// The contact laws of pairs of plies.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "weavefront/contact/penalty.hpp"
#include "weavefront/contact/surface.hpp"
#include "weavefront/scene/scene.hpp"

namespace weavefront::contact {

/// One penalty law for each pair of different areal densities. A law for each pair of plies would take memory
/// with the square of their number.
class PlyPairLaws {
  public:
    PlyPairLaws(const scene::ContactLaw& law, const std::vector<PlyProperties>& plies);

    /// The law between two plies. @param ply, other indices, 0 = struck first
    [[nodiscard]] const PenaltyLaw& between(std::int32_t ply, std::int32_t other) const {
        return laws_[densities_[static_cast<std::size_t>(ply)] * density_count_ +
                     densities_[static_cast<std::size_t>(other)]];
    }

  private:
    std::vector<std::size_t> densities_;  ///< by ply: index among the different areal densities
    std::size_t density_count_;
    std::vector<PenaltyLaw> laws_;  ///< by the densities of the two plies
};

}  // namespace weavefront::contact
