// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "convert.h"

#include <pybind11/stl.h>

namespace hawser::python {
namespace {

template <class Id>
using HandleClass = py::class_<Handle<Id>>;

/// Return a class of handles with identity and lifetime.
template <class Id>
HandleClass<Id> handle_class(py::module_& module, const char* name, const char* doc) {
    HandleClass<Id> c(module, name, doc);
    c.def_property_readonly(
         "index", [](const Handle<Id>& h) { return h.id.index; }, "Index in the world's arrays.")
        .def_property_readonly(
            "alive", [](const Handle<Id>& h) { return h.alive(); },
            "False after the object has been removed, or its world deleted.")
        .def("__eq__",
             [](const Handle<Id>& a, const py::object& other) {
                 if (!py::isinstance<Handle<Id>>(other)) return false;
                 const auto& b = other.cast<const Handle<Id>&>();
                 return a.id == b.id && !a.box.owner_before(b.box) && !b.box.owner_before(a.box);
             })
        .def("__hash__", [](const Handle<Id>& h) {
            return std::hash<std::int64_t>()((std::int64_t{h.id.generation} << 32) | h.id.index);
        });
    return c;
}

/// Add the property `name` from a function of World and id, and a representation.
template <class Id, class F>
void add_name(HandleClass<Id>& c, F name) {
    c.def_property_readonly(
         "name", [name](const Handle<Id>& h) { return name(h.checked()->read(), h.id); },
         "Name in the world; may be empty.")
        .def("__repr__", [name](const Handle<Id>& h) {
            const std::string kind = std::string("<hawser.") +
                                     static_cast<char>(std::toupper(Kind<Id>::name[0])) +
                                     (Kind<Id>::name + 1);
            if (!h.alive()) return kind + " removed>";
            const std::string text = name(h.checked()->read(), h.id);
            return kind + " " + std::to_string(h.id.index) +
                   (text.empty() ? "" : " \"" + text + "\"") + ">";
        });
}

/// Call a function that changes the world, and update the arrays on its state.
template <class Id, class F>
auto change(const Handle<Id>& h, F&& f) {
    const auto box = h.checked();
    World& world = box->read();
    if constexpr (std::is_void_v<decltype(f(world, h.id))>) {
        f(world, h.id);
        box->refresh_arrays();
    } else {
        auto result = f(world, h.id);
        box->refresh_arrays();
        return result;
    }
}

Quat orientation(py::handle given) {
    const auto q = numbers(given, "orientation", {4});
    return {q.at(0), q.at(1), q.at(2), q.at(3)};
}

py::array_t<double> array_of(const Quat& q) {
    const double values[] = {q.w(), q.x(), q.y(), q.z()};
    return python::array_of(std::span<const double>(values));
}

void bind_body(py::module_& module) {
    using B = Handle<BodyId>;
    auto c = handle_class<BodyId>(module, "Body", "Body of a world.");
    add_name<BodyId>(c, [](World& w, BodyId id) { return w.body_def(id).name; });
    c.def_property_readonly(
         "kind",
         [](const B& b) {
             const BodyKind kind = b.checked()->read().body_def(b.id).kind;
             for (const auto& w : words(kind))
                 if (w.value == kind) return std::string(w.text);
             return std::string();
         },
         "Kind: rigid, lump, scalar, fixed or kinematic.")
        .def_property_readonly(
            "mass", [](const B& b) { return b.checked()->read().body_def(b.id).mass; },
            "Mass as defined [kg]; scalar: [kg] or [kg m²].")
        .def_property_readonly(
            "position",
            [](const B& b) { return python::array_of(b.checked()->read().pose(b.id).position); },
            "Position of the centre of mass, world frame [m]; scalar: the coordinate first.")
        .def_property_readonly(
            "orientation",
            [](const B& b) { return array_of(b.checked()->read().pose(b.id).orientation); },
            "Quaternion w, x, y, z from body frame to world frame.")
        .def_property_readonly(
            "velocity",
            [](const B& b) { return python::array_of(b.checked()->read().velocity(b.id).linear); },
            "Velocity of the centre of mass at time − h/2, world frame [m/s].")
        .def_property_readonly(
            "angular_velocity",
            [](const B& b) { return python::array_of(b.checked()->read().velocity(b.id).angular); },
            "Angular velocity at time − h/2, world frame [rad/s].")
        .def_property_readonly(
            "asleep", [](const B& b) { return b.checked()->read().asleep(b.id); },
            "True if the body sleeps.")
        .def(
            "world_point",
            [](const B& b, py::handle p) {
                return python::array_of(b.checked()->read().world_point(b.id, vector(p, "point")));
            },
            py::arg("point"), "Return the world position of a point in the body's frame [m].")
        .def(
            "local_point",
            [](const B& b, py::handle p) {
                return python::array_of(b.checked()->read().local_point(b.id, vector(p, "point")));
            },
            py::arg("point"), "Return the position in the body's frame of a world point [m].")
        .def(
            "set_pose",
            [](const B& b, py::handle position, py::handle turn) {
                Pose pose = b.checked()->read().pose(b.id);
                pose.position = vector(position, "position");
                if (!turn.is_none()) pose.orientation = orientation(turn);
                change(b, [&](World& w, BodyId id) { w.set_pose(id, pose); });
            },
            py::arg("position"), py::arg("orientation") = py::none(),
            "Move the body between steps: position [m], quaternion w, x, y, z.")
        .def(
            "set_velocity",
            [](const B& b, py::handle linear, py::handle angular) {
                const Twist twist{vector(linear, "linear"), angular.is_none()
                                                                ? Vec3(0.0, 0.0, 0.0)
                                                                : vector(angular, "angular")};
                change(b, [&](World& w, BodyId id) { w.set_velocity(id, twist); });
            },
            py::arg("linear"), py::arg("angular") = py::none(),
            "Set the velocity, world frame [m/s, rad/s].")
        .def(
            "set_force",
            [](const B& b, py::handle force, py::handle torque) {
                const Vec3 f = vector(force, "force");
                const Vec3 t = torque.is_none() ? Vec3(0.0, 0.0, 0.0) : vector(torque, "torque");
                change(b, [&](World& w, BodyId id) { w.set_force(id, f, t); });
            },
            py::arg("force"), py::arg("torque") = py::none(),
            "Replace the applied force and torque, world frame [N, N m].")
        .def(
            "wake", [](const B& b) { change(b, [](World& w, BodyId id) { w.wake(id); }); },
            "Wake the body and its island in the next step.")
        .def(
            "remove",
            [](const B& b) {
                change(b, [](World& w, BodyId id) { static_cast<void>(w.remove_body(id)); });
            },
            "Remove the body with its interactions, shapes and inputs.");
}

void bind_interaction(py::module_& module) {
    using I = Handle<InteractionId>;
    auto c = handle_class<InteractionId>(module, "Interaction", "Interaction of a world.");
    add_name<InteractionId>(c,
                            [](World& w, InteractionId id) { return w.interaction_def(id).name; });
    c.def_property_readonly(
         "kind",
         [](const I& i) { return kind_info(i.checked()->read().interaction_def(i.id).kind).name; },
         "Name of the kind, as in scene files.")
        .def_property_readonly(
            "force", [](const I& i) { return python::array_of(i.checked()->read().force(i.id)); },
            "Force of each row in the last step [N or N m]; a line in tension has force[0] < 0.")
        .def_property_readonly(
            "coordinate", [](const I& i) { return i.checked()->read().coordinate(i.id); },
            "Coordinate of the joint or scalar body [m or rad].")
        .def_property_readonly(
            "speed", [](const I& i) { return i.checked()->read().speed(i.id); },
            "Rate of the coordinate at time − h/2 [m/s or rad/s].")
        .def_property_readonly(
            "motor_force", [](const I& i) { return i.checked()->read().motor_force(i.id); },
            "Force of a motor in the last step [N or N m].")
        .def_property_readonly(
            "intact", [](const I& i) { return i.checked()->read().intact(i.id); },
            "False after an element has broken.")
        .def(
            "get",
            [](const I& i, const std::string& param) {
                return i.checked()->read().interaction_def(i.id).get(param);
            },
            py::arg("param"), "Return a parameter of the kind by its name.")
        .def(
            "part",
            [](const I& i) { change(i, [](World& w, InteractionId id) { w.wires().part(id); }); },
            "Break an element of a wire.")
        .def(
            "release",
            [](const I& i) {
                change(i, [](World& w, InteractionId id) { w.wires().release(id); });
            },
            "Open a pelican hook.")
        .def(
            "remove",
            [](const I& i) {
                change(i, [](World& w, InteractionId id) {
                    static_cast<void>(w.remove_interaction(id));
                });
            },
            "Remove the interaction and its inputs.");
}

py::dict join_result(const std::shared_ptr<WorldBox>& box, const Joint& joint) {
    py::dict made;
    made["wire"] = handle_of(box, joint.wire);
    made["held"] = py::make_tuple(handle_of(box, joint.held[0]), handle_of(box, joint.held[1]));
    made["plate"] = handle_of(box, joint.plate);
    return made;
}

JoinDef gear_of(WorldBox& box, const py::kwargs& given) {
    JoinDef def;
    Reader::read(box, given, "gear", def);
    return def;
}

py::array_t<double> tensions(const Handle<WireId>& w) {
    const auto box = w.checked();
    World& world = box->read();
    const auto elements = world.wires().elements(w.id);
    py::array_t<double> out(static_cast<py::ssize_t>(elements.size()));
    double* const to = out.mutable_data();
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const bool whole = world.alive(elements[i]) && world.intact(elements[i]);
        to[i] = whole ? -world.force(elements[i])[0] : 0.0;
    }
    out.attr("flags").attr("writeable") = false;
    return out;
}

void bind_wire(py::module_& module) {
    using W = Handle<WireId>;
    auto c = handle_class<WireId>(module, "Wire", "Wire of a world.");
    add_name<WireId>(c, [](World& w, WireId id) { return w.wires().name(id); });
    c.def_property_readonly(
         "tension", tensions,
         "Tension of each element in the last step, from the first end [N]; 0: slack or broken.")
        .def(
            "tension_at",
            [](const W& w, double s) { return w.checked()->read().wires().tension(w.id, s); },
            py::arg("s"),
            "Return the tension at the material coordinate s [m] in the last step [N].")
        .def_property_readonly(
            "length", [](const W& w) { return w.checked()->read().wires().length(w.id); },
            "Unstretched length [m].")
        .def_property_readonly(
            "nodes",
            [](const W& w) {
                const auto box = w.checked();
                return handles_of(box, box->read().wires().nodes(w.id));
            },
            "Bodies from end to end, with those that hold the ends.")
        .def_property_readonly(
            "elements",
            [](const W& w) {
                const auto box = w.checked();
                return handles_of(box, box->read().wires().elements(w.id));
            },
            "Elements in order.")
        .def(
            "cut",
            [](const W& w, double s) {
                const WireId piece =
                    change(w, [&](World& of, WireId id) { return of.wires().cut(id, s); });
                return handle_of(w.checked(), piece);
            },
            py::arg("s"), "Cut the wire at the material coordinate s [m]. Return the second piece.")
        .def(
            "part",
            [](const W& w, double s) {
                change(w, [&](World& of, WireId id) { of.wires().part(id, s); });
            },
            py::arg("s"), "Break the element at the material coordinate s [m].")
        .def(
            "join",
            [](const W& w, int end, py::handle other, int other_end, const py::kwargs& gear) {
                const auto box = w.checked();
                const JoinDef def = gear_of(*box, gear);
                const WireId b = find_id<WireId>(*box, other, "other");
                return join_result(box, change(w, [&](World& of, WireId id) {
                                       return of.wires().join(id, end, b, other_end, def);
                                   }));
            },
            py::arg("end"), py::arg("other"), py::arg("other_end"),
            "Join an end (0 or 1) to an end of another wire; keywords: gear, mass, length, ….")
        .def(
            "attach",
            [](const W& w, int end, py::handle body, py::handle point, const py::kwargs& gear) {
                const auto box = w.checked();
                const JoinDef def = gear_of(*box, gear);
                const BodyId to = find_id<BodyId>(*box, body, "body");
                const Vec3 p = vector(point, "point");
                return join_result(box, change(w, [&](World& of, WireId id) {
                                       return of.wires().attach(id, end, to, p, def);
                                   }));
            },
            py::arg("end"), py::arg("body"), py::arg("point"),
            "Attach an end (0 or 1) to a point in a body's frame [m].")
        .def(
            "detach",
            [](const W& w, int end) {
                change(w, [&](World& of, WireId id) { of.wires().detach(id, end); });
            },
            py::arg("end"), "Release an end (0 or 1) from gear or from a body.")
        .def(
            "remove",
            [](const W& w) {
                change(w, [](World& of, WireId id) { static_cast<void>(of.wires().remove(id)); });
            },
            "Remove the wire with its nodes and elements.");
}

void bind_values(py::module_& module) {
    auto input = handle_class<InputId>(module, "Input", "Input of a world.");
    add_name<InputId>(input, [](World& w, InputId id) { return w.input_def(id).name; });
    input
        .def_property(
            "value", [](const Handle<InputId>& h) { return h.checked()->read().input(h.id); },
            [](const Handle<InputId>& h, py::handle value) {
                const double v = number(value, "value");
                change(h, [&](World& w, InputId id) { w.set_input(id, v); });
            },
            "Last value set, or that of the definition; clamped to the range when set.")
        .def_property_readonly(
            "min", [](const Handle<InputId>& h) { return h.checked()->read().input_def(h.id).min; },
            "Lower limit.")
        .def_property_readonly(
            "max", [](const Handle<InputId>& h) { return h.checked()->read().input_def(h.id).max; },
            "Upper limit.")
        .def_property_readonly(
            "unit",
            [](const Handle<InputId>& h) { return h.checked()->read().input_def(h.id).unit; },
            "Unit label.")
        .def(
            "remove",
            [](const Handle<InputId>& h) {
                change(h, [](World& w, InputId id) { static_cast<void>(w.remove_input(id)); });
            },
            "Remove the input; its last value remains.");

    auto output = handle_class<OutputId>(module, "Output", "Output of a world.");
    add_name<OutputId>(output, [](World& w, OutputId id) { return w.output_def(id).name; });
    output
        .def_property_readonly(
            "value", [](const Handle<OutputId>& h) { return h.checked()->read().output(h.id); },
            "Value now, in SI units.")
        .def_property_readonly(
            "unit",
            [](const Handle<OutputId>& h) { return h.checked()->read().output_def(h.id).unit; },
            "Unit label.")
        .def(
            "remove",
            [](const Handle<OutputId>& h) {
                change(h, [](World& w, OutputId id) { w.remove_output(id); });
            },
            "Remove the output.");

    auto shape = handle_class<ShapeId>(module, "Shape", "Collision shape of a world.");
    add_name<ShapeId>(shape, [](World& w, ShapeId id) { return w.shape_def(id).name; });
    shape.def(
        "remove",
        [](const Handle<ShapeId>& h) {
            change(h, [](World& w, ShapeId id) { static_cast<void>(w.remove_shape(id)); });
        },
        "Remove the shape.");
    auto material = handle_class<MaterialId>(module, "Material", "Material of a world.");
    add_name<MaterialId>(material, [](World& w, MaterialId id) { return w.material_def(id).name; });
}

}  // namespace

void bind_handles(py::module_& module) {
    bind_body(module);
    bind_interaction(module);
    bind_wire(module);
    bind_values(module);
}

}  // namespace hawser::python
