#include "diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "weavefront/solver/simulation.hpp"

namespace weavefront::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto no_element = std::numeric_limits<std::int64_t>::max();

// The bound is not tightened in each of its calls, but in one of so many.
constexpr int calls_to_tighten = 65;
// A step that is above its bound by no more than this is not worth a word.
constexpr double worth_a_word = 1.005;

/// State of the worst element, as doubles for one maximum over the ranks.
struct Evidence {
    double folded = 0, contact_factor = 0, braid_angle = 0;
    double between_plies = 0, in_projectile = 0, in_frame = 0;  ///< penetrations, in contact distances
    double not_finite = 0;

    [[nodiscard]] std::span<double> values() { return {&folded, 7}; }
};
static_assert(sizeof(Evidence) == 7 * sizeof(double));

/// A cause with what to try against it.
struct Cause {
    std::string text, remedy;
};

/// @param bound of the time step, s; 0: unknown, where the stiffness is not finite
std::optional<Cause> of_time_step(double dt, double bound, double safety) {
    const bool is_above = bound > 0 && dt > worth_a_word * bound;
    if (!is_above && safety <= 1) return {};
    return Cause{
        is_above ? fmt::format("the time step of {:.4g} ns is {:.3g} times its bound", dt * 1e9, dt / bound)
                 : fmt::format("time.safety is {:.3g}, above 1", safety),
        safety > 1 ? "time.safety of at most 1" : "a smaller time.safety"};
}

std::optional<Cause> of_locking(const Evidence& found, scene::Formulation formulation) {
    if (!(found.contact_factor > 0)) return {};
    return Cause{fmt::format("its yarns are locked (lateral contact factor {:.3g}, braid angle {:.3g} deg)",
                             found.contact_factor, found.braid_angle * 180 / std::numbers::pi),
                 formulation == scene::Formulation::paper
                     ? "the formulation 'consistent', whose locking gives no energy"
                     : "a smaller time.safety or a wider transition of lateral"};
}

std::optional<Cause> of_contact(const Evidence& found, bool is_given_by_contact) {
    const double deepest = std::max({found.between_plies, found.in_projectile, found.in_frame});
    if (!(deepest > 1) && !is_given_by_contact) return {};
    const char* side = found.between_plies == deepest ? "plies" : "projectile";
    return Cause{fmt::format("contact presses its points to a penetration of {:.3g} contact distances ({})",
                             deepest, found.in_frame == deepest && deepest > 0 ? "frame" : side),
                 fmt::format("a larger contact.{}.stiffness or a smaller contact.spacing", side)};
}

/// The first one is what to try something against. A step that was chosen below its bound comes last: what is
/// before it has lowered the bound.
std::vector<Cause> causes_of(const Evidence& found, const std::optional<Cause>& time_step, double safety,
                             Fault fault, scene::Formulation formulation) {
    std::vector<Cause> causes;
    const auto add = [&](const std::optional<Cause>& cause) {
        if (cause) causes.push_back(*cause);
    };
    if (found.not_finite > 0)
        causes.push_back({"its state or that of its nodes is not finite", "a smaller time.safety"});
    if (safety > 1) add(time_step);
    if (found.folded > 0)
        causes.push_back({"it is folded over itself", "a finer target.mesh or a smaller time.safety"});
    add(of_locking(found, formulation));
    add(of_contact(found, fault == Fault::contact));
    if (safety <= 1) add(time_step);
    if (causes.empty())
        causes.push_back({"neither time step, folding, locking nor contact stands out there",
                          "a smaller time.safety, or a larger limits.energy_error"});
    return causes;
}

bool is_finite(const Vec3& vector) {
    return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

/// Whether positions, velocities and energies of an element are finite.
bool is_finite(const Model& model, std::size_t element) {
    const auto slot = model.slots[element];
    const auto energy = model.groups[static_cast<std::size_t>(slot.group)]->energy(slot.index);
    return std::isfinite(energy.work + energy.hourglass + energy.friction) &&
           std::ranges::all_of(model.surface.facets[element].nodes, [&](std::int32_t node) {
               const auto n = static_cast<std::size_t>(node);
               return is_finite(model.nodes.x[n]) && is_finite(model.nodes.v[n]);
           });
}

/// Kinetic energy of an element over its area, J/m2.
double kinetic_of(const Model& model, std::size_t element) {
    const auto& facet = model.surface.facets[element];
    double sum = 0;
    for (const auto node : facet.nodes) sum += model.nodes.v[static_cast<std::size_t>(node)].squaredNorm();
    return model.surface.plies[static_cast<std::size_t>(facet.ply)].areal_density * sum / 8;
}

double rigid_penetration(const Model& model, double penetration, std::size_t element) {
    const auto ply = static_cast<std::size_t>(model.surface.facets[element].ply);
    return penetration > 0 ? penetration / model.surface.plies[ply].thickness : 0;
}

/// Local index of an owned element; -1: another rank has it, or none.
std::int32_t local_index(const Model& model, std::int64_t element) {
    const auto& ids = model.global.element_ids;
    const auto at = std::ranges::lower_bound(ids, element);
    return at == ids.end() || *at != element ? -1 : static_cast<std::int32_t>(at - ids.begin());
}

/// Penetrations of an owned element. As the element behind, it is known by the one in front of it, which
/// stands on the same rank.
void add_penetrations(const Model& model, std::int32_t element, std::int64_t columns, Evidence& found) {
    const auto e = static_cast<std::size_t>(element);
    if (model.ply_contact) {
        found.between_plies = model.ply_contact->penetration(model.surface, element);
        const auto before = local_index(model, model.global.element_ids[e] - columns);
        if (before >= 0)
            found.between_plies =
                std::max(found.between_plies, model.ply_contact->penetration(model.surface, before));
    }
    for (const auto& projectile : model.projectiles)
        if (projectile.contact)
            found.in_projectile = std::max(
                found.in_projectile, rigid_penetration(model, projectile.contact->penetration(element), e));
    if (model.frame_contact)
        found.in_frame = rigid_penetration(model, model.frame_contact->penetration(element), e);
}

Evidence evidence_of(const Model& model, std::int32_t element, std::int64_t columns) {
    Evidence found;
    if (element < 0) return found;
    const auto e = static_cast<std::size_t>(element);
    if (!is_finite(model, e)) {
        found.not_finite = 1;
        return found;
    }
    const auto slot = model.slots[e];
    const auto condition =
        model.groups[static_cast<std::size_t>(slot.group)]->condition(slot.index, model.nodes.x);
    found.folded = condition.folded ? 1 : 0;
    found.contact_factor = condition.contact_factor;
    found.braid_angle = condition.braid_angle;
    add_penetrations(model, element, columns, found);
    return found;
}

}  // namespace

std::string place_of(const mesh::Panel& panel, std::int64_t element) {
    const auto corners = panel.footprint(element % panel.columns());
    const Vec3 centre = (panel.position(0, corners[0]) + panel.position(0, corners[2])) / 2;
    return fmt::format("element {} (ply {}, at x = {:.4g} mm, y = {:.4g} mm)", element,
                       element / panel.columns() + 1, centre.x() * 1e3, centre.y() * 1e3);
}

std::int64_t Simulation::faulty_element() const {
    const auto local = model_.assembly.faulty_element();
    std::int64_t element =
        local < 0 ? no_element : model_.global.element_ids[static_cast<std::size_t>(local)];
    for (const auto& nodes : model_.assembly.faulty_contacts())
        for (std::size_t f = 0; f < model_.global.element_ids.size(); ++f)
            if (model_.surface.facets[f].nodes == nodes)
                element = std::min(element, model_.global.element_ids[f]);
    comm_.min({&element, 1});
    return element == no_element ? -1 : element;
}

/// How much an owned element stands out; not below 0.
double Simulation::severity(Fault fault, std::size_t element) const {
    if (!is_finite(model_, element)) return infinity;
    const auto slot = model_.slots[element];
    const auto& group = *model_.groups[static_cast<std::size_t>(slot.group)];
    if (!group.alive(slot.index)) return 0;
    const auto energy = group.energy(slot.index);
    const double area = model_.surface.areas[element];
    switch (fault) {
        case Fault::internal:
            return std::max(-energy.work / area, 0.0);
        case Fault::friction:
            return std::max(-energy.friction / area, 0.0);
        case Fault::contact: {
            Evidence found;
            add_penetrations(model_, static_cast<std::int32_t>(element), panel_.columns(), found);
            return std::max({found.between_plies, found.in_projectile, found.in_frame});
        }
        default:
            return (std::abs(energy.work) + energy.hourglass + std::abs(energy.friction)) / area +
                   kinetic_of(model_, element);
    }
}

std::int64_t Simulation::worst_element(Fault fault) const {
    if (fault == Fault::force)
        if (const auto element = faulty_element(); element >= 0) return element;
    double most = -1;
    std::int64_t worst = no_element;
    const auto& ids = model_.global.element_ids;
    for (std::size_t e = 0; e < ids.size(); ++e) {
        const double here = severity(fault, e);
        if (here > most) most = here, worst = ids[e];
    }
    if (most < comm_.max(most)) worst = no_element;
    comm_.min({&worst, 1});
    return worst;
}

std::string Simulation::diagnosis(Fault fault) const {
    const auto element = worst_element(fault);
    auto found = evidence_of(model_, local_index(model_, element), panel_.columns());
    comm_.max(found.values());
    auto step_bound = step_bound_;
    double bound = 0;
    for (int call = 0; call < calls_to_tighten && clock_.dt > bound; ++call)
        bound = std::max(bound, 2 / std::sqrt(step_bound.frequency_squared(model_, contact_.pairs, comm_)));
    const auto ply = static_cast<std::size_t>(element / panel_.columns());
    const auto& fabric = scene_.fabrics[static_cast<std::size_t>(scene_.target->plies[ply].fabric)];
    const double safety = scene_.time.safety;
    const auto causes =
        causes_of(found, of_time_step(clock_.dt, bound, safety), safety, fault, fabric.formulation);
    std::vector<std::string> texts;
    for (const auto& cause : causes) texts.push_back(cause.text);
    return fmt::format("it is worst in {}: {}; try {}", place_of(panel_, element), fmt::join(texts, ", and "),
                       causes.front().remedy);
}

}  // namespace weavefront::solver
