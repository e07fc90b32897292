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
std::string cable_name(Description& out, const Scope& scope, const Json& json, const Place& place) {
    const std::string cable = json.get<std::string>();
    std::string full = scope.prefix + cable;
    if (out.has_cable(full)) return full;
    std::vector<std::string> known;
    for (const Cable& one : out.cables)
        if (one.name.starts_with(scope.prefix))
            known.push_back(one.name.substr(scope.prefix.size()));
    refuse_missing(out.mistakes, Lost::cable, full, place,
                   "there is no cable " + in_quotes(cable) + suggestion(cable, known));
}

AnchorItem read_anchor(Description& out, const Scope& scope, const Json& json, const Place& place) {
    AnchorItem item{.def = {}, .cable = {}, .place = place};
    AnchorDef& def = item.def;
    if (json.contains("cable")) item.cable = cable_name(out, scope, json["cable"], place / "cable");
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["body"].get<std::string>(), place / "body");
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
                         const Place& place) {
    StabilityItem item{.def = {}, .cable = {}, .others = {}, .place = place};
    StabilityDef& def = item.def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["body"].get<std::string>(), place / "body");
    item.cable = cable_name(out, scope, json["cable"], place / "cable");
    if (const auto others = json.find("other_cables"); others != json.end())
        for (std::size_t i = 0; i < others->size(); ++i)
            item.others.push_back(cable_name(out, scope, (*others)[i], place / "other_cables" / i));
    def.pin = vector_of(json["pin"]);
    def.stern = vector_or(json, "stern", def.stern);
    read_anchor_part(def, json);
    return item;
}

/// Reject a field of an anchor, with the names that angles have in scenes.
[[noreturn]] void refuse_anchor_field(const Place& place, const DefError& error) {
    FieldWords said = field_words(error);
    for (const char* angle : {"clay/fluke_angle", "most_heel", "deck_edge", "flooding"})
        if (said.path == angle) said.path += "_deg";
    if (said.path == "wire") said.path = "cable";
    if (said.path == "others") said.path = "other_cables";
    refuse_field(place, said);
}

template <class Items, class Read>
void read_anchor_list(Description& out, const Scope& scope, const char* key, Items& items,
                      const Read& read) {
    const auto list = scope.content->find(key);
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const Place place = scope.place / key / i;
        (void)attempt(out.mistakes, [&] {
            auto item = read(json, place);
            for (const auto& other : items)
                if (other.def.name == item.def.name)
                    refuse(place / "name",
                           "the name " + in_quotes(item.def.name) + " exists already");
            items.push_back(std::move(item));
        });
    }
}

}  // namespace

void expand_anchors(Description& out, const Scope& scope) {
    read_anchor_list(out, scope, "anchors", out.anchors, [&](const Json& json, const Place& place) {
        return read_anchor(out, scope, json, place);
    });
    read_anchor_list(
        out, scope, "stability", out.gauges,
        [&](const Json& json, const Place& place) { return read_gauge(out, scope, json, place); });
}

void add_anchors(World& world, const Description& from) {
    const auto add = [&](const auto& item) {
        (void)attempt(from.mistakes, [&] {
            try {
                auto def = item.def;
                if (!item.cable.empty()) def.wire = world.wires().find(item.cable);
                if constexpr (requires { item.others; })
                    for (const std::string& other : item.others)
                        def.others.push_back(world.wires().find(other));
                world.add(def);
            } catch (const DefError& error) {
                refuse_anchor_field(item.place, error);
            }
        });
    };
    for (const AnchorItem& item : from.anchors) add(item);
    for (const StabilityItem& item : from.gauges) add(item);
}

}  // namespace hawser::scene
