#pragma once
/// @file
/// Energy that sliding moves between points in contact.

namespace weavefront::contact {

/// Energy that sliding moves, per area (J/m2) or of a facet (J). Sliding does no work along the contact
/// force. Energy that it stores in points ahead of a curved side comes from the points behind.
struct SlidingEnergy {
    double released = 0;  ///< by points that sliding opens
    double taken = 0;     ///< by points that sliding closes
    double wanted = 0;    ///< energy that they would have taken with their whole overlap

    void add(const SlidingEnergy& other) {
        released += other.released, taken += other.taken, wanted += other.wanted;
    }

    [[nodiscard]] SlidingEnergy times(double factor) const {
        return {factor * released, factor * taken, factor * wanted};
    }
    [[nodiscard]] bool is_any() const { return released > 0 || wanted > 0; }
};

}  // namespace weavefront::contact
