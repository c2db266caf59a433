#pragma once
/// @file
/// A material point driven through prescribed stretches and angles.

#include <cmath>

#include "kevlar129.hpp"
#include "weavefront/fabric/cell.hpp"

namespace weavefront::test {

/// Yarn stretches and braid angle.
struct Kinematics {
    double lambda_f = 1, lambda_w = 1;
    double theta = 45 * degree;
};

template <fabric::Features F>
struct MaterialPoint {
    fabric::Constants constants;
    fabric::Step step;
    fabric::State<double> state;

    MaterialPoint(const scene::Fabric& described, double dt)
        : constants(fabric::constants_of(described)),
          step(fabric::step_of(constants, F, dt)),
          state(fabric::initial_state<F, double>(constants)) {}

    fabric::Response<double> advance(const Kinematics& k) {
        const double cos_2theta = -std::sin(2 * (k.theta - 45 * degree));  // exactly zero at 45 deg
        return fabric::advance<F>(constants, step, state, k.lambda_f, k.lambda_w, cos_2theta);
    }
};

inline constexpr auto consistent = scene::Formulation::consistent;
inline constexpr auto paper = scene::Formulation::paper;

}  // namespace weavefront::test
