#pragma once
/// @file
/// The shots of `v50`, round by round.

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "shot_row.hpp"
#include "v50_plan.hpp"
#include "weavefront/io/log.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::app {

/// Shoots what is asked for and keeps v50.csv. All ranks have the same rows.
class Campaign {
  public:
    /// @param plan, comm, log must outlive this object @param folder of `v50`
    Campaign(const V50Plan& plan, std::filesystem::path folder, const parallel::Communicator& comm,
             io::Log& log);

    /// Reads the shots of an interrupted `v50` and finishes those that it has planned.
    /// @throws scene::InputError on all ranks when its table does not fit the plan; Interrupted
    /// @note Collective
    void go_on();

    /// Searches the limit of each variant, or shoots the sequential design where shots scatter.
    /// @throws Interrupted @note Collective
    void shoot();

    [[nodiscard]] const std::vector<ShotRow>& rows() const { return rows_; }
    /// Of each variant, why its limit was not found; empty: it was.
    [[nodiscard]] const std::vector<std::string>& failures() const { return failures_; }
    /// Results of a variant's shots.
    [[nodiscard]] std::vector<ballistics::Trial> trials(std::size_t variant) const;

  private:
    void search(std::size_t variant);
    void shoot_design();
    /// A search of another variant begins at the limit of the scene as it stands.
    [[nodiscard]] ballistics::SearchPlan search_plan(std::size_t variant) const;
    /// The speeds of the first rank, on all ranks.
    [[nodiscard]] std::vector<double> agreed_speeds(const std::vector<double>& wanted) const;
    /// Shoots planned rows that have no result yet, and reads all of them.
    void fire(std::size_t first);
    void add(std::size_t variant, const std::vector<double>& speeds);
    void read_on_root(std::size_t first);
    void share(std::size_t first);
    void write() const;
    void tell(const ShotRow& row) const;
    void record(const ShotRow& row) const;

    const V50Plan& plan_;
    std::filesystem::path folder_;
    const parallel::Communicator& comm_;
    io::Log& log_;
    std::vector<ShotRow> rows_;
    std::vector<std::string> failures_;
    int expected_ = 0;  ///< shots in all, as far as it is known
    int computed_ = 0;  ///< shots of this process
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// `complete, residual 122.41 m/s, 8 of 8 plies perforated, back face 14.212 mm`.
std::string text_of_shot(const V50Plan& plan, const ShotRow& row);

}  // namespace weavefront::app
