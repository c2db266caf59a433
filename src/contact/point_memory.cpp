#include "weavefront/contact/point_memory.hpp"

namespace weavefront::contact {

void PointMemory::save(std::int32_t facet, std::vector<double>& record) const {
    record.push_back(dissipated_budgets_[static_cast<std::size_t>(facet)]);
    record.push_back(holds(facet) ? 1.0 : 0.0);
    if (!holds(facet)) return;
    for (const auto& batch : recall(facet))
        for (const auto* lanes : {&batch.overlap, &batch.ignored, &batch.opened})
            record.insert(record.end(), lanes->of, lanes->of + batch_width);
}

std::span<const double> PointMemory::restore(std::int32_t facet, std::span<const double> record) {
    auto next = record.begin();
    dissipated_budget(facet) = *next++;
    const bool has_penetrations = *next++ != 0;
    if (!has_penetrations) return {next, record.end()};
    FacetPoints points;
    for (auto& batch : points)
        for (auto* lanes : {&batch.overlap, &batch.ignored, &batch.opened})
            for (auto& value : lanes->of) value = *next++;
    keep(facet, points);
    return {next, record.end()};
}

}  // namespace weavefront::contact
