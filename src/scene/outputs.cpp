// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

const Cable& resolve_cable(const Description& out, const Scope& scope, const std::string& name,
                           const SourceLocation& location) {
    if (const Cable* cable = out.find_cable(scope.prefix + name); cable != nullptr) {
        return *cable;
    }
    std::vector<std::string> known;
    for (const Cable& cable : out.cables) {
        if (cable.name.starts_with(scope.prefix)) {
            known.push_back(cable.name.substr(scope.prefix.size()));
        }
    }
    report_missing(out.mistakes, OmittedPart::cable, scope.prefix + name, location,
                   "there is no cable " + in_quotes(name) + suggestion(name, known));
}

/// Read the source of an output.
void read_target(OutputDef& def, Description& out, const Scope& scope, const Json& json,
                 const SourceLocation& location) {
    if (json.contains("body")) {
        def.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
        def.point = vector_or(json, "point", Vec3::Zero());
    }
    if (json.contains("bodies")) {
        BodyId* to[] = {&def.body, &def.body_b};
        Vec3* point[] = {&def.point, &def.point_b};
        for (std::size_t i = 0; i < 2; ++i) {
            *to[i] = resolve_body(out, scope, json["bodies"][i].get<std::string>(),
                                  location / "bodies" / i);
            if (json.contains("points")) {
                *point[i] = vector_of(json["points"][i]);
            }
        }
    }
    if (json.contains("interaction")) {
        def.interaction = resolve_interaction(out, scope, json["interaction"].get<std::string>(),
                                              location / "interaction");
    }
    for (std::size_t i = 0; json.contains("interactions") && i < json["interactions"].size(); ++i) {
        def.line.push_back(resolve_interaction(
            out, scope, json["interactions"][i].get<std::string>(), location / "interactions" / i));
    }
}

/// Read the key "cable" of an output of a tension or of a drum.
void read_cable(OutputDef& def, const Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location) {
    const Cable& cable =
        resolve_cable(out, scope, json["cable"].get<std::string>(), location / "cable");
    if (def.kind == OutputKind::tension) {
        def.line = cable.stretch;
        return;
    }
    for (const InteractionId id : cable.stretch) {
        const auto i = static_cast<std::size_t>(id.index);
        if (kind_info(out.interactions[i].kind).is(kWoundUp)) {
            def.interaction = id;
            return;
        }
    }
    throw_error(location / "cable", "the cable " + in_quotes(cable.name) + " has no winch");
}

OutputDef read_output(Description& out, const Scope& scope, const Json& json,
                      const SourceLocation& location) {
    OutputDef def;
    def.kind = find_output_kind(json["kind"].get_ref<const std::string&>())->kind;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.component = text_or(json, "component", "");
    def.local = json.value("local", false);
    read_display(def, json);
    read_target(def, out, scope, json, location);
    if (json.contains("cable")) {
        read_cable(def, out, scope, json, location);
    }
    const OutputTarget target = output_kind_info(def.kind).target;
    if (target == OutputTarget::line && def.line.empty()) {
        throw_error(location, "a tension needs \"cable\" or \"interactions\"");
    }
    if (target == OutputTarget::interaction && !def.interaction.valid()) {
        throw_error(location, "a drum needs \"cable\" or \"interaction\"");
    }
    return def;
}

}  // namespace

void expand_outputs(Description& out, const Scope& scope) {
    const auto list = scope.content->find("outputs");
    if (list == scope.content->end()) {
        return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        if ((*list)[i].is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const SourceLocation location = scope.location / "outputs" / i;
        (void)attempt(out.mistakes, [&] {
            OutputDef def = read_output(out, scope, (*list)[i], location);
            out.add_output(std::move(def), out.store_location(location));
        });
    }
}

OutputDef output_of(const Description& scene, std::size_t output, const World& world) {
    OutputDef def = scene.outputs[output];
    if (def.kind != OutputKind::tension) return def;
    for (const Cable& cable : scene.cables)
        if (!cable.links && cable.stretch == def.line) {
            def.wire = world.wires().find(cable.name);
            def.line.clear();
            break;
        }
    return def;
}

}  // namespace hawser::scene
