#pragma once
/// @file
/// What a table of errors and costs says.

#include <optional>
#include <span>
#include <vector>

namespace weavefront::study {

/// One refinement of a series.
struct Point {
    double size;   ///< of the axis along which the order is observed, positive
    double cost;   ///< tells which way is finer
    double error;  ///< at least 0
};

/// Errors below this are rounding: they say nothing of an order.
inline constexpr double rounding = 1e-12;

/// What falls more slowly does not converge.
inline constexpr double least_order = 0.5;

/// Orders between neighbours along the axis, d ln(error) / d ln(size), taken positive where the error falls
/// with growing cost; none where one of the two errors is rounding.
/// @param series in the order of the axis
std::vector<std::optional<double>> local_orders(std::span<const Point> series);

/// The order of convergence that a series shows: the least-squares slope over its longest run of neighbours
/// with local orders of at least half the largest one. A series that has not begun to converge at its coarse
/// end, or has reached rounding at its fine end, is judged by what lies between. None where no local order
/// exceeds `least_order`, or, of three points and more, no two of them in a row do.
std::optional<double> observed_order(std::span<const Point> series);

/// Whether each pair is on the Pareto front: nothing else costs no more and errs no more, one of the two
/// less. Pairs that are not finite are not.
/// @param costs, errors one each a variant
std::vector<bool> pareto_front(std::span<const double> costs, std::span<const double> errors);

}  // namespace weavefront::study
