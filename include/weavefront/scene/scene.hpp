#pragma once
/// @file
/// The scene as plain structs in SI units. Everything here is data: `read_scene` (scene/read.hpp) fills and
/// validates it, the other modules only read it.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "weavefront/scene/message_units.hpp"

namespace weavefront::scene {

/// Which stress and friction the material returns: the work-conjugate one, or sections 1-7 of the paper
/// literally.
enum class Formulation { consistent, paper };

/// When an element is eroded: as soon as any of its yarns is broken, or when both are.
enum class Erode { both_yarns, any_yarn };

/// How an edge of the target is held. `fixed`: no displacement; `sliding`: held in z only; `frame`: rests on
/// the frame; `free`: not held; `clamp`: pressed between jaws, held in z, slips against friction.
enum class Edge { fixed, sliding, frame, free, clamp };

/// Yarn geometry of the plain weave.
struct Yarn {
    double span = 0;   ///< s, distance between crossovers along the yarn, m
    double area = 0;   ///< S, cross-section of a yarn, m2
    double width = 0;  ///< w, m
};

/// Three-element viscoelastic yarn, IT04 (14)-(22).
struct Elastic {
    double static_modulus = 0;  ///< E1, Pa
    double hooke_modulus = 0;   ///< Ka > E1, Pa
    double viscosity = 0;       ///< mu_b, Pa s; 0: sigma = E1 eps
};

/// Weibull scatter of the strength of yarns.
struct Scatter {
    double weibull_modulus = 0;  ///< m, 1
    double gauge_length = 0;     ///< L0, of which the failure strains are the mean, m
    std::int64_t seed = 1;
};

/// Rate-dependent failure, IT04 (19),(20),(22).
struct Failure {
    double static_strain = 0;  ///< eps_max, 1
    double hooke_strain = 0;   ///< eps_a_max, 1
    Erode erode = Erode::both_yarns;
    std::optional<Scatter> scatter = {};  ///< absent: all yarns are equally strong
};

/// Failure strains of a yarn.
struct Strength {
    double static_strain = 0;  ///< eps_max, 1
    double hooke_strain = 0;   ///< eps_a_max, 1
};

/// The yarns of one direction.
struct YarnSystem {
    Yarn yarn;
    double spacing = 0;       ///< of its yarns: the span of the other system, m
    double crimp_height = 0;  ///< of the crossover over the ends of the bars at rest, m
    Elastic elastic;
    std::optional<Strength> strength;  ///< absent: nothing breaks

    /// Length of a yarn over that of the cell, less 1.
    [[nodiscard]] double crimp() const {
        const double slope = 2 * crimp_height / yarn.span;
        return std::sqrt(1 + slope * slope) - 1;
    }
    /// E S over the distance of the yarns, N/m. @param modulus E, Pa
    [[nodiscard]] double membrane_stiffness(double modulus) const { return modulus * yarn.area / spacing; }
};

/// The warp of a fabric whose fill and warp differ.
struct UnequalWarp {
    Yarn yarn;
    Elastic elastic;
    Strength strength;                               ///< read where the fabric breaks
    double crimp_height = 0, fill_crimp_height = 0;  ///< of warp and fill, m
};

/// Packed yarns, IT04 (40),(41) and figure 8.
struct Lateral {
    double modulus = 0;        ///< E2, Pa
    double shear_modulus = 0;  ///< G12, Pa
    double locking_angle = 0;  ///< theta_lock, rad
    double transition = 0;     ///< Dtheta, rad
};

/// Plain weaves take up one to four per cent of yarn by their crimp; more is no geometry of the fabric.
inline constexpr double most_crimp = 0.05;

/// One woven fabric.
struct Fabric {
    std::string name;
    Formulation formulation = Formulation::consistent;
    double areal_density = 0;         ///< kg/m2
    double density = 0;               ///< of the fibre, kg/m3
    Yarn yarn;                        ///< of fill and warp, or of the fill beside `warp`
    double thickness = 0;             ///< t, twice the sum of both crimp heights, m; 0: straight yarns
    Elastic elastic;                  ///< as `yarn`
    std::optional<Failure> failure;   ///< as `yarn`; absent: nothing breaks
    std::optional<UnequalWarp> warp;  ///< absent: as the fill
    std::optional<Lateral> lateral;   ///< absent: an open trellis at every angle
    double friction = 0;              ///< mu, yarn on yarn, 1; 0: none
    double transverse_shear = 0;      ///< G23, Pa; 0: none
    double hourglass = 0.05;          ///< in-plane hourglass stiffness over that of full integration, 1
    double contact_thickness =
        0;  ///< distance at which two such plies touch, m; default: effective thickness
    std::string contact_thickness_source;  ///< where that comes from, in a few words

    /// t_e = areal density / fibre density, m.
    [[nodiscard]] double effective_thickness() const { return areal_density / density; }
    [[nodiscard]] YarnSystem fill_system() const {
        YarnSystem fill{yarn,
                        warp ? warp->yarn.span : yarn.span,
                        warp ? warp->fill_crimp_height : thickness / 4,
                        elastic,
                        {}};
        if (failure) fill.strength = Strength{failure->static_strain, failure->hooke_strain};
        return fill;
    }
    [[nodiscard]] YarnSystem warp_system() const {
        if (!warp) return fill_system();
        YarnSystem system{warp->yarn, yarn.span, warp->crimp_height, warp->elastic, {}};
        if (failure) system.strength = warp->strength;
        return system;
    }
    /// Fill and warp.
    [[nodiscard]] std::array<YarnSystem, 2> systems() const { return {fill_system(), warp_system()}; }
    /// The larger crimp of fill and warp.
    [[nodiscard]] double crimp() const { return std::max(fill_system().crimp(), warp_system().crimp()); }
    /// Mass of straight yarns per area, kg/m2.
    [[nodiscard]] double weight_of_yarns() const {
        double area_per_width = 0;
        for (const auto& system : systems()) area_per_width += system.yarn.area / system.spacing;
        return area_per_width * density;
    }
};

/// One layer of fabric.
struct Ply {
    std::int32_t fabric = 0;  ///< index into Scene::fabrics
    double angle = 0;         ///< of the fill yarns to the x axis, rad
    double spacing = 0;       ///< of its mid-surface from that of the ply before, m; 0 for the first ply
    double z =
        0;  ///< height of the mid-surface, m: the sum of the spacings; the first ply (struck first) is at 0
};

/// Element sizes of the panel: `center` at the impact point, growing outwards by `growth` an element up to
/// `edge`.
struct PanelMesh {
    double center = 0;  ///< m
    double edge = 0;    ///< m
    double growth = 1;  ///< 1
};

/// Coulomb friction of a contact.
struct Friction {
    double static_coefficient = 0, kinetic_coefficient = 0;  ///< kinetic <= static
    double stiffness_ratio = 0.8;  ///< tangential stiffness while sticking over `ContactLaw::stiffness`

    friend bool operator==(const Friction&, const Friction&) = default;
};

/// Jaws that press the fabric beyond the opening of the frame.
struct Clamp {
    double pressure = 0;  ///< Pa
    Friction friction;    ///< of ply on jaw and of ply on ply in the clamp

    friend bool operator==(const Clamp&, const Clamp&) = default;
};

/// Rigid frame behind the last ply, with a rectangular or a round opening. Beyond the opening, the fabric is
/// held as its edges are.
struct Frame {
    /// Half the distance between the bars across x, y, m; absent: no bars there.
    std::array<std::optional<double>, 2> half_opening{};
    std::optional<double> radius = {};  ///< of a round opening, m; there are no straight bars then
    double edge_radius = 0;             ///< where the frame meets the opening, m

    /// Whether a place lies beyond the opening. @param axis 0, 1: across x, y; a round opening has no axes
    [[nodiscard]] bool is_beyond(std::size_t axis, double x, double y) const {
        if (radius) return std::sqrt(x * x + y * y) > *radius;
        const auto& half = half_opening[axis];
        return half && std::abs(axis == 0 ? x : y) > *half;
    }
};

/// Rectangular target of any number of plies, centred on the origin of x and y.
struct Target {
    std::array<double, 2> size{};  ///< of the whole target, m
    std::vector<Ply> plies;        ///< in the order in which they are struck
    PanelMesh mesh;
    std::array<bool, 2> symmetry{};  ///< {x, y}: only the half x >= 0 (y >= 0) is modelled
    std::array<Edge, 2> edges{Edge::fixed, Edge::fixed};  ///< of the edges whose normal is x, y
    std::optional<Frame> frame;                           ///< required by edges that are `frame` or `clamp`
    std::array<std::optional<Clamp>, 2> clamps{};         ///< of the edges that are `clamp`
};

/// Shapes of the projectile. `profile`: any body of revolution; `mesh`: any closed surface of triangles.
enum class Shape {
    sphere,
    cylinder,
    hemisphere,
    cone,
    truncated_cone,
    ogive,
    profile,
    box,
    ring_segment,
    fsp,
    mesh
};

/// The name of a shape in scene files.
std::string_view shape_name(Shape shape);

/// Closed surface of triangles, corners counter-clockwise seen from outside.
struct Triangles {
    std::vector<std::array<double, 3>> points;         ///< m
    std::vector<std::array<std::int32_t, 3>> corners;  ///< indices into `points`
};

/// Rigid projectile. Its axis is z of its own axes, which `attitude` turns to those of space.
struct Projectile {
    Shape shape = Shape::cylinder;
    double diameter = 0;     ///< twice the largest distance of its surface from the axis, m
    double edge_radius = 0;  ///< of the cylinder's rims, m
    double length = 0;       ///< along the axis, m; default: of a steel cylinder (7850 kg/m3) of this mass
    double mass = 0;         ///< kg
    std::array<double, 3>
        position{};  ///< of the foremost point of its nose on the axis, m; default: touching the first ply
    std::array<double, 3> velocity{};  ///< of the centre of mass, m/s
    double delay = 0;  ///< how much later it comes than from `position`: it starts so far behind, s
    std::array<double, 4> attitude{1, 0, 0,
                                   0};         ///< unit quaternion w, x, y, z from its axes to those of space
    std::array<double, 3> angular_velocity{};  ///< in the axes of space, rad/s
    bool turns = false;                        ///< whether moments turn it
    /// About its axes x, y, z through the centre of mass, kg m2; absent: of its shape at uniform density.
    std::optional<std::array<double, 3>> inertia = {};
    double nose_length = 0;          ///< of a cone up to its sharp tip, of a frustum to its face, m
    double tip_radius = 0;           ///< of the sphere that rounds the tip of a cone or an ogive, m
    double tip_diameter = 0;         ///< of the face of a truncated cone, m
    double caliber_radius_head = 0;  ///< of a tangent ogive: radius of its arc over the diameter, 1
    double flat_width = 0;           ///< of the face between the two flats of a chisel nose, m
    double flat_angle = 0;           ///< of these flats to the face, rad
    std::array<double, 3> size{};    ///< of a box along x, y, z, m
    double outer_radius = 0;         ///< of a ring about y, m
    double thickness = 0;            ///< of the ring along its radius, m
    double width = 0;                ///< of the ring along y, m
    double sector = 0;               ///< angle of the part of the ring, rad
    std::vector<std::array<double, 2>> profile{};  ///< (r, z) from the nose to the rear, m
    Triangles triangles{};                         ///< of a mesh

    /// Where it is when the run starts, m.
    [[nodiscard]] std::array<double, 3> start() const {
        auto start = position;
        if (delay > 0)
            for (std::size_t i = 0; i < 3; ++i) start[i] -= delay * velocity[i];
        return start;
    }
    [[nodiscard]] double speed() const { return std::hypot(velocity[0], velocity[1], velocity[2]); }
};

/// Penalty contact with hysteresis; stiffness per area is a property of the fabric.
struct ContactLaw {
    double stiffness = 0;                   ///< pressure per penetration while loading, Pa/m
    double unloading = 10;                  ///< unloading slope over loading slope, >= 1; 1: elastic
    double damping = 0;                     ///< fraction of critical damping
    std::optional<Friction> friction = {};  ///< none: the contact has no friction
};

struct Contact {
    std::optional<double> spacing =
        0.25e-3;  ///< integration points of an element at most this far apart, m; absent: at its nodes
    std::optional<ContactLaw> projectile;
    std::optional<ContactLaw> plies;
    ContactLaw frame{.stiffness = 5.6e12, .unloading = 10, .damping = 0};  ///< used with a frame only
};

/// What the results file holds beside the ply number; all are point or cell arrays of results.vtkhdf.
enum class Field { displacement, velocity, strain, stress, braid_angle, crimp, broken };

struct Output {
    double interval = 0;  ///< between frames of results.vtkhdf, s; 0: first and last only
    double history = 0;   ///< between rows of history.csv, s
    std::vector<Field> fields;
};

/// When a run stops: at `time.end`, or before it, as soon as the outcome can no longer change.
enum class Stop { end, decided };

struct Scene {
    std::string title;
    std::vector<Fabric> fabrics;
    std::optional<Target> target;  ///< absent: only `cell` and `yarn` can use the scene
    std::vector<Projectile> projectiles;
    bool has_projectile_list = false;  ///< whether the file has `projectiles`, not `projectile`
    Contact contact;
    double damping = 0;  ///< mass-proportional, 1/s
    struct Time {
        double end = 0;       ///< s
        double safety = 0.9;  ///< time step over its bound
        Stop stop = Stop::end;
    } time;
    struct Limits {
        double energy_error =
            0.05;  ///< the run stops when the closure error passes this share of the transferred energy
    } limits;
    Output output;
    std::string resolved;  ///< the scene as YAML with every default written out, SI
    std::string hash;      ///< 16 hex digits (FNV-1a 64) of `resolved`
    MessageUnits units;    ///< of messages; no value depends on them

    /// Diameter of the widest projectile, m; 0: there is none.
    [[nodiscard]] double largest_diameter() const {
        double largest = 0;
        for (const auto& projectile : projectiles) largest = std::max(largest, projectile.diameter);
        return largest;
    }
    /// Speed of the slowest projectile, m/s; 0: there is none.
    [[nodiscard]] double least_speed() const {
        double least = largest_speed();
        for (const auto& projectile : projectiles) least = std::min(least, projectile.speed());
        return least;
    }
    /// Longest delay of a projectile, s.
    [[nodiscard]] double largest_delay() const {
        double largest = 0;
        for (const auto& projectile : projectiles) largest = std::max(largest, projectile.delay);
        return largest;
    }
    /// Speed of the fastest projectile, m/s; 0: there is none.
    [[nodiscard]] double largest_speed() const {
        double largest = 0;
        for (const auto& projectile : projectiles) largest = std::max(largest, projectile.speed());
        return largest;
    }
    /// Whether any contact that can occur has friction.
    [[nodiscard]] bool has_contact_friction() const {
        const bool of_projectile = !projectiles.empty() && contact.projectile && contact.projectile->friction,
                   of_plies = target && target->plies.size() > 1 && contact.plies && contact.plies->friction,
                   of_frame = target && target->frame && contact.frame.friction,
                   of_clamp = target && (target->clamps[0] || target->clamps[1]);
        return of_projectile || of_plies || of_frame || of_clamp;
    }
};

}  // namespace weavefront::scene
