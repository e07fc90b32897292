// SPDX-License-Identifier: Apache-2.0
/// Perform the operations of a timeline on a world through its public interface.
#include <hawser/hawser.h>
#include <hawser/timeline.h>

#include "scene/timeline.h"

#include <fmt/format.h>

#include <string>

namespace hawser::scene {
namespace {

WireId wire_named(const World& world, const std::string& name) {
    const WireId id = world.wires().find(name);
    if (!id.valid()) throw DefError("there is no wire '" + name + "' now");
    return id;
}

void set_all(const Operation& operation, World& world) {
    for (const auto& [name, value] : operation.set) {
        if (const InputId id = world.find_input(name); id.valid())
            world.set_input(id, value);
        else
            world.set_system_signal(name, value);
    }
}

const char* end_name(int end) { return end == 0 ? "first" : "last"; }

std::string gear_word(const JoinDef& gear) {
    return gear_words()[static_cast<std::size_t>(gear.gear)] +
           (gear.name.empty() ? std::string() : " " + gear.name);
}

}  // namespace

void perform(const Operation& operation, World& world) {
    switch (operation.kind) {
        case OperationKind::set:
            return set_all(operation, world);
        case OperationKind::cut:
            (void)world.wires().cut(wire_named(world, operation.wire), operation.s);
            return;
        case OperationKind::detach:
            return world.wires().detach(wire_named(world, operation.wire), operation.end);
        case OperationKind::attach: {
            const BodyId body = world.find_body(operation.body);
            if (!body.valid()) throw DefError("there is no body '" + operation.body + "' now");
            (void)world.wires().attach(wire_named(world, operation.wire), operation.end, body,
                                       operation.point, operation.gear);
            return;
        }
        case OperationKind::join:
            (void)world.wires().join(wire_named(world, operation.wire), operation.end,
                                     wire_named(world, operation.other), operation.other_end,
                                     operation.gear);
            return;
        case OperationKind::release: {
            const InteractionId hook = world.find_interaction(operation.interaction);
            if (!hook.valid())
                throw DefError("there is no hook '" + operation.interaction + "' now");
            return world.wires().release(hook);
        }
    }
}

namespace {

std::string what(const Operation& o) {
    switch (o.kind) {
        case OperationKind::set: {
            std::string out = "set";
            for (const auto& [name, value] : o.set)
                out += fmt::format("{} {} = {:.6g}", out == "set" ? "" : ",", name, value);
            return out;
        }
        case OperationKind::cut:
            return fmt::format("cut {} at {:.6g} m", o.wire, o.s);
        case OperationKind::detach:
            return fmt::format("detach the {} end of {}", end_name(o.end), o.wire);
        case OperationKind::attach:
            return fmt::format("attach the {} end of {} to {} ({})", end_name(o.end), o.wire,
                               o.body, gear_word(o.gear));
        case OperationKind::join:
            return fmt::format("join the {} end of {} and the {} end of {} ({})", end_name(o.end),
                               o.wire, end_name(o.other_end), o.other, gear_word(o.gear));
        case OperationKind::release:
            return "release " + o.interaction;
    }
    return "";
}

}  // namespace

std::string to_string(const Operation& o) {
    return o.description.empty() ? what(o) : o.description + ": " + what(o);
}

}  // namespace hawser::scene
