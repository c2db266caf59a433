#include "weavefront/solver/redistribution.hpp"

#include <algorithm>
#include <array>

#include "weavefront/parallel/all_to_all.hpp"

namespace weavefront::solver {

namespace {

constexpr std::size_t shown_of_eroded = 8;

std::array<double, shown_of_eroded> numbers_of(const shell::ElementOutput& o) {
    return {o.strain_fill,
            o.strain_warp,
            o.stress_fill,
            o.stress_warp,
            o.braid_angle,
            o.crimp_height,
            o.broken_fill ? 1.0 : 0.0,
            o.broken_warp ? 1.0 : 0.0};
}

shell::ElementOutput output_of(std::span<const double> numbers) {
    return {numbers[0], numbers[1], numbers[2],      numbers[3],
            numbers[4], numbers[5], numbers[6] != 0, numbers[7] != 0};
}

/// The id of an element (below 2^53, so a double holds it), its corners' motion, and what fabric and contact
/// remember of it.
std::vector<double> record_of(const Model& model, std::int32_t element) {
    const auto e = static_cast<std::size_t>(element);
    std::vector<double> record{static_cast<double>(model.global.element_ids[e])};
    for (const auto node : model.surface.facets[e].nodes) {
        const auto n = static_cast<std::size_t>(node);
        for (const auto* vector : {&model.nodes.x[n], &model.nodes.v[n]})
            record.insert(record.end(), vector->begin(), vector->end());
    }
    const auto slot = model.slots[e];
    const auto& group = *model.groups[static_cast<std::size_t>(slot.group)];
    group.save(slot.index, record);
    if (!group.alive(slot.index)) {
        const auto shown = numbers_of(model.output(element));
        record.insert(record.end(), shown.begin(), shown.end());
    }
    if (model.projectile_contact) model.projectile_contact->save(element, record);
    if (model.ply_contact) model.ply_contact->save(element, record);
    if (model.frame_contact) model.frame_contact->save(element, record);
    return record;
}

Vec3 take_vector(std::span<const double>& record) {
    const Vec3 vector(record[0], record[1], record[2]);
    record = record.subspan(3);
    return vector;
}

/// Takes up the first of some records. @return those after it
std::span<const double> take_record(std::span<const double> records, Model& model) {
    const auto& ids = model.global.element_ids;
    const auto e = static_cast<std::size_t>(
        std::ranges::lower_bound(ids, static_cast<std::int64_t>(records[0])) - ids.begin());
    const auto element = static_cast<std::int32_t>(e);
    records = records.subspan(1);
    for (const auto node : model.surface.facets[e].nodes) {
        model.nodes.x[static_cast<std::size_t>(node)] = take_vector(records);
        model.nodes.v[static_cast<std::size_t>(node)] = take_vector(records);
    }
    const auto slot = model.slots[e];
    auto& group = *model.groups[static_cast<std::size_t>(slot.group)];
    records = group.restore(slot.index, records);
    model.surface.alive[e] = group.alive(slot.index);
    if (!group.alive(slot.index)) {
        model.eroded.emplace(element, output_of(records));
        records = records.subspan(shown_of_eroded);
    }
    if (model.projectile_contact) records = model.projectile_contact->restore(element, records);
    if (model.ply_contact) records = model.ply_contact->restore(element, records);
    if (model.frame_contact) records = model.frame_contact->restore(element, records);
    return records;
}

}  // namespace

Model redistribute(const scene::Scene& scene, const mesh::Panel& panel,
                   const partition::Decomposition& decomposition, const Model& model,
                   const parallel::Communicator& comm) {
    auto next = build_model(scene, panel, decomposition, comm);
    next.projectile = model.projectile;
    next.projectile_on_frame = model.projectile_on_frame;
    std::vector<std::vector<double>> leaving(static_cast<std::size_t>(comm.size()));
    for (std::int32_t e = 0; e < model.surface.owned; ++e) {
        const auto column =
            static_cast<std::size_t>(model.global.element_ids[static_cast<std::size_t>(e)] % panel.columns());
        const auto record = record_of(model, e);
        const auto owner = decomposition.owner[column];
        if (owner == comm.rank()) {
            take_record(record, next);
            continue;
        }
        auto& to = leaving[static_cast<std::size_t>(owner)];
        to.insert(to.end(), record.begin(), record.end());
    }
    for (const auto& arriving : parallel::all_to_all(comm, leaving))
        for (std::span<const double> rest = arriving; !rest.empty();) rest = take_record(rest, next);
    return next;
}

}  // namespace weavefront::solver
