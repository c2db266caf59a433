#include "cases.hpp"

#include <fmt/format.h>

#include "motions.hpp"

namespace weavefront::stability {

namespace {

using Overrides = std::vector<std::string>;

std::string of_fabric(const std::string& rest) { return "fabrics.kevlar129." + rest; }

/// The same impact without failure: the yarns stay tight.
const std::string unbreakable = of_fabric("failure=");

/// A whole single ply without contact, free at its edges: what moves it is its initial velocity.
Overrides free_ply(Overrides more) {
    Overrides all{"projectile=",
                  "contact=",
                  "target.symmetry=[]",
                  "target.size=[16 mm, 16 mm]",
                  "target.plies={count: 1, fabric: kevlar129}",
                  "target.mesh={center: 1 mm}",
                  "target.edges={x: free, y: free}"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::vector<Case> steps() {
    // Straight yarns and elements of 0.5 mm: nothing softens the yarns, and they, not contact, decide on the
    // step.
    const Overrides tight{of_fabric("thickness=0"),
                          unbreakable,
                          "target.plies={count: 1, fabric: kevlar129}",
                          "target.mesh={center: 0.5 mm}",
                          "target.size=[16 mm, 16 mm]",
                          "contact.plies=",
                          "projectile.velocity=[0, 0, 50 m/s]"};
    std::vector<Case> cases;
    for (const std::string safety : {"0.5", "0.9", "1.0", "1.2"}) {
        const bool above = safety == "1.2";
        cases.push_back(
            {.family = "time step",
             .name = "step_" + safety,
             .what = "step " + safety + " of the bound",
             .overrides = {"time.safety=" + safety},
             .expected = above ? Expected::either : Expected::finish,
             .reason = above ? "above the bound, which only contact on both sides of all plies attains" : "",
             .reduced = safety == "1.0"});
        Overrides overrides = tight;
        overrides.push_back("time.safety=" + safety);
        cases.push_back({.family = "time step",
                         .name = "tight_step_" + safety,
                         .what = "step " + safety + " of the bound, straight yarns, fine mesh",
                         .overrides = overrides,
                         .expected = above ? Expected::guard : Expected::finish,
                         .reason = above ? "above the bound, which this mesh attains" : "",
                         .reduced = safety == "1.0" || above});
    }
    return cases;
}

std::vector<Case> yarns() {
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, const std::string& what, const Overrides& overrides,
                         bool reduced = false) {
        cases.push_back(
            {.family = "yarns", .name = name, .what = what, .overrides = overrides, .reduced = reduced});
    };
    add("viscosity_0", "mu_b = 0", {of_fabric("elastic.viscosity=0")}, true);
    // mu_b = tau Ka^2/(Ka - E1)
    for (const int power : {-12, -9, -6, -3, 0})
        add(fmt::format("relaxation_1e{}_s", power), fmt::format("relaxation time 1e{} s", power),
            {of_fabric(fmt::format("elastic.viscosity=384e{} Pa s", 9 + power))}, power == -12 || power == 0);
    for (const std::string ratio : {"1.0001", "1.01", "10", "1000"})
        add("moduli_" + ratio, "Ka/E1 = " + ratio,
            {of_fabric(fmt::format("elastic.hooke_modulus={} GPa", 96 * std::stod(ratio)))},
            ratio == "1.0001");
    add("moduli_1000_soft", "Ka/E1 = 1000 by a soft E1", {of_fabric("elastic.static_modulus=192 MPa")});
    for (const std::string t : {"0", "0.01", "0.1", "0.82", "2"})
        add("thickness_" + t, t == "0" ? "straight yarns, t = 0" : "t = " + t + " mm",
            {of_fabric("thickness=" + t + " mm")}, t == "0" || t == "2");
    for (const std::string mu : {"0", "0.5", "2"})
        add("friction_" + mu, "yarn friction " + mu, {of_fabric("friction=" + mu)}, mu == "2");
    return cases;
}

std::vector<Case> shapes_of_the_cell() {
    std::vector<Case> cases;
    const auto turn = of_fabric("lateral="), angle = std::string("target.plies.angle=45 deg");
    const auto add = [&](const std::string& name, const std::string& what, const Overrides& overrides,
                         Prepare prepare, bool reduced = false) {
        cases.push_back({.family = "cell",
                         .name = name,
                         .what = what,
                         .overrides = free_ply(overrides),
                         .reduced = reduced,
                         .prepare = std::move(prepare)});
    };
    add("lock_wide", "driven to locking, braid angle up, at 160 m/s", {angle, "time.end=100 us"},
        stretching(2e4, -2e4), true);
    add("lock_narrow", "driven to locking, braid angle down, at 160 m/s", {angle, "time.end=100 us"},
        stretching(-2e4, 2e4));
    add("lock_fast", "driven to locking at 400 m/s, step 1.0 of the bound",
        {angle, unbreakable, "time.end=40 us", "time.safety=1"}, stretching(5e4, -5e4));
    // The packing builds up within ten steps of 0.9 of the bound, an error of second order in the step;
    // halved it is resolved.
    add("lock_violent", "driven to locking at 800 m/s, step 0.5 of the bound",
        {angle, unbreakable, "time.end=20 us", "time.safety=0.5"}, stretching(1e5, -1e5));
    add("to_90_deg", "no packing, braid angle driven towards 90 deg", {angle, turn, "time.end=100 us"},
        stretching(2e4, -2e4));
    add("to_0_deg", "no packing, braid angle driven towards 0 deg", {angle, turn, "time.end=100 us"},
        stretching(-2e4, 2e4));
    add("biaxial_compression", "pressed together in both directions, wrinkles", {},
        stretching(-5e3, -5e3, 1e-6), true);
    add("biaxial_crush", "pressed together at 320 m/s", {}, stretching(-4e4, -4e4, 1e-6));
    add("wrinkling", "clamped, the middle driven together", {"target.edges={x: fixed, y: free}"},
        crumpling(50, 16e-3, 1e-6));
    add("broken_yarn_stretch", "one yarn broken over 8 elements, then stretched",
        {"time.end=30 us", of_fabric("thickness=0.1 mm")},
        [pull = stretching(1e3, 1e3), cut = broken_yarn()](solver::Simulation& simulation) {
            cut(simulation);
            pull(simulation);
        });
    cases.push_back({.family = "cell",
                     .name = "broken_yarn_impact",
                     .what = "one yarn broken over 8 elements, then struck",
                     .overrides = {"target.mesh={center: 1 mm}", of_fabric("thickness=0.1 mm")},
                     .prepare = broken_yarn()});
    return cases;
}

std::vector<Case> impacts() {
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, const std::string& what, const Overrides& overrides,
                         bool reduced = false) {
        cases.push_back(
            {.family = "impact", .name = name, .what = what, .overrides = overrides, .reduced = reduced});
    };
    for (const std::string v : {"1", "50", "1000", "3000"})
        add("speed_" + v, v + " m/s",
            {"projectile.velocity.2=" + v + " m/s", v == "1" ? "time.end=200 us" : "time.end=50 us"},
            v == "3000");
    add("light", "projectile 1000 times lighter", {"projectile.mass=2.8 mg"}, true);
    add("heavy", "projectile 1000 times heavier", {"projectile.mass=2.8 kg"});
    add("sharp_edge", "edge radius 0", {"projectile.edge_radius=0", "projectile.velocity.2=400 m/s"}, true);
    add("nodes_only", "contact at the nodes", {"contact.spacing=nodes", "projectile.velocity.2=400 m/s"});
    add("elastic_contact", "contact that returns all",
        {"contact.projectile.unloading=1", "contact.plies.unloading=1", "contact.plies.damping=0"});
    add("initial_contact", "projectile and plies touch from the start",
        {"target.plies={count: 3, fabric: kevlar129, gap: 0}"}, true);
    add("initial_gap", "projectile starts 1 mm away, plies 1 mm apart",
        {"projectile.position=[0, 0, -1.1 mm]", "target.plies.spacing=1 mm"});
    add("one_ply", "1 ply", {"target.plies={count: 1, fabric: kevlar129}"});
    add("sixty_plies", "60 plies",
        {"target.plies.count=60", "target.size=[16 mm, 16 mm]", "target.mesh={center: 2 mm}",
         "time.end=25 us"});
    add("free_target", "free-flying target", {"target.edges={x: free, y: free}", "time.end=100 us"});
    add("any_yarn", "elements go with their first yarn, 400 m/s",
        {of_fabric("failure.erode=any_yarn"), "projectile.velocity.2=400 m/s"});
    add("turned_yarns", "yarns at 30 deg", {"target.plies.angle=30 deg", "target.symmetry=[]"});
    return cases;
}

std::vector<Case> meshes() {
    std::vector<Case> cases;
    cases.push_back(
        {.family = "mesh",
         .name = "size_ratio_100",
         .what = "element sizes from 0.1 to 10 mm",
         .overrides = {"target.size=[80 mm, 80 mm]", "target.mesh={center: 0.1 mm, edge: 10 mm, growth: 1.6}",
                       "time.end=20 us"}});
    // Lines graded in x and y make elements of center x edge on the axes.
    cases.push_back({.family = "mesh",
                     .name = "aspect_ratio_20",
                     .what = "elements of 0.3 x 6 mm on the axes",
                     .overrides = {"target.size=[64 mm, 64 mm]",
                                   "target.mesh={center: 0.3 mm, edge: 6 mm, growth: 3}", "time.end=50 us"},
                     .reduced = true});
    cases.push_back({.family = "mesh",
                     .name = "drift",
                     .what = "200,000 steps after a stopped impact",
                     .overrides = {"target.size=[16 mm, 16 mm]", "target.mesh={center: 2 mm}",
                                   "target.plies={count: 1, fabric: kevlar129}",
                                   "contact.plies=", "projectile.velocity.2=20 m/s", "time.end=1 s"},
                     .steps = 200000});
    return cases;
}

std::vector<Case> units() {
    const Case millimetres{
        .family = "units", .name = "in_mm", .what = "lengths in mm", .overrides = {}, .reduced = true};
    const auto in = [](const std::string& unit, int power) {
        const auto of = [&](const std::string& path, const std::string& digits, int mm) {
            return fmt::format("{}={}e{} {}", path, digits, mm + power, unit);
        };
        const auto two = fmt::format("[32e{} {}, 32e{} {}]", power, unit, power, unit);
        return Overrides{of(of_fabric("yarn.span"), "0.909", 0),
                         fmt::format("{}=6.48e{} {}^2", of_fabric("yarn.area"), -2 + 2 * power, unit),
                         of(of_fabric("yarn.width"), "0.32", 0),
                         of(of_fabric("thickness"), "0.41", 0),
                         of(of_fabric("contact_thickness"), "0.1417", 0),
                         "target.size=" + two,
                         of("target.plies.spacing", "0.25", 0),
                         of("target.mesh.center", "1", 0),
                         of("target.mesh.edge", "2", 0),
                         of("projectile.diameter", "5.38", 0),
                         of("projectile.edge_radius", "0.3", 0),
                         of("projectile.length", "16", 0),
                         fmt::format("projectile.velocity.2=0.2e{} {}/us", power, unit)};
    };
    return {millimetres,
            {.family = "units",
             .name = "in_nm",
             .what = "lengths in nm: the bits of mm",
             .overrides = in("nm", 6),
             .reduced = true,
             .same_as = "in_mm"},
            {.family = "units",
             .name = "in_km",
             .what = "lengths in km: the bits of mm",
             .overrides = in("km", -6),
             .reduced = true,
             .same_as = "in_mm"}};
}

}  // namespace

std::vector<Case> all_cases() {
    std::vector<Case> all;
    for (const auto& family : {steps(), yarns(), shapes_of_the_cell(), impacts(), meshes(), units()})
        all.insert(all.end(), family.begin(), family.end());
    return all;
}

}  // namespace weavefront::stability
