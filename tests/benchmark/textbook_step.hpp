#pragma once
/// @file
/// The explicit step with none of the solver's optional features compiled in.

#include <cstdint>

#include "weavefront/scene/scene.hpp"
#include "weavefront/solver/model.hpp"
#include "weavefront/solver/step_bound.hpp"

namespace weavefront::benchmark {

/// Central differences of elements, fixed-point assembly and nodes, with the adaptive time step: no word of
/// projectile, contact, frame, supports, damping, ledger, erosion or ghosts. What solver::Simulation pays for
/// the features that a scene leaves out is what it takes more than this. The physics of the yarns is chosen
/// by template in either, so it is not repeated here.
class TextbookStep {
  public:
    /// @param scene without projectile and contact, its edges free, undamped; nothing in it breaks
    TextbookStep(const scene::Scene& scene, const parallel::Communicator& comm);

    /// One step: forces, time step, motion.
    void advance();

    [[nodiscard]] solver::Model& model() { return model_; }

  private:
    void advance_elements();
    void adapt_time_step();
    void move_nodes();

    const parallel::Communicator& comm_;
    double safety_;
    mesh::Panel panel_;
    solver::Model model_;
    solver::StepBound bound_;
    shell::AlignedVector<double> pack_forces_;
    double dt_ = 0, last_dt_ = 0;
    std::int64_t steps_ = 0, next_adaptation_ = 0;
};

}  // namespace weavefront::benchmark
