#include "weavefront/scene/read.hpp"

#include <fmt/format.h>

#include <limits>

#include "hash.hpp"
#include "library_fabrics.hpp"
#include "library_projectiles.hpp"
#include "overrides.hpp"
#include "parts.hpp"
#include "weavefront/scene/text.hpp"

namespace weavefront::scene {
namespace {

// A section that only the impact must have.
template <typename Read>
auto read_part(Section& root, std::string_view key, Need need, Read read)
    -> std::optional<std::invoke_result_t<Read, Section&>> {
    if (need == Need::impact) return root.required(key, read);
    return root.optional(key, read);
}

Scene read_parts(Section& root, Need need) {
    Scene scene;
    scene.title = root.text("title", "");
    scene.fabrics = root.required("fabrics", read_fabrics, "a map of names to fabrics");
    scene.target = read_part(root, "target", need,
                             [&](Section& section) { return read_target(section, scene.fabrics); });
    const Target* target = scene.target ? &*scene.target : nullptr;
    scene.projectiles = read_projectiles(root, scene.fabrics, target);
    scene.has_projectile_list = root.has("projectiles");
    scene.contact =
        root.optional("contact",
                      [&](Section& section) { return read_contact(section, target, scene.projectiles); })
            .value_or(scene.contact);
    scene.damping = root.quantity("damping", rate, non_negative, 0);
    scene.time = read_part(root, "time", need, read_time).value_or(scene.time);
    scene.limits = root.optional("limits", read_limits).value_or(scene.limits);
    const double end = scene.time.end > 0 ? scene.time.end : std::numeric_limits<double>::quiet_NaN();
    scene.output = read_part(root, "output", need, [&](Section& section) {
                       return read_output(section, end);
                   }).value_or(scene.output);

    root.refuse_if(root.has_map("fabrics") && scene.fabrics.empty(), "fabrics", "at least one fabric");
    root.refuse_if(!scene.projectiles.empty() && !root.has("contact"), "contact",
                   "a map with the key projectile, since there is a projectile, such as {projectile: {}}");
    root.options_of_run({"checkpoint", "restart"});
    root.unavailable({"subcycling"});
    return scene;
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
                  Need need, const ReadFile& read_file) {
    return parse_changed_scene(
        text, name, [&](Value& root, Findings& findings) { apply_overrides(root, overrides, findings); },
        need, read_file);
}

Scene parse_changed_scene(const std::string& text, const std::string& name, const Change& change, Need need,
                          const ReadFile& read_file) {
    Value document = parse_document(text, [&](int line, int column) {
        return Location{fmt::format("{}:{}:{}", name, line, column), line, column};
    });
    Context context;
    context.read_file = read_file ? read_file : ReadFile(read_bytes);
    change(document, context.findings);
    const Location start{fmt::format("{}:1:1", name), 1, 1};
    if (document.kind != Value::Kind::map) {
        context.findings.add(start, "", describe(document), "a map of keys, beginning with title or fabrics");
        context.findings.raise();
    }
    if (const Entry* variants = find(document, "variants");
        variants != nullptr && find(document, "fabrics") == nullptr) {
        context.findings.add(variants->value.where, "variants", "a study",
                             "a scene; studies are computed by weavefront study");
        context.findings.raise();
    }
    insert_library_fabrics(document, context.findings);
    insert_standard_projectiles(document, context.findings);
    Section root(document, start, "", context);
    Scene scene = read_parts(root, need);
    root.refuse_unknown();
    context.findings.raise();

    scene.units = context.message_units;
    scene.resolved = resolved_text(scene);
    scene.hash = hash_of(scene.resolved);
    return scene;
}

Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides, Need need) {
    return parse_scene(read_text(path), path.string(), overrides, need);
}

}  // namespace weavefront::scene
