#pragma once
/// @file
/// The study file as plain structs: which variants of a scene are computed, and what they are compared with.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "weavefront/scene/scene.hpp"

namespace weavefront::scene {

/// What a variant computes: the impact of its scene, a yarn strained at a constant rate, or a cell taken
/// through a deformation.
enum class Compute { impact, yarn, cell };

/// How the difference of two histories becomes a number: integral over time of its magnitude or square (root
/// of it), or its largest.
enum class Norm { l1, l2, max };

/// A value given to a key of the scene, as `--set` does, or of the study's own sections `yarn` and `cell`.
struct Setting {
    std::string path;   ///< dots between keys
    std::string value;  ///< YAML; empty: the key is left out
    std::string where;  ///< file:line:column, for messages
};

/// One value of an axis.
struct Choice {
    std::string label;              ///< as the study file writes it
    std::optional<double> value;    ///< SI; none: not a quantity
    std::vector<Setting> settings;  ///< what it changes
};

/// One dimension of the product of variants.
struct Axis {
    std::string name;
    std::vector<Choice> choices;
};

/// What is compared: an outcome of the run, a column of history.csv in a norm over time, or a field of
/// results.vtkhdf at a time.
struct Measure {
    enum class Kind { outcome, history, field };
    Kind kind = Kind::outcome;
    std::string name;  ///< of its column in study.csv
    std::string of;    ///< outcome, column or field
    Norm norm = Norm::l2;
    double time = 0;                  ///< of a field, s
    std::optional<double> tolerance;  ///< within which a repeat of the study gives it again, relative
};

/// What the variants are compared with.
struct Reference {
    enum class Kind { none, variant, closed_form, file };
    Kind kind = Kind::none;
    std::vector<std::optional<std::size_t>>
        choices;                    ///< of the variant, one an axis; none: as in the variant that is compared
    std::vector<Setting> settings;  ///< of the variant beside them
    std::string closed_form;
    std::filesystem::path file;  ///< CSV of measured values
};

/// `yarn`: one yarn strained from rest.
struct YarnTest {
    double rate = 0;         ///< of strain, 1/s
    double strain = 0;       ///< reached at the end, 1
    std::int64_t steps = 0;  ///< to the end
};

/// `cell`: one material point through the rows of a deformation path.
struct CellTest {
    std::filesystem::path path;     ///< CSV, as of `weavefront cell`
    std::int64_t refinement = 1;    ///< steps between two rows
    double crimp_tolerance = 1e-8;  ///< last Newton step of the crimp equilibrium over t/2
};

/// One study.
struct Study {
    std::string title;
    std::filesystem::path scene;  ///< base scene
    Compute compute = Compute::impact;
    std::vector<Setting> set;  ///< of every variant
    std::vector<Axis> axes;
    std::optional<std::size_t> order;  ///< axis along which the order of convergence is observed
    std::vector<std::string>
        order_findings;  ///< `order` names no axis: the fault is the axis' when that is no path of the scene
    Reference reference;
    std::vector<Measure> quantities;
    std::string text, name;  ///< of the file, for the sections that variants change
};

/// One point of the product.
struct Variant {
    std::string name;                           ///< of its folder
    std::vector<std::string> labels;            ///< one an axis
    std::vector<std::optional<double>> values;  ///< one an axis
    std::vector<std::size_t> choices;           ///< indices, one an axis
    std::vector<Setting> settings;  ///< `Study::set`, then those of the axes, then those of the reference
};

/// What a variant computes with.
struct Case {
    Scene scene;
    YarnTest yarn;
    CellTest cell;
    std::string hash;  ///< of everything that its results depend on
};

/// The names that a study may use; they belong to the programs that compute and measure.
struct Vocabulary {
    std::vector<std::string> outcomes, columns, fields, closed_forms;
};

/// Reads a study. That `order` names no axis, and nothing else is wrong, is left to `parse_cases`.
/// @param text of the file
/// @param name of the file, for messages and as what paths in it are relative to
/// @param vocabulary of each kind of computation
/// @throws InputError with every finding at once
Study parse_study(const std::string& text, const std::string& name,
                  const std::function<Vocabulary(Compute)>& vocabulary);

/// The product of the axes, the last one changing fastest.
std::vector<Variant> variants_of(const Study& study);

/// What `variant` is compared with where the reference is a variant.
Variant reference_of(const Study& study, const Variant& variant);

/// Reads the scene of a variant, and the study's own sections as it changes them.
/// @param scene_text of the base scene
/// @throws InputError with every finding at once, those of a setting at its place in the study file
Case parse_case(const Study& study, const std::string& scene_text, const Variant& variant);

/// Reads the cases of all variants. @throws InputError with every finding in any of them, each once; without
/// any, those of `order`
std::vector<Case> parse_cases(const Study& study, const std::string& scene_text,
                              const std::vector<Variant>& variants);

}  // namespace weavefront::scene
