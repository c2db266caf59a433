#include "weavefront/shell/element_group.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "weavefront/shell/vector.hpp"

namespace weavefront::shell {

namespace {

std::vector<Quad<double>> quads_of(std::span<const GroupElement> elements) {
    std::vector<Quad<double>> quads;
    quads.reserve(elements.size());
    for (const auto& element : elements) quads.push_back(element.quad);
    return quads;
}

HourglassStiffness hourglass_stiffness(const scene::Fabric& fabric) {
    // In the plane E1 S/s in each of the two directions, of which each sees half of Quad::shape.
    const double membrane = fabric.elastic.static_modulus * fabric.yarn.area / fabric.yarn.span;
    const double in_plane = fabric.hourglass * membrane / 2;
    return {in_plane, std::max(fabric.transverse_shear * fabric.effective_thickness(), in_plane)};
}

}  // namespace

ElementGroup::ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements,
                           const StateSizes& sizes, StateNames names)
    : size_(static_cast<std::int32_t>(elements.size())),
      packs_((size_ + pack_width - 1) / pack_width),
      hourglass_(hourglass_stiffness(fabric)),
      areal_density_(fabric.areal_density),
      nodes_(static_cast<std::size_t>(packs_)),
      quads_(quads_of(elements)),
      packing_(packs_, sizes.packing, 0),
      damage_(packs_, sizes.damage, 1),
      changing_fields_(sizes.changing),
      names_(std::move(names)) {
    const auto lanes = static_cast<std::size_t>(packs_) * pack_width;
    state_.resize(lanes * static_cast<std::size_t>(sizes.changing));
    hourglass_energy_.resize(lanes);
    for (std::size_t i = 0; i < lanes; ++i) {
        // Lanes beyond the last element have the geometry of the next repeat's start, and so need the nodes
        // of an element there.
        const auto& source =
            elements[i < elements.size() ? i : i % static_cast<std::size_t>(quads_.repeat_length())];
        const auto index = static_cast<std::int32_t>(i);
        for (std::size_t a = 0; a < 4; ++a) nodes_[i / pack_width][a][i % pack_width] = source.nodes[a];
        if (i < elements.size() && (runs_.empty() || source.element != element(index)))
            runs_.push_back({index, source.element});
    }
    for (const auto& element : elements)
        parallelograms_ = parallelograms_ && element.quad.e1 == 0 && element.quad.e2 == 0;
    if (sizes.damage > 0)  // so that no filling lane outlives the element
        for (auto index = size_; index < packs_ * pack_width; ++index) take_out(index);
    runs_.shrink_to_fit();
}

void ElementGroup::tighten(const TighteningStart& start, std::span<const Eigen::Vector3d> x,
                           TightBounds& bounds) const {
    TightBounds own = start.least;
    tighten_uniform(start, x, own);
    for (std::size_t i = 0; i < couplings.size(); ++i)
        bounds[i] = std::max(bounds[i], with_hourglass(parallelograms_, own[i], start.hourglass));
}

double ElementGroup::least_facing(std::span<const Eigen::Vector3d> x, const Eigen::Vector3d& axis,
                                  double known, double enough) {
    using fabric::Pack;
    for (std::int32_t i = 0; i < packs_ && known > enough; ++i) {
        const auto pack = i + steepest_ < packs_ ? i + steepest_ : i + steepest_ - packs_;
        const auto corners = gather(pack, x);
        const auto normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
        const Pack along = normal.x * axis.x() + normal.y * axis.y() + normal.z * axis.z();
        const Pack facing =
            along * fabric::abs(along) / dot(normal, normal);  // not a number where the element has no area
        if (!fabric::any(facing < known)) continue;
        for (int lane = 0; lane < pack_width; ++lane) {
            const auto index = pack * pack_width + lane;
            if (facing.get(lane) < known && index < size_ && alive(index)) known = facing.get(lane);
        }
        if (!(known > enough)) steepest_ = pack;
    }
    return known;
}

std::int32_t ElementGroup::element(std::int32_t index) const {
    const auto run = std::ranges::upper_bound(runs_, index, {}, &Run::first) - 1;
    return run->element + (index - run->first);
}

void ElementGroup::fill_lanes(std::int32_t index) {
    for (auto filling = size_; filling < packs_ * pack_width; ++filling) {
        if (filling % quads_.repeat_length() != index) continue;
        for (int field = 0; field < changing_fields_; ++field)
            state_[slot(filling, field)] = state_[slot(index, field)];
        for (auto* blocks : {&packing_, &damage_})
            for (int field = 0; field < blocks->fields(); ++field)
                blocks->set(filling / pack_width, field, filling % pack_width,
                            blocks->get(index / pack_width, field, index % pack_width));
        hourglass_energy_[static_cast<std::size_t>(filling)] =
            hourglass_energy_[static_cast<std::size_t>(index)];
        if (damage_.fields() > 0) take_out(filling);
    }
}

Events::Erosion ElementGroup::erode(std::int32_t index) {
    const auto left = energy(index);
    take_out(index);
    hourglass_energy_[static_cast<std::size_t>(index)] = 0;
    return {element(index), left.work, left.hourglass, left.friction};
}

std::size_t ElementGroup::bytes() const {
    return (state_.size() + hourglass_energy_.size()) * sizeof(double) + nodes_.size() * sizeof(nodes_[0]) +
           quads_.bytes() + packing_.bytes() + damage_.bytes();
}

}  // namespace weavefront::shell
