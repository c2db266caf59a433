#include "weavefront/scene/quantity.hpp"

#include <fmt/format.h>

#include "units.hpp"

namespace weavefront::scene {

std::variant<double, std::string> duration_of(std::string_view text) {
    const auto found = shared_units().read(text, duration);
    if (found.problem.empty()) return found.value;
    return fmt::format("found {}, allowed a time with its unit", found.problem);
}

std::variant<WrittenSpeed, std::string> speed_of(std::string_view text) {
    const auto found = shared_units().read(text, speed);
    if (found.problem.empty()) return WrittenSpeed{found.value, found.unit};
    return fmt::format("found {}, allowed a velocity with its unit", found.problem);
}

}  // namespace weavefront::scene
