#pragma once
/// @file
/// Events and extremes that a run counts.

#include <cstdint>
#include <span>
#include <vector>

#include "weavefront/contact/deepest.hpp"

namespace weavefront::solver {

/// Events are those of this rank's elements, step by step, not multiplied by symmetry. Extremes are those of
/// the recorded balances, of the whole target.
struct Counts {
    std::int64_t broken_yarns = 0, eroded_elements = 0;
    std::vector<double> first_break;  ///< by ply, s; largest double: none
    std::int64_t searches = 0;        ///< searches for contact candidates, the first one included
    std::int64_t inverted = 0;        ///< most elements folded over themselves
    double max_displacement = 0, back_face_deflection = 0;  ///< largest, m
    double lowest_contact_energy = 0;                       ///< J; below zero contact gave energy
    double largest_hourglass = 0, largest_internal = 0;     ///< J
    double largest_closure_error = 0;                       ///< see Balance
    contact::Deepest deepest;                               ///< over the steps

    /// @pre on writing, `deepest` is that of all ranks
    template <class Archive>
    void state(Archive& archive) {
        archive.sum("counts.broken_yarns", broken_yarns);
        archive.sum("counts.eroded_elements", eroded_elements);
        archive.least("counts.first_break", std::span(first_break));
        archive("counts.searches", searches);
        archive("counts.inverted", inverted);
        archive("counts.max_displacement", max_displacement);
        archive("counts.back_face_deflection", back_face_deflection);
        archive("counts.lowest_contact_energy", lowest_contact_energy);
        archive("counts.largest_hourglass", largest_hourglass);
        archive("counts.largest_internal", largest_internal);
        archive("counts.largest_closure_error", largest_closure_error);
        archive("counts.deepest.overlap", deepest.overlap);
        archive("counts.deepest.in_thicknesses", deepest.in_thicknesses);
        archive("counts.deepest.x", deepest.place[0]);
        archive("counts.deepest.y", deepest.place[1]);
        archive("counts.deepest.z", deepest.place[2]);
        archive("counts.deepest.element", deepest.element);
        archive("counts.deepest.time", deepest.time);
    }
};

}  // namespace weavefront::solver
