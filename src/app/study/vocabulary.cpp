#include "vocabulary.hpp"

#include <sstream>

#include "test_curves.hpp"
#include "weavefront/io/history.hpp"

namespace weavefront::app {

namespace {

std::vector<std::string> columns_of(const std::string& header) {
    std::vector<std::string> names;
    std::istringstream stream(header);
    for (std::string name; std::getline(stream, name, ',');)
        if (name != "time") names.push_back(name);
    return names;
}

}  // namespace

scene::Vocabulary vocabulary(scene::Compute compute) {
    switch (compute) {
        case scene::Compute::yarn:
            return {{}, columns_of(yarn_header), {}, {"constant_rate"}};
        case scene::Compute::cell:
            return {{"evaluations"}, columns_of(cell_header), {}, {}};
        case scene::Compute::impact:
            break;
    }
    return {{"residual_velocity", "peak_displacement", "absorbed_energy", "broken_yarns", "eroded_elements",
             "energy_error", "strip_strain", "strip_transverse_speed", "strip_longitudinal_speed"},
            columns_of(io::history_header()),
            {"displacement"},
            {"smith"}};
}

}  // namespace weavefront::app
