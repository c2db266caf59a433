#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "study_reference.hpp"
#include "study_settings.hpp"
#include "study_tests.hpp"
#include "weavefront/scene/nearest.hpp"
#include "weavefront/scene/study.hpp"

namespace weavefront::scene {
namespace {

constexpr Names<Compute, 3> compute_names{
    {{"impact", Compute::impact}, {"yarn", Compute::yarn}, {"cell", Compute::cell}}};
constexpr Names<Norm, 3> norm_names{{{"l1", Norm::l1}, {"l2", Norm::l2}, {"max", Norm::max}}};

constexpr double most_variants = 10'000;
constexpr std::size_t most_quantities = 100;

/// Reads one study; keeps what its parts share.
class Reader {
  public:
    Reader(Section& root, Context& context, std::filesystem::path folder)
        : root_(root), context_(context), folder_(std::move(folder)) {}

    Study read(const std::function<Vocabulary(Compute)>& vocabulary) {
        Study study;
        study.title = root_.text("title", "");
        study.scene = beside(root_.text("scene", {}, "the path of a scene"));
        study.compute = root_.choice("compute", compute_names, Compute::impact);
        words_ = vocabulary(study.compute);
        if (const Entry* set = root_.raw("set")) study.set = read_settings(set->value, "set", context_);
        if (const Entry* axes = root_.raw("variants"))
            study.axes = read_axes(axes->value, context_);
        else
            root_.refuse_if(true, "variants", "a list of axes, such as - {target.mesh.center: [2 mm, 1 mm]}");
        require_few_variants(study.axes);
        study.order = order(study.axes);
        study.reference =
            root_.optional("reference", [&](Section& section) { return reference(section, study); })
                .value_or(Reference{});
        study.quantities = quantities();
        tolerances(study.quantities);
        read_tests(root_, study.compute, folder_);
        root_.refuse_unknown();
        if (!context_.findings.empty()) context_.findings.take(order_findings_);
        context_.findings.raise();
        study.order_findings = order_findings_.messages();
        return study;
    }

  private:
    [[nodiscard]] std::filesystem::path beside(const std::filesystem::path& path) const {
        return (folder_ / path).lexically_normal();
    }

    /// The product of a few axes can be of any size.
    void require_few_variants(const std::vector<Axis>& axes) {
        double count = 1;
        for (const Axis& axis : axes) count *= static_cast<double>(axis.choices.size());
        if (count <= most_variants) return;
        context_.findings.add(root_.raw("variants")->value.where, "variants",
                              fmt::format("{} variants", count), fmt::format("at most {}", most_variants));
        context_.findings.raise();
    }

    [[nodiscard]] static std::string listed(const std::vector<std::string>& names) {
        return names.empty() ? "none here" : fmt::format("{}", fmt::join(names, ", "));
    }

    /// Notes a finding unless `name` is one of `names`.
    void require_listed(const Location& where, const std::string& path, const std::string& name,
                        const std::vector<std::string>& names) {
        if (std::ranges::find(names, name) != names.end()) return;
        context_.findings.add(where, path, "'" + name + "'", listed(names), nearest(name, names));
    }

    std::optional<std::size_t> order(const std::vector<Axis>& axes) {
        const Entry* entry = root_.raw("order");
        if (entry == nullptr) return std::nullopt;
        const std::string name = root_.text("order", "");
        std::vector<std::string> names;
        for (const Axis& axis : axes) names.push_back(axis.name);
        const auto found = std::ranges::find(names, name);
        if (found == names.end()) {
            // Without a hint: the axis may be the one that is mistyped.
            order_findings_.add(entry->value.where, "order", "'" + name + "'", listed(names));
            return std::nullopt;
        }
        const auto index = static_cast<std::size_t>(found - names.begin());
        const std::vector<Choice>& choices = axes[index].choices;
        const bool numbers =
            std::ranges::all_of(choices, [](const Choice& choice) { return choice.value > 0.0; });
        root_.refuse_if(!choices.empty() && (!numbers || choices.size() < 2), "order",
                        "an axis of at least two positive quantities");
        return index;
    }

    Reference reference(Section& section, const Study& study) {
        Reference reference;
        std::size_t given = 0;
        if (const Entry* entry = section.raw("variant")) {
            reference.kind = Reference::Kind::variant;
            read_reference_variant(entry->value, study, context_, reference);
            ++given;
        }
        if (const Entry* entry = section.raw("closed_form")) {
            reference.kind = Reference::Kind::closed_form;
            reference.closed_form = section.text("closed_form");
            require_listed(entry->value.where, "reference.closed_form", reference.closed_form,
                           words_.closed_forms);
            ++given;
        }
        if (section.has("file")) {
            reference.kind = Reference::Kind::file;
            reference.file = beside(section.text("file", {}, "the path of a table"));
            ++given;
        }
        const std::vector<std::string> keys = section.keys();
        const bool unknown = keys.size() > given;  // reported as such
        if (given != 1 && !unknown)
            context_.findings.add(
                root_.raw("reference")->where, "reference",
                keys.empty() ? "an empty map" : fmt::format("the keys {}", fmt::join(keys, ", ")),
                "one of the keys variant, closed_form, file");
        return reference;
    }

    std::vector<Measure> quantities() {
        std::vector<Measure> quantities;
        const Entry* entry = root_.raw("quantities");
        const bool list =
            entry != nullptr && entry->value.kind == Value::Kind::list && !entry->value.items.empty();
        root_.refuse_if(!list, "quantities",
                        "a list, such as [residual_velocity, {history: projectile_vz, norm: l2}]");
        if (!list) return quantities;
        root_.require_at_most("quantities", entry->value.items.size(), most_quantities, "quantities");
        for (std::size_t i = 0; i < entry->value.items.size(); ++i) {
            const Value& item = entry->value.items[i];
            const std::string path = fmt::format("quantities.{}", i);
            if (item.kind == Value::Kind::scalar) {
                require_listed(item.where, path, item.text, words_.outcomes);
                Measure outcome;
                outcome.name = outcome.of = item.text;
                quantities.push_back(outcome);
            } else if (item.kind == Value::Kind::map) {
                Section section(item, item.where, path, context_);
                quantities.push_back(compared(section, item, path));
                section.refuse_unknown();
            } else {
                context_.findings.add(item.where, path, describe(item),
                                      "a name, or a map with the key history or field");
            }
            const auto before = quantities.end() - (quantities.empty() ? 0 : 1);
            if (std::any_of(quantities.begin(), before,
                            [&](const Measure& other) { return other.name == before->name; }))
                context_.findings.add(item.where, path, fmt::format("'{}' again", before->name),
                                      "each quantity once");
        }
        return quantities;
    }

    Measure compared(Section& section, const Value& item, const std::string& path) {
        Measure quantity;
        if (const Entry* history = section.raw("history")) {
            quantity.kind = Measure::Kind::history;
            quantity.of = section.text("history");
            quantity.norm = section.choice("norm", norm_names, Norm::l2);
            quantity.name = fmt::format("{}_{}", quantity.of, name_of(quantity.norm, norm_names));
            require_listed(history->value.where, path + ".history", quantity.of, words_.columns);
        } else if (const Entry* field = section.raw("field")) {
            quantity.kind = Measure::Kind::field;
            quantity.of = section.text("field");
            quantity.time = section.quantity("time", duration, non_negative);
            quantity.name = quantity.of + "_field";
            require_listed(field->value.where, path + ".field", quantity.of, words_.fields);
        } else {
            context_.findings.add(item.where, path, describe(item), "a map with the key history or field");
        }
        return quantity;
    }

    /// Whether some quantity has this name in study.csv.
    [[nodiscard]] bool could_be_quantity(const std::string& name) const {
        const auto is_history = [&](const std::string& column) {
            return std::ranges::any_of(norm_names, [&](const auto& norm) {
                return name == fmt::format("{}_{}", column, norm.first);
            });
        };
        return std::ranges::find(words_.outcomes, name) != words_.outcomes.end() ||
               std::ranges::any_of(words_.columns, is_history) ||
               std::ranges::any_of(words_.fields,
                                   [&](const std::string& field) { return name == field + "_field"; });
    }

    void tolerances(std::vector<Measure>& quantities) {
        root_.optional(
            "tolerance",
            [&](Section& section) {
                std::vector<std::string> names;
                for (const Measure& quantity : quantities) names.push_back(quantity.name);
                const bool quantities_known = std::ranges::all_of(
                    names, [&](const std::string& name) { return could_be_quantity(name); });
                const std::vector<std::string> keys = section.keys();
                section.require_at_most("", keys.size(), most_quantities, "tolerances");
                for (const std::string& key : keys) {
                    // Where a quantity is mistyped, the tolerance of what was meant is not a fault of its
                    // own.
                    if (quantities_known || !could_be_quantity(key))
                        require_listed(section.raw(key)->where, "tolerance", key, names);
                    const double value = section.quantity(key, ratio, non_negative);
                    for (Measure& quantity : quantities)
                        if (quantity.name == key) quantity.tolerance = value;
                }
                return 0;
            },
            "a map of names in study.csv to numbers");
    }

    Section& root_;
    Context& context_;
    std::filesystem::path folder_;
    Vocabulary words_;
    Findings order_findings_;
};

}  // namespace

Study parse_study(const std::string& text, const std::string& name,
                  const std::function<Vocabulary(Compute)>& vocabulary) {
    const Value document = parse_document(text, [&](int line, int column) {
        return Location{fmt::format("{}:{}:{}", name, line, column), line, column};
    });
    Context context;
    const Location start{fmt::format("{}:1:1", name), 1, 1};
    if (document.kind != Value::Kind::map) {
        context.findings.add(start, "", describe(document), "a map of keys, such as scene and variants");
        context.findings.raise();
    }
    if (const Entry* fabrics = find(document, "fabrics")) {
        context.findings.add(fabrics->value.where, "fabrics", "a scene",
                             "a study, which names its scene; scenes are computed by weavefront run");
        context.findings.raise();
    }
    Section root(document, start, "", context);
    Study study = Reader(root, context, std::filesystem::path(name).parent_path()).read(vocabulary);
    study.text = text;
    study.name = name;
    return study;
}

}  // namespace weavefront::scene
