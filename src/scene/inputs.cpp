// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

namespace hawser::scene {

InteractionId resolve_interaction(const Description& out, const Scope& scope,
                                  const std::string& name, const SourceLocation& location) {
    const InteractionId id = out.find_interaction(scope.prefix + name);
    if (id.valid()) {
        return id;
    }
    std::vector<std::string> known;
    for (const InteractionDef& def : out.interactions) {
        if (!def.name.empty() && def.name.starts_with(scope.prefix)) {
            known.push_back(def.name.substr(scope.prefix.size()));
        }
    }
    report_missing(out.mistakes, OmittedPart::interaction, scope.prefix + name, location,
                   "there is no interaction " + in_quotes(name) + suggestion(name, known));
}

namespace {

std::string resolve_param(const KindInfo& kind, const std::string& name,
                          const SourceLocation& location) {
    std::vector<std::string> known;
    for (const ParamInfo& param : kind.params) {
        if (param.input && name == param.name) {
            return name;
        }
        if (param.input) {
            known.emplace_back(param.name);
        }
    }
    if (known.empty()) {
        throw_error(location,
                    std::string("a ") + kind.name + " has no parameter that an input may set");
    }
    throw_error(location, std::string("a ") + kind.name + " has no parameter " + in_quotes(name) +
                              " that an input may set" + suggestion(name, known));
}

int component_index(const std::string& word) {
    const int axis = word.back() - 'x';
    return word.starts_with("torque") ? 3 + axis : axis;
}

/// Read the key "spring", whose value must be within the range. The range must have been read.
template <class Def>
void read_spring(Def& def, const Json& json, const SourceLocation& location) {
    const auto spring = json.find("spring");
    if (spring == json.end()) return;
    def.spring = spring->get<double>();
    if (!(*def.spring >= def.min && *def.spring <= def.max))
        throw_error(location / "spring", "must lie between \"min\" and \"max\"");
}

InputDef read_input(Description& out, const Scope& scope, const Json& json,
                    const SourceLocation& location) {
    InputDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.min = number_or(json, "min", def.min);
    def.max = number_or(json, "max", def.max);
    if (def.min > def.max) {
        throw_error(location / "min", "must not be greater than \"max\"");
    }
    read_display(def, json);
    def.local = json.value("local", false);
    read_spring(def, json, location);
    if (json.contains("interaction")) {
        def.interaction = resolve_interaction(out, scope, json["interaction"].get<std::string>(),
                                              location / "interaction");
        if (!json.contains("param")) {
            throw_error(location, "an input of an interaction needs the key \"param\"");
        }
        const auto index = static_cast<std::size_t>(def.interaction.index);
        def.param = resolve_param(kind_info(out.interactions[index].kind),
                                  json["param"].get<std::string>(), location / "param");
        return def;
    }
    if (!json.contains("body") || !json.contains("component")) {
        throw_error(location,
                    "an input needs \"interaction\" and \"param\", or \"body\" and "
                    "\"component\"");
    }
    def.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    def.component = component_index(json["component"].get<std::string>());
    const BodyKind kind = out.body(def.body).kind;
    const bool takes = kind == BodyKind::rigid || (kind == BodyKind::lump && def.component < 3) ||
                       (kind == BodyKind::scalar && def.component == 0);
    if (!takes) {
        throw_error(location / "component", "this component does not act on a body of its kind");
    }
    if (def.local && kind != BodyKind::rigid) {
        throw_error(location / "local", "a body of its kind does not rotate");
    }
    return def;
}

/// Read an input that sets a signal. The signal exists only after the world is built.
SignalInput read_signal_input(const Scope& scope, const Json& json,
                              const SourceLocation& location) {
    SignalInput out;
    out.name = scope.prefix + json["name"].get<std::string>();
    out.signal = json["signal"].get<std::string>();
    out.factor = number_or(json, "factor", out.factor);
    out.min = number_or(json, "min", out.min);
    out.max = number_or(json, "max", out.max);
    if (out.min > out.max) throw_error(location / "min", "must not be greater than \"max\"");
    read_display(out, json);
    read_spring(out, json, location);
    return out;
}

}  // namespace

void expand_inputs(Description& out, const Scope& scope) {
    const auto list = scope.content->find("inputs");
    if (list == scope.content->end()) {
        return;
    }
    for (std::size_t i = 0; i < list->size(); ++i) {
        if ((*list)[i].is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const SourceLocation location = scope.location / "inputs" / i;
        (void)attempt(out.mistakes, [&] {
            if ((*list)[i].contains("signal")) {
                out.add_signal_input(read_signal_input(scope, (*list)[i], location),
                                     out.store_location(location));
                return;
            }
            InputDef def = read_input(out, scope, (*list)[i], location);
            out.add_input(std::move(def), out.store_location(location));
        });
    }
}

}  // namespace hawser::scene
