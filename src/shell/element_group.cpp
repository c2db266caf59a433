#include "weavefront/shell/element_group.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "weavefront/fabric/cell.hpp"
#include "weavefront/scene/trigonometry.hpp"
#include "weavefront/shell/inversion.hpp"
#include "weavefront/shell/vector.hpp"

namespace weavefront::shell {

namespace {

// Straight yarns are crimped ones of no height, and the state has the stresses of yarns without viscosity.
constexpr fabric::Features any_yarns{.crimp = true, .viscous = true, .unequal = true};

std::vector<Quad<double>> quads_of(std::span<const GroupElement> elements) {
    std::vector<Quad<double>> quads;
    quads.reserve(elements.size());
    for (const auto& element : elements) quads.push_back(element.quad);
    return quads;
}

HourglassStiffness hourglass_stiffness(const scene::Fabric& fabric) {
    // In the plane E1 S/s in each of the two directions, of which each sees half of Quad::shape.
    double membrane = 0;
    for (const auto& system : fabric.systems())
        membrane += system.membrane_stiffness(system.elastic.static_modulus) / 2;
    const double in_plane = fabric.hourglass * membrane / 2;
    return {in_plane, std::max(fabric.transverse_shear * fabric.effective_thickness(), in_plane)};
}

}  // namespace

ElementGroup::ElementGroup(const scene::Fabric& fabric, std::span<const GroupElement> elements,
                           StateNames names)
    : size_(static_cast<std::int32_t>(elements.size())),
      packs_((size_ + pack_width - 1) / pack_width),
      hourglass_(hourglass_stiffness(fabric)),
      areal_density_(fabric.areal_density),
      nodes_(static_cast<std::size_t>(packs_)),
      quads_(quads_of(elements)),
      packing_(packs_, number_of(names.packing), 0),
      damage_(packs_, number_of(names.damage), 1),
      constants_(fabric::constants_of(fabric)),
      names_(std::move(names)) {
    const auto lanes = static_cast<std::size_t>(packs_) * pack_width;
    state_.resize(lanes * names_.changing.size());
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
    if (damage_.fields() > 0)  // so that no filling lane outlives the element
        for (auto index = size_; index < packs_ * pack_width; ++index) take_out(index);
    runs_.shrink_to_fit();
}

std::int64_t ElementGroup::inverted(std::span<const Eigen::Vector3d> x) const {
    std::int64_t count = 0;
    for (std::int32_t pack = 0; pack < packs_; ++pack) {
        const auto folded = is_inverted(corners(pack, x));
        if (!simd::any(folded)) continue;
        for (int lane = 0; lane < pack_width; ++lane) {
            const auto index = pack * pack_width + lane;
            count += index < size_ && folded.get(lane) && alive(index) ? 1 : 0;
        }
    }
    return count;
}

IntactYarns ElementGroup::intact_yarns(std::int32_t index) const {
    if (damage_.fields() == 0) return {};
    const auto is_intact = [&](int field) {
        return damage_.get(index / pack_width, field, index % pack_width) != 0;
    };
    return {is_intact(alive_field + 1), is_intact(alive_field + 2)};
}

ElementEnergy ElementGroup::energy(std::int32_t index) const {
    const auto state = element_state(index);
    const double size = area(index);
    return {state.work * size, hourglass_energy(index), state.friction_work * size};
}

std::array<Vector<double>, 4> ElementGroup::element_corners(std::int32_t index,
                                                            std::span<const Eigen::Vector3d> x) const {
    std::array<Vector<double>, 4> corners;
    for (std::size_t a = 0; a < 4; ++a) {
        const auto node = nodes(index / pack_width)[a][static_cast<std::size_t>(index % pack_width)];
        const auto& at = x[static_cast<std::size_t>(node)];
        corners[a] = {at.x(), at.y(), at.z()};
    }
    return corners;
}

double ElementGroup::braid_angle(std::int32_t index, const std::array<Vector<double>, 4>& corners) const {
    const auto k = kinematics_of(whole_quad(index), corners);
    const double cos_2theta = dot(k.g_f, k.g_w) / std::sqrt(dot(k.g_f, k.g_f) * dot(k.g_w, k.g_w));
    return scene::arc_cosine(std::clamp(cos_2theta, -1.0, 1.0)) / 2;
}

ElementCondition ElementGroup::condition(std::int32_t index, std::span<const Eigen::Vector3d> x) const {
    const auto corners = element_corners(index, x);
    return {is_inverted(corners), element_state(index).alpha, braid_angle(index, corners)};
}

ElementOutput ElementGroup::output(std::int32_t index, std::span<const Eigen::Vector3d> x) const {
    const auto state = element_state(index);
    const auto yarns = fabric::yarn_state<any_yarns>(constants_, state);
    return {yarns.eps_f,
            yarns.eps_w,
            yarns.sigma_f,
            yarns.sigma_w,
            braid_angle(index, element_corners(index, x)),
            state.h_f,
            state.intact_f == 0,
            state.intact_w == 0};
}

std::int32_t ElementGroup::element(std::int32_t index) const {
    const auto run = std::ranges::upper_bound(runs_, index, {}, &Run::first) - 1;
    return run->element + (index - run->first);
}

int ElementGroup::place_of(std::string_view field) const {
    const auto at = std::ranges::find(names_.changing, field);
    return at == names_.changing.end() ? -1 : static_cast<int>(at - names_.changing.begin());
}

void ElementGroup::fill_lanes(std::int32_t index) {
    for (auto filling = size_; filling < packs_ * pack_width; ++filling) {
        if (filling % quads_.repeat_length() != index) continue;
        for (int field = 0; field < number_of(names_.changing); ++field)
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
    return (state_.size() + hourglass_energy_.size() + weakness_.size()) * sizeof(double) +
           nodes_.size() * sizeof(nodes_[0]) + quads_.bytes() + packing_.bytes() + damage_.bytes();
}

}  // namespace weavefront::shell
