#pragma once
/// @file
/// Speeds of shots at targets with scatter: the sequential design of B. T. Neyer, A D-optimality-based
/// sensitivity test, Technometrics 36 (1994) 61-70.

#include <span>
#include <vector>

#include "weavefront/ballistics/shot.hpp"

namespace weavefront::ballistics {

/// What is known before the first shot.
struct NeyerPlan {
    double from = 0, to = 0;  ///< between which V50 is guessed to lie, m/s
    double sigma = 0;         ///< guessed standard deviation, m/s
};

/// The speeds of the next `count` shots, m/s. Shots of one round know nothing of each other's results. The
/// design first looks for a partial and a complete penetration, then halves the gap between them down to the
/// guessed deviation, which shrinks by a fifth a shot until results are mixed. From then on a shot lies where
/// it adds most to the determinant of the Fisher information at the most likely S-curve.
std::vector<double> next_speeds(const NeyerPlan& plan, std::span<const Shot> shots, int count);

}  // namespace weavefront::ballistics
