#pragma once
/// @file
/// Plies for contact tests.

#include <functional>
#include <random>
#include <vector>

#include "weavefront/contact/nodal_normals.hpp"
#include "weavefront/contact/surface.hpp"

namespace weavefront::test {

using Positions = std::vector<Vec3>;

/// Where the nodes of a ply are, over [0, 1] x [0, 1].
using Shape = std::function<Vec3(double, double)>;

/// Plies of grids.
struct Plies {
    contact::Surface surface;
    contact::NodalNormals normals;
    Positions x;

    /// Those of the present positions.
    contact::NodalNormals& fresh_normals() {
        normals.rebuild(surface, x.size());
        normals.invalidate();
        return normals;
    }

    /// Takes facets out, which leaves holes with rims.
    template <class Which>
    void erode(Which which) {
        std::vector<bool> lost(x.size(), false);
        for (std::size_t f = 0; f < surface.facets.size(); ++f) {
            if (which(f)) surface.alive[f] = 0;
            if (surface.alive[f]) continue;
            for (const auto node : surface.facets[f].nodes) lost[static_cast<std::size_t>(node)] = true;
        }
        surface.on_free_edge.assign(surface.facets.size(), 0);
        for (std::size_t f = 0; f < surface.facets.size(); ++f)
            for (const auto node : surface.facets[f].nodes)
                if (surface.alive[f] && lost[static_cast<std::size_t>(node)]) surface.on_free_edge[f] = 1;
    }

    /// Appends a ply of n x n facets. Areas are those of the shape.
    void add(int n, const contact::PlyProperties& properties, const Shape& shape) {
        const auto ply = static_cast<std::int32_t>(surface.plies.size());
        const auto base = static_cast<std::int32_t>(x.size());
        surface.plies.push_back(properties);
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                x.push_back(shape(static_cast<double>(i) / n, static_cast<double>(j) / n));
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const std::int32_t first = base + j * (n + 1) + i;
                const contact::Facet facet{static_cast<std::int64_t>(surface.facets.size()),
                                           {first, first + 1, first + n + 2, first + n + 1},
                                           ply};
                const auto corners = contact::corners_of(facet.nodes, x);
                surface.facets.push_back(facet);
                surface.alive.push_back(1);
                surface.areas.one_ply.push_back(
                    (corners[2] - corners[0]).cross(corners[3] - corners[1]).norm() / 2);
            }
        surface.owned = static_cast<std::int32_t>(surface.facets.size());
    }
};

/// A flat square of the given side around the origin at height z.
[[nodiscard]] inline Shape flat(double side, double z) {
    return [=](double u, double v) { return Vec3(side * (u - 0.5), side * (v - 0.5), z); };
}

/// Sums over pairs, and shares out to the nodes.
struct Assembled {
    Positions nodal;
    Vec3 on_slaves{0, 0, 0}, net{0, 0, 0}, moment{0, 0, 0};
    double largest = 0;  ///< nodal force, N
};

[[nodiscard]] inline Assembled assemble(const std::vector<contact::PairForce>& forces, const Positions& x) {
    Assembled sum{Positions(x.size(), Vec3::Zero())};
    for (const auto& pair : forces) {
        sum.on_slaves += pair.total;
        for (std::size_t a = 0; a < 4; ++a) {
            sum.nodal[static_cast<std::size_t>(pair.slave[a])] += pair.on_slave[a];
            if (pair.kind == contact::Master::facet)
                sum.nodal[static_cast<std::size_t>(pair.master[a])] += pair.on_master[a];
        }
    }
    for (std::size_t n = 0; n < x.size(); ++n) {
        sum.net += sum.nodal[n];
        sum.moment += x[n].cross(sum.nodal[n]);
        sum.largest = std::max(sum.largest, sum.nodal[n].norm());
    }
    return sum;
}

[[nodiscard]] inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

}  // namespace weavefront::test
