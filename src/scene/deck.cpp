// SPDX-License-Identifier: Apache-2.0
/// Read deck gear. Stoppers hold cables and pins move vertically (hawser/stopper.h, hawser/pin.h).
/// Hooks carry loads (hawser/hook.h). Chasers move along cables (hawser/chaser.h).
#include "scene/deck.h"

#include <string>
#include <utility>

namespace hawser::scene {
namespace {

StopperDef read_stopper(Description& out, const Scope& scope, const Json& json,
                        const Place& place) {
    StopperDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), place / "on");
    def.point = vector_of(json["point"]);
    def.outboard = vector_or(json, "outboard", def.outboard);
    def.reach = number_or(json, "reach", def.reach);
    def.rated_load = json["rated_load"].get<double>();
    def.pitch = number_or(json, "pitch", def.pitch);
    if (const auto closed = json.find("closed"); closed != json.end())
        def.closed = closed->get<bool>();
    return def;
}

PinDef read_pin(Description& out, const Scope& scope, const Json& json, const Place& place) {
    PinDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), place / "on");
    def.from = vector_of(json["from"]);
    def.to = vector_of(json["to"]);
    def.radius = json["radius"].get<double>();
    def.friction = number_or(json, "friction", def.friction);
    def.efficiency = number_or(json, "efficiency", def.efficiency);
    def.speed = number_or(json, "speed", def.speed);
    def.force = number_or(json, "force", def.force);
    def.density = number_or(json, "density", def.density);
    def.margin = number_or(json, "margin", def.margin);
    if (const auto up = json.find("up"); up != json.end()) def.up = up->get<bool>();
    ShapeDef surface;
    read_surface(surface, out, json, place);
    def.material = surface.material;
    def.group = surface.group;
    def.touches = surface.touches;
    return def;
}

HookDef read_hook(Description& out, const Scope& scope, const Json& json, const Place& place) {
    HookDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), place / "on");
    def.point = vector_or(json, "point", def.point);
    def.strength = number_or(json, "strength", def.strength);
    def.latch = number_or(json, "latch", def.latch);
    read_loads(out, scope, json, place, def.loads, def.take);
    return def;
}

ChaserDef read_chaser(Description& out, const Scope& scope, const Json& json, const Place& place) {
    ChaserDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), place / "on");
    def.point = vector_or(json, "point", def.point);
    def.reach = number_or(json, "reach", def.reach);
    def.friction = number_or(json, "friction", def.friction);
    def.arrives = number_or(json, "arrives", def.arrives);
    def.element = number_or(json, "element", def.element);
    if (const auto closed = json.find("closed"); closed != json.end())
        def.closed = closed->get<bool>();
    return def;
}

template <class Item, class Read>
void expand_list(Description& out, const Scope& scope, const char* key, std::vector<Item>& items,
                 const Read& read) {
    const auto list = scope.content->find(key);
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const Place place = scope.place / key / i;
        (void)attempt(out.mistakes, [&] {
            auto def = read(out, scope, json, place);
            for (const Item& other : items)
                if (other.def.name == def.name)
                    refuse(place / "name", "the name " + in_quotes(def.name) + " exists already");
            items.push_back({std::move(def), place});
        });
    }
}

template <class Def>
void add(World& world, const Def& def, const Place& place) {
    try {
        world.add(def);
    } catch (const DefError& error) {
        refuse_field(place, field_words(error));
    }
}

}  // namespace

void expand_deck(Description& out, const Scope& scope) {
    expand_list(out, scope, "stoppers", out.deck.stoppers, read_stopper);
    expand_list(out, scope, "pins", out.deck.pins, read_pin);
    expand_list(out, scope, "hooks", out.deck.hooks, read_hook);
    expand_list(out, scope, "chasers", out.deck.chasers, read_chaser);
}

void add_deck(World& world, const Description& from) {
    for (const auto& item : from.deck.pins)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.place); });
    for (const auto& item : from.deck.stoppers)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.place); });
    for (const auto& item : from.deck.hooks)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.place); });
    for (const auto& item : from.deck.chasers)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.place); });
}

}  // namespace hawser::scene
