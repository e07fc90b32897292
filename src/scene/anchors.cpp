// SPDX-License-Identifier: Apache-2.0
/// Read drag-embedment anchors and stability gauges (hawser/anchor.h, hawser/stability.h).
#include "scene/anchors.h"

#include "scene/field_reader.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

template <class T>
void read_anchor_part(T& out, const Json& json) {
    read_fields(out, json, VesselTable<T>::kNumbers);
}

/// Return the index of a word that the format has accepted.
template <class Enum>
Enum word_of(const Json& json, const char* key, std::span<const char* const> names, Enum fallback) {
    const auto entry = json.find(key);
    if (entry == json.end()) return fallback;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (*entry == names[i]) return static_cast<Enum>(i);
    return fallback;
}

/// Return the full name of a cable of this scope. @throws SceneError with the nearest name
std::string cable_name(Description& out, const Scope& scope, const Json& json,
                       const SourceLocation& location) {
    const std::string cable = json.get<std::string>();
    std::string full = scope.prefix + cable;
    if (out.has_cable(full)) return full;
    std::vector<std::string> known;
    for (const Cable& one : out.cables)
        if (one.name.starts_with(scope.prefix))
            known.push_back(one.name.substr(scope.prefix.size()));
    report_missing(out.mistakes, OmittedPart::cable, full, location,
                   "there is no cable " + in_quotes(cable) + suggestion(cable, known));
}

AnchorItem read_anchor(Description& out, const Scope& scope, const Json& json,
                       const SourceLocation& location) {
    AnchorItem item{.def = {}, .cable = {}, .location = location};
    AnchorDef& def = item.def;
    if (json.contains("cable"))
        item.cable = cable_name(out, scope, json["cable"], location / "cable");
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    def.point = vector_or(json, "point", def.point);
    def.soil = word_of(json, "soil", anchor_soils(), def.soil);
    def.type = word_of(json, "type", anchor_types(), def.type);
    if (json.value("law", "exponential") == "trajectory") def.law = AnchorLaw::trajectory;
    read_anchor_part(def, json);
    if (const auto set = json.find("set"); set != json.end()) def.set = set->get<bool>();
    if (const auto clay = json.find("clay"); clay != json.end()) read_anchor_part(def.clay, *clay);
    return item;
}

StabilityItem read_gauge(Description& out, const Scope& scope, const Json& json,
                         const SourceLocation& location) {
    StabilityItem item{.def = {}, .cable = {}, .other_names = {}, .location = location};
    StabilityDef& def = item.def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    item.cable = cable_name(out, scope, json["cable"], location / "cable");
    if (const auto others = json.find("other_cables"); others != json.end())
        for (std::size_t i = 0; i < others->size(); ++i)
            item.other_names.push_back(
                cable_name(out, scope, (*others)[i], location / "other_cables" / i));
    def.pin = vector_of(json["pin"]);
    def.stern = vector_or(json, "stern", def.stern);
    read_anchor_part(def, json);
    return item;
}

/// Reject a field of an anchor, with the names that angles have in scenes.
[[noreturn]] void throw_anchor_error(const SourceLocation& location, const DefError& error) {
    FieldWords said = field_words(error);
    for (const char* angle : {"clay/fluke_angle", "most_heel", "deck_edge", "flooding"})
        if (said.path == angle) said.path += "_deg";
    if (said.path == "wire") said.path = "cable";
    if (said.path == "others") said.path = "other_cables";
    throw_field_error(location, said);
}

template <class Items, class Read>
void read_anchor_list(Description& out, const Scope& scope, const char* key, Items& items,
                      const Read& read) {
    const auto list = scope.content->find(key);
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / key / i;
        (void)attempt(out.mistakes, [&] {
            auto item = read(json, location);
            for (const auto& other : items)
                if (other.def.name == item.def.name)
                    throw_error(location / "name",
                                "the name " + in_quotes(item.def.name) + " exists already");
            items.push_back(std::move(item));
        });
    }
}

}  // namespace

void expand_anchors(Description& out, const Scope& scope) {
    read_anchor_list(out, scope, "anchors", out.anchors,
                     [&](const Json& json, const SourceLocation& location) {
                         return read_anchor(out, scope, json, location);
                     });
    read_anchor_list(out, scope, "stability", out.gauges,
                     [&](const Json& json, const SourceLocation& location) {
                         return read_gauge(out, scope, json, location);
                     });
}

void add_anchors(World& world, const Description& from) {
    const auto add = [&](const auto& item) {
        (void)attempt(from.mistakes, [&] {
            try {
                auto def = item.def;
                if (!item.cable.empty()) def.wire = world.wires().find(item.cable);
                if constexpr (requires { item.other_names; })
                    for (const std::string& other : item.other_names)
                        def.others.push_back(world.wires().find(other));
                world.add(def);
            } catch (const DefError& error) {
                throw_anchor_error(item.location, error);
            }
        });
    };
    for (const AnchorItem& item : from.anchors) add(item);
    for (const StabilityItem& item : from.gauges) add(item);
}

}  // namespace hawser::scene
