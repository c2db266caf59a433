#include "weavefront/fabric/cell.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "chosen_fabric.hpp"
#include "commands.hpp"
#include "csv_table.hpp"
#include "deformation_path.hpp"
#include "launcher.hpp"
#include "output_file.hpp"

namespace weavefront::app {
namespace {

constexpr const char* header =
    "time,lambda_fill,lambda_warp,theta,h_fill,strain_fill,strain_warp,stress_fill,stress_warp,contact_"
    "factor,stress_xx,stress_yy,stress_"
    "xy,"
    "broken_fill,broken_warp";

template <fabric::Features F>
std::array<double, 15> row(const fabric::Constants& c, double time, const fabric::State<double>& state,
                           const Kinematics& k, const fabric::Response<double>& response) {
    const fabric::Trellis<double> trellis = fabric::trellis_of(k.cos_2theta);
    const fabric::YarnState<double> yarns = fabric::yarn_state<F>(c, state);
    // Cauchy stress from the Kirchhoff resultant t_e tau
    const double thickness = c.effective_thickness * k.lambda_f * k.lambda_w * trellis.sin_2theta;
    return {time,
            k.lambda_f,
            k.lambda_w,
            std::numbers::pi / 4 + fabric::angle_from_45(trellis),
            state.h_f,
            yarns.eps_f,
            yarns.eps_w,
            yarns.sigma_f,
            yarns.sigma_w,
            state.alpha,
            response.T_xx / thickness,
            response.T_yy / thickness,
            response.T_xy / thickness,
            1 - state.intact_f,
            1 - state.intact_w};
}

/// @param name of the file of the path, for messages
template <fabric::Features F>
CsvTable deform(const fabric::Constants& c, const fabric::Features& features,
                const std::vector<Deformation>& path, const std::string& name) {
    CsvTable table(header);
    fabric::State<double> state = fabric::initial_state<F, double>(c);
    table.add(row<F>(c, path.front().time, state, kinematics(path.front()), {}));
    for (std::size_t i = 1; i < path.size(); ++i) {
        const fabric::Step step = fabric::step_of(c, features, path[i].time - path[i - 1].time);
        const Kinematics k = kinematics(path[i]);
        const fabric::Response<double> response =
            fabric::advance<F>(c, step, state, k.lambda_f, k.lambda_w, k.cos_2theta);
        table.add(row<F>(c, path[i].time, state, k, response), fmt::format("{}:{}:1", name, path[i].line));
    }
    return table;
}

}  // namespace

void cell(const CellOptions& options) {
    if (!is_first_process()) return;
    const scene::Fabric fabric = chosen_fabric(options.scene, options.overrides, options.fabric);
    const std::vector<Deformation> path = read_deformation_path(options.path);
    require_output_file("--out", options.out, {options.scene, options.path});
    const fabric::Constants constants = fabric::constants_of(fabric);
    const fabric::Features features = fabric::features_of(fabric);
    fabric::with_features(features, [&]<fabric::Features F>() {
        return deform<F>(constants, features, path, options.path.string());
    }).write(options.out);
}

}  // namespace weavefront::app
