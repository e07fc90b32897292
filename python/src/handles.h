// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file handles.h
/// Handles of bodies, interactions and other objects. A handle does not keep its world alive, so
/// that systems written in Python may store handles without a reference cycle.

#include "box.h"

#include <memory>
#include <string>

namespace hawser::python {

/// Name of the kind of object for messages, and its lookup by name.
template <class Id>
struct Kind;
template <>
struct Kind<BodyId> {
    static constexpr const char* name = "body";
    static BodyId find(World& w, const std::string& n) { return w.find_body(n); }
    static bool alive(World& w, BodyId id) { return w.alive(id); }
};
template <>
struct Kind<InteractionId> {
    static constexpr const char* name = "interaction";
    static InteractionId find(World& w, const std::string& n) { return w.find_interaction(n); }
    static bool alive(World& w, InteractionId id) { return w.alive(id); }
};
template <>
struct Kind<InputId> {
    static constexpr const char* name = "input";
    static InputId find(World& w, const std::string& n) { return w.find_input(n); }
    static bool alive(World& w, InputId id) { return w.alive(id); }
};
template <>
struct Kind<OutputId> {
    static constexpr const char* name = "output";
    static OutputId find(World& w, const std::string& n) { return w.find_output(n); }
    static bool alive(World& w, OutputId id) { return w.alive(id); }
};
template <>
struct Kind<ShapeId> {
    static constexpr const char* name = "shape";
    static ShapeId find(World& w, const std::string& n) { return w.find_shape(n); }
    static bool alive(World& w, ShapeId id) { return w.alive(id); }
};
template <>
struct Kind<MaterialId> {
    static constexpr const char* name = "material";
    static MaterialId find(World& w, const std::string& n) { return w.find_material(n); }
    static bool alive(World& w, MaterialId id) { return id.index < w.material_count(); }
};
template <>
struct Kind<WireId> {
    static constexpr const char* name = "wire";
    static WireId find(World& w, const std::string& n) { return w.wires().find(n); }
    static bool alive(World& w, WireId id) { return w.alive(id); }
};

template <class Id>
struct Handle {
    std::weak_ptr<WorldBox> box;
    Id id;

    /// Return the box of an existing object.
    /// @throws ObjectRemoved, UseError.
    [[nodiscard]] std::shared_ptr<WorldBox> checked() const {
        std::shared_ptr<WorldBox> of = box.lock();
        if (!of)
            throw ObjectRemoved(std::string("the world of this ") + Kind<Id>::name +
                                " does not exist any more");
        if (!Kind<Id>::alive(of->read(), id))
            throw ObjectRemoved(std::string("this ") + Kind<Id>::name + " has been removed");
        return of;
    }
    [[nodiscard]] bool alive() const {
        const auto of = box.lock();
        return of && Kind<Id>::alive(of->read(), id);
    }
};

}  // namespace hawser::python
