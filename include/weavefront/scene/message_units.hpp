#pragma once
/// @file
/// The units in which messages on a scene speak.

#include <string>

namespace weavefront::scene {

/// A unit by the name that a scene gives it.
struct MessageUnit {
    std::string name;
    double si = 1;         ///< its value in SI
    bool written = false;  ///< by the scene, not our own choice
};

/// Of each kind of quantity the unit that the scene uses first, or a common one where it uses none.
struct MessageUnits {
    MessageUnit length{"mm", 1e-3}, area{"mm^2", 1e-6}, mass{"g", 1e-3}, time{"us", 1e-6}, rate{"1/s", 1},
        speed{"m/s", 1}, density{"kg/m^3", 1}, areal_density{"g/m^2", 1e-3}, modulus{"GPa", 1e9},
        viscosity{"MPa s", 1e6}, area_stiffness{"N/m^3", 1};
};

/// `0.25 mm`. @param si the value in SI @param digits significant ones
std::string text_of(double si, const MessageUnit& unit, int digits = 4);

/// A bound for a value that a user may write: the last digit is rounded to the side that is allowed.
std::string at_most_text(double si, const MessageUnit& unit);
std::string at_least_text(double si, const MessageUnit& unit);

}  // namespace weavefront::scene
