#include "frame_checks.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

namespace {

void require_finite(std::span<const double> values, const std::string& what) {
    const auto bad =
        std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    if (bad != values.end())
        throw NotFinite(what + " would get a value that is " +
                        (std::isnan(*bad) ? "not a number" : "infinite"));
}

bool same_shape(const Array& a, const Array& b) {
    return a.name == b.name && a.components == b.components && a.integer == b.integer;
}

void require_arrays(const std::vector<Array>& arrays, const std::vector<Array>& layout, std::size_t items) {
    if (!std::equal(arrays.begin(), arrays.end(), layout.begin(), layout.end(), same_shape))
        throw std::logic_error("the arrays of a frame are not those of the layout");
    for (const auto& array : arrays)
        if (array.values.size() != items * static_cast<std::size_t>(array.components))
            throw std::logic_error("array " + array.name + " of a frame holds " +
                                   std::to_string(array.values.size()) + " values for " +
                                   std::to_string(items) + " owned items");
}

}  // namespace

void require_finite(const Frame& frame, const std::string& path) {
    require_finite(frame.points, path + ": Points");
    require_finite(frame.projectile, path + ": Points of the projectile");
    require_finite({&frame.time, 1}, path + ": Steps/Values");
    for (const auto* arrays : {&frame.point_data, &frame.cell_data}) {
        for (const auto& array : *arrays) {
            require_finite(array.values, path + ": " + array.name);
            require_finite(array.projectile, path + ": " + array.name + " of the projectile");
        }
    }
}

void require_layout(const Frame& frame, const Frame& layout, std::size_t owned_nodes,
                    std::size_t owned_elements) {
    require_arrays(frame.point_data, layout.point_data, owned_nodes);
    require_arrays(frame.cell_data, layout.cell_data, owned_elements);
    if (frame.points.size() != 3 * owned_nodes)
        throw std::logic_error("a frame does not hold the points of the owned nodes");
    if (frame.eroded.size() != owned_elements)
        throw std::logic_error("a frame does not hold the flags of the owned elements");
}

}  // namespace weavefront::io
