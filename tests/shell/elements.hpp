#pragma once
/// @file
/// Distorted quads driven through prescribed positions.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "../fabric/kevlar129.hpp"
#include "weavefront/shell/element_group.hpp"

namespace weavefront::test {

using Positions = std::vector<Eigen::Vector3d>;
using Corners = std::array<Eigen::Vector3d, 4>;

inline constexpr double element_size = 1e-3;  ///< m

/// Elements that share nodes, at rest in the plane z = 0.
struct Mesh {
    Positions X;
    std::vector<std::array<std::int32_t, 4>> elements;
};

[[nodiscard]] inline Eigen::Vector3d random_vector(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> one(-size, size);
    const double x = one(random), y = one(random), z = one(random);
    return {x, y, z};
}

/// n x n elements. @param distortion of the inner nodes over the element size
[[nodiscard]] inline Mesh grid(int n, double distortion, std::mt19937_64& random) {
    Mesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            Eigen::Vector3d x(i * element_size, j * element_size, 0);
            if (i > 0 && j > 0 && i < n && j < n)
                x.head<2>() += random_vector(random, distortion * element_size).head<2>();
            mesh.X.push_back(x);
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int first = j * (n + 1) + i;
            mesh.elements.push_back({first, first + 1, first + n + 2, first + n + 1});
        }
    return mesh;
}

[[nodiscard]] inline Mesh one_element(const Corners& corners) {
    return {{corners.begin(), corners.end()}, {{0, 1, 2, 3}}};
}

/// One quad with all corners moved about at random.
[[nodiscard]] inline Mesh one_element(double distortion, std::mt19937_64& random) {
    const double a = element_size;
    Corners corners{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(a, 0, 0), Eigen::Vector3d(a, a, 0),
                    Eigen::Vector3d(0, a, 0)};
    for (auto& corner : corners) corner.head<2>() += random_vector(random, distortion * a).head<2>();
    return one_element(corners);
}

[[nodiscard]] inline Corners corners_of(const Mesh& mesh, std::size_t e, const Positions& x) {
    Corners corners;
    for (std::size_t a = 0; a < 4; ++a) corners[a] = x[static_cast<std::size_t>(mesh.elements[e][a])];
    return corners;
}

/// The elements of a mesh, of one fabric.
class Elements {
  public:
    /// @param angle of the fill yarns, rad
    Elements(const scene::Fabric& fabric, Mesh mesh, double angle, double dt = 1e-8)
        : mesh_(std::move(mesh)) {
        std::vector<shell::GroupElement> described;
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e)
            described.push_back({static_cast<std::int32_t>(e), mesh_.elements[e],
                                 shell::make_quad(corners_of(mesh_, e, mesh_.X), angle)});
        group = shell::make_element_group(fabric, described);
        group->set_time_step(dt);
    }

    /// Advances to positions x. @return forces on the corners, N, [element][corner]
    std::vector<Corners> corner_forces(const Positions& x) {
        shell::AlignedVector<double> packed(static_cast<std::size_t>(group->packs()) *
                                            shell::forces_per_pack);
        group->advance(0, group->packs(), x, packed, events);
        std::vector<Corners> forces(mesh_.elements.size());
        for (std::size_t e = 0; e < forces.size(); ++e) {
            forces[e][3].setZero();
            for (std::size_t a = 0; a < 3; ++a) {
                for (std::size_t d = 0; d < 3; ++d)
                    forces[e][a][static_cast<Eigen::Index>(d)] =
                        packed[e / shell::pack_width * shell::forces_per_pack +
                               (a * 3 + d) * shell::pack_width + e % shell::pack_width];
                forces[e][3] -= forces[e][a];
            }
        }
        return forces;
    }

    /// Advances to positions x. @return forces on the nodes, N
    Positions nodal_forces(const Positions& x) {
        Positions forces(x.size(), Eigen::Vector3d::Zero());
        const auto of_corners = corner_forces(x);
        for (std::size_t e = 0; e < of_corners.size(); ++e)
            for (std::size_t a = 0; a < 4; ++a)
                forces[static_cast<std::size_t>(mesh_.elements[e][a])] += of_corners[e][a];
        return forces;
    }

    /// Stored and spent, J.
    [[nodiscard]] double energy() const {
        double sum = 0;
        for (std::int32_t e = 0; e < group->size(); ++e)
            sum += group->energy(e).work + group->energy(e).hourglass + group->energy(e).friction;
        return sum;
    }

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }

    std::unique_ptr<shell::ElementGroup> group;
    shell::Events events;

  private:
    Mesh mesh_;
};

[[nodiscard]] inline double largest(const Positions& forces) {
    double size = 0;
    for (const auto& f : forces) size = std::max(size, f.norm());
    return size;
}

/// The open trellis of elastic yarns: everything that it takes it gives back.
[[nodiscard]] inline scene::Fabric open_trellis() {
    scene::Fabric fabric = elastic_kevlar129();
    fabric.lateral.reset();
    fabric.friction = 0;
    return fabric;
}

/// E1 S/s, N/m.
[[nodiscard]] inline double membrane_stiffness(const scene::Fabric& fabric) {
    return fabric.elastic.static_modulus * fabric.yarn.area / fabric.yarn.span;
}

/// A wandering deformation of a mesh from rest: stretch, shear, and every node for itself, out of the plane
/// too.
class Wander {
  public:
    Wander(const Mesh& mesh, std::mt19937_64& random, double stretch, double shear, double apart)
        : X_(mesh.X) {
        std::uniform_real_distribution<double> one(0, 1);
        F_ << stretch * one(random), shear * one(random), 0.1 * shear, stretch * one(random), 0, 0;
        for (std::size_t n = 0; n < X_.size(); ++n) u_.push_back(random_vector(random, apart * element_size));
    }
    /// Positions at `time`, 0 (rest) to 1.
    [[nodiscard]] Positions at(double time) const {
        Positions x = X_;
        for (std::size_t n = 0; n < x.size(); ++n)
            x[n] += std::sin(2 * time) * (F_ * X_[n].head<2>()) + time * time * u_[n] +
                    0.2 * std::sin(9 * time) * u_[u_.size() - 1 - n];
        return x;
    }

  private:
    Positions X_, u_;
    Eigen::Matrix<double, 3, 2> F_;
};

}  // namespace weavefront::test
