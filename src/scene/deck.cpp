// SPDX-License-Identifier: Apache-2.0
/// Read deck gear. Stoppers hold cables and pins move vertically (hawser/stopper.h, hawser/pin.h).
/// Hooks carry loads (hawser/hook.h). Chasers move along cables (hawser/chaser.h).
#include "scene/deck.h"

#include "scene/deck_fields.h"
#include "scene/field_reader.h"

#include <string>
#include <utility>

namespace hawser::scene {
namespace {

StopperDef read_stopper(Description& out, const Scope& scope, const Json& json,
                        const SourceLocation& location) {
    StopperDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    read_fields(def, json, kStopperFields);
    return def;
}

PinDef read_pin(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location) {
    PinDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    read_fields(def, json, kPinFields);
    ShapeDef surface;
    read_surface(surface, out, json, location);
    def.material = surface.material;
    def.group = surface.group;
    def.touches = surface.touches;
    return def;
}

HookDef read_hook(Description& out, const Scope& scope, const Json& json,
                  const SourceLocation& location) {
    HookDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    read_fields(def, json, kHookFields);
    read_loads(out, scope, json, location, def.loads, def.take);
    return def;
}

ChaserDef read_chaser(Description& out, const Scope& scope, const Json& json,
                      const SourceLocation& location) {
    ChaserDef def;
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = resolve_body(out, scope, json["on"].get<std::string>(), location / "on");
    read_fields(def, json, kChaserFields);
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
        const SourceLocation location = scope.location / key / i;
        (void)attempt(out.mistakes, [&] {
            auto def = read(out, scope, json, location);
            for (const Item& other : items)
                if (other.def.name == def.name)
                    throw_error(location / "name",
                                "the name " + in_quotes(def.name) + " exists already");
            items.push_back({std::move(def), location});
        });
    }
}

template <class Def>
void add(World& world, const Def& def, const SourceLocation& location) {
    try {
        world.add(def);
    } catch (const DefError& error) {
        throw_field_error(location, field_words(error));
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
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.location); });
    for (const auto& item : from.deck.stoppers)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.location); });
    for (const auto& item : from.deck.hooks)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.location); });
    for (const auto& item : from.deck.chasers)
        (void)attempt(from.mistakes, [&] { add(world, item.def, item.location); });
}

}  // namespace hawser::scene
