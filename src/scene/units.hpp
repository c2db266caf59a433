#pragma once
/// @file
/// Quantities as text, `0.909 mm`, and their values in SI.

#include <udunits2.h>

#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "weavefront/scene/message_units.hpp"

namespace weavefront::scene {

/// A kind of physical quantity.
struct Dimension {
    std::string_view name;     ///< with its article, as messages say it
    std::string_view si;       ///< the unit values are kept in; empty: none
    std::string_view example;  ///< how a user might write one, in quotes
    MessageUnit MessageUnits::*unit = nullptr;
};

inline constexpr Dimension ratio{"a number", "", "'0.5' or '50 %'"};
inline constexpr Dimension angle{"an angle", "rad", "'35 deg'"};
inline constexpr Dimension length{"a length", "m", "'0.9 mm'", &MessageUnits::length};
inline constexpr Dimension per_length{"a number per length", "1/m", "'34 1/in'"};
inline constexpr Dimension area{"an area", "m^2", "'0.06 mm^2'", &MessageUnits::area};
inline constexpr Dimension mass{"a mass", "kg", "'2.8 g'", &MessageUnits::mass};
inline constexpr Dimension duration{"a time", "s", "'200 us'", &MessageUnits::time};
inline constexpr Dimension rate{"a rate", "1/s", "'100 1/s'", &MessageUnits::rate};
inline constexpr Dimension angular_rate{"an angular velocity", "rad/s", "'2000 rad/s' or '30000 rpm'"};
inline constexpr Dimension moment_of_inertia{"a moment of inertia", "kg m^2", "'20 g mm^2'"};
inline constexpr Dimension speed{"a velocity", "m/s", "'428 m/s'", &MessageUnits::speed};
inline constexpr Dimension density{"a density", "kg/m^3", "'1440 kg/m^3'", &MessageUnits::density};
inline constexpr Dimension areal_density{"an areal density", "kg/m^2", "'204 g/m^2'",
                                         &MessageUnits::areal_density};
inline constexpr Dimension modulus{"a modulus", "Pa", "'96 GPa'", &MessageUnits::modulus};
inline constexpr Dimension pressure{"a pressure", "Pa", "'2 MPa'"};
inline constexpr Dimension viscosity{"a viscosity", "Pa s", "'35 MPa s'", &MessageUnits::viscosity};
inline constexpr Dimension area_stiffness{"a stiffness per area", "N/m^3", "'5.6e12 N/m^3'",
                                          &MessageUnits::area_stiffness};

/// What a text says as a quantity.
struct Quantity {
    double value = std::numeric_limits<double>::quiet_NaN();  ///< SI; NaN when there is a problem
    std::string problem = {};  ///< what it is instead of what was wanted; empty: nothing
    std::string nearest = {};  ///< how to write what was probably meant; empty: unknown
    std::string unit = {};     ///< as written; empty: none
};

/// The database of units. udunits2 is not thread-safe: one object, one thread.
class Units {
  public:
    /// @throws std::runtime_error when the database of udunits2 cannot be read
    Units();

    /// Reads a number with its unit. Units that differ by a power of ten (nm, mm, km) give the same double
    /// for the same quantity: the decimal exponent is shifted before the text becomes binary.
    /// @param text   such as `0.909 mm`; a bare 0 needs no unit
    /// @param wanted dimension that the unit must have
    [[nodiscard]] Quantity read(std::string_view text, const Dimension& wanted) const;

  private:
    using System = std::unique_ptr<ut_system, decltype(&ut_free_system)>;
    System system_;

    [[nodiscard]] Quantity convert(std::string_view number, std::string_view unit,
                                   const Dimension& wanted) const;
};

/// The database, read once for each thread: a study parses its scene thousands of times.
/// @throws std::runtime_error when it cannot be read
const Units& shared_units();

}  // namespace weavefront::scene
