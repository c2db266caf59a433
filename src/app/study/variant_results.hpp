#pragma once
/// @file
/// The files that a variant left, read back.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "weavefront/scene/study.hpp"
#include "weavefront/study/curve.hpp"
#include "weavefront/study/strip.hpp"

namespace weavefront::app {

/// summary.json and history.csv of a variant, and what can be told from its results.vtkhdf.
class VariantResults {
  public:
    /// @throws std::runtime_error when a file cannot be read
    VariantResults(const scene::Case& variant, const std::filesystem::path& folder);

    [[nodiscard]] const nlohmann::json& summary() const { return summary_; }
    /// A column of the history over time.
    [[nodiscard]] study::Curve history(const std::string& column) const;
    /// An outcome by its name in the vocabulary; none where it does not apply.
    [[nodiscard]] std::optional<double> outcome(const std::string& name) const;

  private:
    [[nodiscard]] std::optional<double> strip(const std::string& name) const;
    [[nodiscard]] double last(const std::string& column) const { return history_.at(column).back(); }

    const scene::Case& variant_;
    std::filesystem::path folder_;
    nlohmann::json summary_;
    study::Columns history_;
    mutable std::optional<study::StripWaves> waves_;
};

}  // namespace weavefront::app
