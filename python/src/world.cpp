// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "convert.h"
#include "system.h"

#include <hawser/settings.h>
#include <hawser/structure.h>

#include <pybind11/stl.h>

#include <cstring>

namespace hawser::python {
namespace {

using Box = std::shared_ptr<WorldBox>;

/// Set a member of WorldDef from a Python value.
void set_setting(WorldDef& def, const SettingInfo& info, py::handle value) {
    const std::string field = info.name;
    const auto check = [&](double v) {
        if (!(v >= info.min && v <= info.max))
            throw DefError(field + ": " + std::to_string(v) +
                           " is out of range: " + std::to_string(info.min) + " to " +
                           std::to_string(info.max) + " " + info.unit);
        return v;
    };
    switch (info.type) {
        case SettingType::number:
            return info.set(def, 0, check(number(value, field)));
        case SettingType::integer:
            return info.set(def, 0, check(static_cast<double>(integer(value, field))));
        case SettingType::boolean:
            if (!py::isinstance<py::bool_>(value)) refuse(field, "True or False", value);
            return info.set(def, 0, value.cast<bool>() ? 1.0 : 0.0);
        case SettingType::vector: {
            const Vec3 v = vector(value, field);
            for (int i = 0; i < 3; ++i) info.set(def, i, check(v[i]));
            return;
        }
        case SettingType::word:
            break;
    }
    const std::string word = text(value, field);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < info.words.size(); ++i) {
        if (word == info.words[i]) return info.set(def, 0, static_cast<double>(i));
        names.emplace_back(info.words[i]);
    }
    throw py::value_error(field + ": \"" + word + "\" is none of its values" +
                          nearest(word, names));
}

WorldDef world_def(const py::kwargs& given) {
    WorldDef def;
    std::vector<std::string> names;
    for (const SettingInfo& info : setting_infos()) names.emplace_back(info.name);
    for (const auto& [key, value] : given) {
        const auto name = py::str(key).cast<std::string>();
        const SettingInfo* const info = find_setting(name);
        if (info == nullptr)
            throw py::type_error("World: there is no setting \"" + name + "\"" +
                                 nearest(name, names));
        if (!value.is_none()) set_setting(def, *info, value);
    }
    return def;
}

std::string settings_doc() {
    std::string doc =
        "Bodies, interactions, and the step that moves them.\n\n"
        "`position`, `orientation` and `velocity` are read-only arrays on the memory of the "
        "world.\n"
        "They follow each step, and stay valid after additions and after the world's end.\n\n"
        "Parameters\n----------\n";
    for (const SettingInfo& s : setting_infos()) {
        const char* const types[] = {"float", "int", "bool", "str", "three numbers"};
        doc +=
            std::string(s.name) + " : " + types[static_cast<std::size_t>(s.type)] + ", optional\n";
        doc += std::string("    ") + s.doc +
               (*s.unit != '\0' ? std::string(" [") + s.unit + "]" : "") + "\n";
    }
    return doc;
}

py::dict settings_of(const WorldDef& def) {
    py::dict out;
    for (const SettingInfo& info : setting_infos()) {
        const double value = info.get(def, 0);
        switch (info.type) {
            case SettingType::number:
                out[info.name] = value;
                break;
            case SettingType::integer:
                out[info.name] = static_cast<std::int64_t>(value);
                break;
            case SettingType::boolean:
                out[info.name] = value != 0.0;
                break;
            case SettingType::word:
                out[info.name] = info.words[static_cast<std::size_t>(value)];
                break;
            case SettingType::vector:
                out[info.name] =
                    py::make_tuple(info.get(def, 0), info.get(def, 1), info.get(def, 2));
                break;
        }
    }
    return out;
}

struct ContactRow {
    std::int32_t shape_a, shape_b;
    double point[3], normal[3], gap, force[3];
    std::int32_t sliding, asleep;
};

py::object contacts_of(const std::vector<ContactView>& contacts) {
    py::array_t<ContactRow> out(static_cast<py::ssize_t>(contacts.size()));
    ContactRow* row = out.mutable_data();
    for (const ContactView& c : contacts) {
        *row = {.shape_a = c.shape[0].index,
                .shape_b = c.shape[1].index,
                .point = {c.point[0], c.point[1], c.point[2]},
                .normal = {c.normal[0], c.normal[1], c.normal[2]},
                .gap = c.gap,
                .force = {c.force[0], c.force[1], c.force[2]},
                .sliding = c.sliding ? 1 : 0,
                .asleep = c.asleep ? 1 : 0};
        ++row;
    }
    out.attr("flags").attr("writeable") = false;
    return out;
}

py::dict energy_of(const Energy& e) {
    py::dict out;
    const std::pair<const char*, double> all[] = {
        {"kinetic", e.kinetic},   {"gravity", e.gravity},        {"elastic", e.elastic},
        {"applied", e.applied},   {"driven", e.driven},          {"dissipated", e.dissipated},
        {"friction", e.friction}, {"contact", e.contact},        {"damped", e.damped},
        {"added", e.added},       {"system", e.system},          {"water", e.water},
        {"edited", e.edited},     {"mechanical", e.mechanical()}};
    for (const auto& [name, value] : all) out[name] = value;
    return out;
}

py::dict verdict_of(const Verdict& v) {
    py::dict out;
    out["grade"] = to_string(v.grade);
    out["monitor"] = to_string(v.judge);
    out["value"] = v.of(v.judge).value;
    out["time"] = v.of(v.judge).time;
    out["remedy"] = v.grade == Grade::good ? "" : remedy(v.judge);
    return out;
}

py::dict stats_of(const StepStats& s) {
    py::dict out, stages, events;
    for (int i = 0; i < kStageCount; ++i)
        stages[to_string(static_cast<Stage>(i))] = s.stage_seconds[static_cast<std::size_t>(i)];
    for (int i = 0; i < kEventKindCount; ++i)
        if (const auto n = s.event_count[static_cast<std::size_t>(i)]; n > 0)
            events[to_string(static_cast<EventKind>(i))] = n;
    out["status"] = to_string(s.status);
    out["step"] = s.step;
    out["time"] = s.time;
    out["step_seconds"] = s.step_seconds;
    out["stage_seconds"] = stages;
    out["solver_seconds"] = s.solver_seconds;
    out["solver_cpu_seconds"] = s.solver_cpu_seconds;
    out["momentum_residual"] = s.momentum_residual;
    out["constraint_residual"] = s.constraint_residual;
    out["violation_max"] = s.violation_max;
    out["stretch_error_max"] = s.stretch_error_max;
    out["bodies"] = s.bodies;
    out["asleep"] = s.asleep;
    out["interactions"] = s.interactions;
    out["equations"] = s.equations;
    out["islands"] = s.islands;
    out["contacts"] = s.contacts;
    out["newton_iterations"] = s.newton_iterations;
    out["factorisations"] = s.factorisations;
    out["natural_map"] = s.natural_map;
    out["cut"] = s.cut;
    out["events"] = events;
    return out;
}

template <class Id>
py::object find(const Box& box, const std::string& name) {
    const Id id = Kind<Id>::find(box->read(), name);
    if (!id.valid())
        throw py::key_error(std::string("there is no ") + Kind<Id>::name + " \"" + name + "\"");
    return handle_of(box, id);
}

/// Garbage collection of systems written in Python that refer to their world.
void collect_garbage(PyHeapTypeObject* heap_type) {
    PyTypeObject& type = heap_type->ht_type;
    type.tp_flags |= Py_TPFLAGS_HAVE_GC;
    type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
        Py_VISIT(Py_TYPE(self));
        auto* const instance = reinterpret_cast<py::detail::instance*>(self);
        if (!instance->get_value_and_holder().holder_constructed()) return 0;
        const Box& box = instance->get_value_and_holder().holder<Box>();
        if (box.use_count() > 1) return 0;  // others keep the systems alive
        for (const SystemBridge* const bridge : box->bridges) Py_VISIT(bridge->instance().ptr());
        return 0;
    };
    type.tp_clear = [](PyObject* self) {
        auto* const instance = reinterpret_cast<py::detail::instance*>(self);
        if (!instance->get_value_and_holder().holder_constructed()) return 0;
        const Box& box = instance->get_value_and_holder().holder<Box>();
        for (SystemBridge* const bridge : box->bridges) bridge->drop();
        return 0;
    };
}

std::span<const std::byte> bytes_of(const py::bytes& given) {
    char* data = nullptr;
    py::ssize_t size = 0;
    if (PyBytes_AsStringAndSize(given.ptr(), &data, &size) != 0) throw py::error_already_set();
    return std::as_bytes(std::span(data, static_cast<std::size_t>(size)));
}

void bind_state(WorldClass& c) {
    c.def_property_readonly(
         "position", [](const Box& b) { return b->array(StateArray::position); },
         "Position of the centre of mass of each body by index, world frame [m]: array (n, 3).\n"
         "Scalar bodies: the coordinate first. Read-only, without a copy.")
        .def_property_readonly(
            "orientation", [](const Box& b) { return b->array(StateArray::orientation); },
            "Quaternion w, x, y, z of each body by index, body to world: array (n, 4).")
        .def_property_readonly(
            "velocity", [](const Box& b) { return b->array(StateArray::velocity); },
            "Packed velocities at time − h/2, world frame [m/s, rad/s]: 6 for a rigid body, 3 for\n"
            "a lump, 1 for a scalar body, 0 for others. `velocity_begin` has the first entry of "
            "each.")
        .def_property_readonly(
            "velocity_begin",
            [](const Box& b) {
                const auto at = b->read().state().arrays().velocity_begin;
                return py::array_t<std::int32_t>(static_cast<py::ssize_t>(at.size()), at.data());
            },
            "Index in `velocity` of the first entry of each body; undefined without freedom.")
        .def(
            "contacts", [](const Box& b) { return contacts_of(b->read().contacts()); },
            "Return the contact points of the last step as a structured array: shape_a, shape_b\n"
            "(indices), point [m], normal (from a to b), gap [m], force on b [N], sliding, asleep.")
        .def_property_readonly(
            "time", [](const Box& b) { return b->read().time(); }, "Simulation time [s].")
        .def_property_readonly(
            "step_count", [](const Box& b) { return b->read().step_count(); },
            "Number of steps taken.")
        .def_property_readonly(
            "settings", [](const Box& b) { return settings_of(b->read().settings()); },
            "Settings of the world.")
        .def_property_readonly(
            "stats", [](const Box& b) { return stats_of(b->read().stats()); },
            "Figures of the last step.")
        .def_property_readonly(
            "energy", [](const Box& b) { return energy_of(b->read().energy()); },
            "Energies of the state [J].")
        .def_property_readonly(
            "verdict", [](const Box& b) { return verdict_of(b->read().verdict()); },
            "Worst result of the monitors since the start: grade, monitor, value, time, remedy.")
        .def_property_readonly(
            "state_hash", [](const Box& b) { return b->read().state().hash(); },
            "Hash of the state, equal for any number of threads and after save and restore.")
        .def_property_readonly(
            "motion_hash", [](const Box& b) { return b->read().state().motion_hash(); },
            "Hash of the state without states of systems.")
        .def_property_readonly(
            "identity", [](const Box& b) { return b->read().state().identity(); },
            "Equal for worlds whose states fit each other.")
        .def_property_readonly(
            "memory_bytes", [](const Box& b) { return b->read().solver().memory_bytes(); },
            "Memory of state and solver [bytes].");
}

void bind_objects(WorldClass& c) {
    c.def_property_readonly(
         "bodies", [](const Box& b) { return handles_of(b, b->read().bodies()); }, "All bodies.")
        .def_property_readonly(
            "interactions", [](const Box& b) { return handles_of(b, b->read().interactions()); },
            "All interactions.")
        .def_property_readonly(
            "wires", [](const Box& b) { return handles_of(b, b->read().wires().ids()); },
            "All wires.")
        .def_property_readonly(
            "shapes", [](const Box& b) { return handles_of(b, b->read().shapes()); }, "All shapes.")
        .def_property_readonly(
            "inputs", [](const Box& b) { return handles_of(b, b->read().inputs()); }, "All inputs.")
        .def_property_readonly(
            "outputs", [](const Box& b) { return handles_of(b, b->read().output_ids()); },
            "All outputs.")
        .def_property_readonly(
            "output_values", [](const Box& b) { return array_of(b->read().outputs()); },
            "Values of all outputs by index, in SI units; NaN if removed.")
        .def("body", find<BodyId>, py::arg("name"), "Return the body of a name. Raises KeyError.")
        .def("interaction", find<InteractionId>, py::arg("name"),
             "Return the interaction of a name. Raises KeyError.")
        .def("wire", find<WireId>, py::arg("name"), "Return the wire of a name. Raises KeyError.")
        .def("shape", find<ShapeId>, py::arg("name"),
             "Return the shape of a name. Raises KeyError.")
        .def("material", find<MaterialId>, py::arg("name"),
             "Return the material of a name. Raises KeyError.")
        .def("input", find<InputId>, py::arg("name"),
             "Return the input of a name. Raises KeyError.")
        .def("output", find<OutputId>, py::arg("name"),
             "Return the output of a name. Raises KeyError.")
        .def_property_readonly(
            "systems",
            [](const Box& b) {
                World& w = b->read();
                py::list names;
                for (int i = 0; i < w.system_count(); ++i)
                    names.append(std::string(w.system(i).name()));
                return names;
            },
            "Names of the systems in the order in which they act.")
        .def_property_readonly(
            "signals",
            [](const Box& b) {
                py::dict out;
                for (const SystemSignal& s : b->read().system_signals()) {
                    py::dict one;
                    one["value"] = *s.value;
                    one["unit"] = s.unit;
                    one["input"] = s.input;
                    out[py::str(s.system + "." + s.name)] = one;
                }
                return out;
            },
            "Values, units and directions of the signals of all systems, by \"system.signal\".")
        .def(
            "signal", [](const Box& b, const std::string& n) { return b->read().system_signal(n); },
            py::arg("name"), "Return the value of \"system.signal\".")
        .def(
            "set_signal",
            [](const Box& b, const std::string& n, py::handle value) {
                b->read().set_system_signal(n, number(value, n));
            },
            py::arg("name"), py::arg("value"), "Set the signal \"system.signal\".");
}

void bind_calls(WorldClass& c) {
    c.def(
         "step", [](const Box& b, std::int64_t count) { b->step(count); }, py::arg("count") = 1,
         "Take steps without the interpreter lock.\n\n"
         "Raises\n------\nStepError\n    If a step fails; the state is the last good one.\n"
         "UseError\n    If another thread uses the world.\n"
         "KeyboardInterrupt\n    After Ctrl-C, within 0.1 s; the state is the last good one.")
        .def(
            "cancel", [](const Box& b) { b->cancel(); },
            "Cancel the running step, or else the next one: it raises StepError with status\n"
            "\"cancelled\". Other threads may call it.")
        .def(
            "prepare",
            [](const Box& b) {
                b->read().prepare();
                b->refresh_arrays();
            },
            "Analyse now instead of in the first step.")
        .def(
            "save", [](const Box& b) { return save_state(b->read()); },
            "Return the state with the structure of the world.")
        .def(
            "restore",
            [](const Box& b, const SavedState& state) {
                restore_state(b->read(), state);
                b->refresh_arrays();
            },
            py::arg("state"),
            "Restore a state of this world, or of one of equal set-up. Raises DefError.")
        .def(
            "twin",
            [](const Box& b) {
                auto twin = std::make_shared<WorldBox>(b->read().twin());
                twin->adopt_bridges();
                return twin;
            },
            "Return a world with the same definitions and state.")
        .def(
            "__deepcopy__",
            [](const Box& b, const py::dict&) {
                auto twin = std::make_shared<WorldBox>(b->read().twin());
                twin->adopt_bridges();
                return twin;
            },
            py::arg("memo"), "Return a twin.")
        .def("__reduce__",
             [](const Box&) -> py::object {
                 throw py::type_error(
                     "a World cannot be pickled: pickle a Session of a scene, or its save()");
             })
        .def("__repr__", [](const Box& b) {
            World& w = b->read();
            return "<hawser.World: " + std::to_string(w.bodies().size()) + " bodies, " +
                   std::to_string(w.interactions().size()) +
                   " interactions, t = " + py::str(py::float_(w.time())).cast<std::string>() +
                   " s>";
        });
}

}  // namespace

SavedState save_state(World& world) {
    return {std::make_shared<const Structure>(world.state().structure()), world.state().save(),
            world.state().identity(), world.time()};
}

void restore_state(World& world, const SavedState& state) {
    if (state.structure)
        world.state().restore(*state.structure, state.bytes);
    else
        world.state().restore(state.bytes);
}

WorldClass bind_world(py::module_& module) {
    PYBIND11_NUMPY_DTYPE(ContactRow, shape_a, shape_b, point, normal, gap, force, sliding, asleep);
    py::class_<SavedState>(module, "State",
                           "State of a world. In a file or another process it fits worlds of equal "
                           "structure only.")
        .def_readonly("time", &SavedState::time, "Simulation time [s].")
        .def_readonly("identity", &SavedState::identity, "Identity of its world.")
        .def_property_readonly(
            "data",
            [](const SavedState& s) {
                return py::bytes(reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size());
            },
            "The dynamic state (World::save() of the C++ library).")
        .def(py::pickle(
            [](const SavedState& s) {
                return py::make_tuple(
                    py::bytes(reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size()),
                    s.identity, s.time);
            },
            [](const py::tuple& t) {
                SavedState s;
                const auto data = t[0].cast<py::bytes>();
                const auto bytes = bytes_of(data);
                s.bytes.assign(bytes.begin(), bytes.end());
                s.identity = t[1].cast<std::uint64_t>();
                s.time = t[2].cast<double>();
                return s;
            }));

    static const std::string doc = settings_doc();
    WorldClass c(module, "World", doc.c_str(), py::custom_type_setup(collect_garbage));
    c.def(py::init([](const py::kwargs& settings) {
        return std::make_shared<WorldBox>(World(world_def(settings)));
    }));
    bind_state(c);
    bind_objects(c);
    bind_calls(c);
    return c;
}

}  // namespace hawser::python
