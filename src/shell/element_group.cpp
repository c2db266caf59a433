#include "weavefront/shell/element_group.hpp"

#include <algorithm>

#include "weavefront/shell/vector.hpp"

namespace weavefront::shell {

namespace {

std::array<double, quad_size> fields_of(const Quad<double>& q) { return {q.Bf1, q.Bf2, q.Bw1, q.Bw2, q.e1, q.e2, q.area, q.shape}; }

HourglassStiffness hourglass_stiffness(const scene::Fabric& fabric) {
    // In the plane E1 S/s in each of the two directions, of which each sees half of Quad::shape.
    const double membrane = fabric.elastic.static_modulus * fabric.yarn.area / fabric.yarn.span;
    const double in_plane = fabric.hourglass * membrane / 2;
    return {in_plane, std::max(fabric.transverse_shear * fabric.effective_thickness(), in_plane)};
}

}  // namespace

ElementGroup::ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements, int state_size)
    : packs_(static_cast<std::int32_t>((elements.size() + pack_width - 1) / pack_width)),
      state_size_(state_size),
      hourglass_(hourglass_stiffness(fabric)),
      areal_density_(fabric.areal_density),
      nodes_(static_cast<std::size_t>(packs_)) {
    const auto lanes = static_cast<std::size_t>(packs_) * pack_width;
    quads_.resize(lanes * quad_size);
    state_.resize(lanes * static_cast<std::size_t>(state_size));
    hourglass_energy_.resize(lanes);
    elements_.reserve(elements.size());
    for (std::size_t i = 0; i < lanes; ++i) {
        const auto& source = elements[std::min(i, elements.size() - 1)];
        const auto index = static_cast<std::int32_t>(i);
        for (std::size_t a = 0; a < 4; ++a) nodes_[i / pack_width][a][i % pack_width] = source.nodes[a];
        const auto fields = fields_of(source.quad);
        for (int field = 0; field < quad_size; ++field) quads_[slot(index, field, quad_size)] = fields[static_cast<std::size_t>(field)];
        if (i < elements.size())
            elements_.push_back(source.element);
        else
            clear_quad(index);
    }
}

void ElementGroup::clear_quad(std::int32_t index) {
    // The gradients stay, so that the idle lane computes finite numbers; without area and shape they have no effect.
    quads_[slot(index, 6, quad_size)] = 0;
    quads_[slot(index, 7, quad_size)] = 0;
}

void ElementGroup::save(std::int32_t index, std::vector<double>& record) const {
    for (int field = 0; field < quad_size; ++field) record.push_back(quad(index, field));
    for (int field = 0; field < state_size_; ++field) record.push_back(state_[slot(index, field, state_size_)]);
    record.push_back(hourglass_energy(index));
}

std::span<const double> ElementGroup::restore(std::int32_t index, std::span<const double> record) {
    std::size_t at = 0;
    for (int field = 0; field < quad_size; ++field) quads_[slot(index, field, quad_size)] = record[at++];
    for (int field = 0; field < state_size_; ++field) state_[slot(index, field, state_size_)] = record[at++];
    hourglass_energy_[static_cast<std::size_t>(index)] = record[at++];
    return record.subspan(at);
}

Events::Erosion ElementGroup::erode(std::int32_t index) {
    const auto left = energy(index);
    clear_quad(index);
    hourglass_energy_[static_cast<std::size_t>(index)] = 0;
    return {elements_[static_cast<std::size_t>(index)], left.work, left.hourglass, left.friction};
}

std::size_t ElementGroup::bytes() const {
    const auto doubles = quads_.size() + state_.size() + hourglass_energy_.size();
    return doubles * sizeof(double) + nodes_.size() * sizeof(nodes_[0]) + elements_.size() * sizeof(std::int32_t);
}

}  // namespace weavefront::shell
