#include "speed_unit.hpp"

#include <fmt/format.h>

namespace weavefront::app {

std::string SpeedUnit::text(double speed) const {
    if (si == 1) return fmt::format("{:.2f} m/s", speed);
    return fmt::format("{:.2f} {} ({:.2f} m/s)", speed / si, name, speed);
}

std::string SpeedUnit::text(double low, double high) const {
    if (si == 1) return fmt::format("{:.2f} to {:.2f} m/s", low, high);
    return fmt::format("{:.2f} to {:.2f} {} ({:.2f} to {:.2f} m/s)", low / si, high / si, name, low, high);
}

}  // namespace weavefront::app
