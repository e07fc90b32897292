// SPDX-License-Identifier: Apache-2.0
#include "system.h"

#include "convert.h"

#include <algorithm>
#include <limits>

namespace hawser::python {

SystemCore::Signal& SystemCore::signal(const std::string& wanted) {
    std::vector<std::string> names;
    for (Signal& s : signals) {
        if (s.name == wanted) return s;
        names.push_back(s.name);
    }
    throw py::key_error(name + ": there is no signal \"" + wanted + "\"" + nearest(wanted, names));
}

Prestep& StepView::get() const {
    if (now == nullptr) throw UseError("the step has ended: use it within prestep() only");
    return *now;
}
Loads& LoadsView::get() const {
    if (loads == nullptr) throw UseError("the step has ended: use loads within prestep() only");
    return *loads;
}
WorldBox& LoadsView::of() const { return *box.lock(); }

SystemBridge::SystemBridge(py::object instance, std::shared_ptr<SystemCore> core)
    : instance_(std::move(instance)), core_(std::move(core)) {
    if (core_->bridge != nullptr)
        throw DefError("system \"" + core_->name + "\" already acts on a world");
    core_->bridge = this;
    step_object_ = py::cast(step_);
    loads_object_ = py::cast(loads_);
}

SystemBridge::~SystemBridge() {
    const py::gil_scoped_acquire gil;
    core_->bridge = nullptr;
    if (box_ != nullptr) std::erase(box_->bridges, this);
    instance_ = step_object_ = loads_object_ = call_ = py::object();
}

void SystemBridge::enter(WorldBox& box) {
    if (box_ == &box) return;
    box_ = &box;
    step_->box = loads_->box = box.weak_from_this();
    box.bridges.push_back(this);
}

void SystemBridge::prestep(Prestep& now, Loads& loads) noexcept {
    const py::gil_scoped_acquire gil;
    if (!instance_ || box_ == nullptr) return;
    step_->now = &now;
    loads_->loads = &loads;
    const auto fail = [&](py::error_already_set error) {
        box_->fail(std::move(error));
        now.set_input(InputId{}, std::numeric_limits<double>::quiet_NaN());  // the step fails
    };
    try {
        instance_.attr("prestep")(step_object_, loads_object_);
    } catch (py::error_already_set& error) {
        fail(error);
    } catch (const std::exception& error) {
        PyErr_SetString(PyExc_RuntimeError, error.what());
        fail(py::error_already_set());
    }
    step_->now = nullptr;
    loads_->loads = nullptr;
}

void SystemBridge::visit_state(StateVisitor& visitor) {
    for (SystemCore::Signal& s : core_->signals) visitor.visit(s.value);
    visitor.visit(std::span(core_->state));
}

void SystemBridge::signals(SignalTable& table) {
    for (SystemCore::Signal& s : core_->signals) {
        if (s.input)
            table.input(s.name, s.unit, s.value, s.min, s.max);
        else
            table.output(s.name, s.unit, s.value);
    }
}

void SystemBridge::holds(HoldTable& table) const {
    const py::gil_scoped_acquire gil;
    if (!instance_ || !py::hasattr(instance_, "holds")) return;
    for (const py::handle held : instance_.attr("holds")()) {
        if (py::isinstance<Handle<BodyId>>(held))
            table.hold(held.cast<Handle<BodyId>>().id);
        else if (py::isinstance<Handle<InteractionId>>(held))
            table.hold(held.cast<Handle<InteractionId>>().id);
        else if (py::isinstance<Handle<ShapeId>>(held))
            table.hold(held.cast<Handle<ShapeId>>().id);
        else if (py::isinstance<Handle<InputId>>(held))
            table.hold(held.cast<Handle<InputId>>().id);
        else
            refuse("holds()", "handles of bodies, interactions, shapes or inputs", held);
    }
}

std::unique_ptr<System> SystemBridge::clone() const {
    const py::gil_scoped_acquire gil;
    if (!instance_ || !py::hasattr(instance_, "clone")) return nullptr;
    py::object copy = instance_.attr("clone")();
    if (!py::isinstance<SystemCore>(copy)) refuse("clone()", "a hawser.System", copy);
    auto core = copy.cast<std::shared_ptr<SystemCore>>();
    return std::make_unique<SystemBridge>(std::move(copy), std::move(core));
}

namespace {

/// Return a square matrix of up to six rows.
Eigen::MatrixXd matrix(py::handle given, const std::string& field) {
    const auto a = numbers(given, field, {-1, -1});
    if (a.shape(0) != a.shape(1) || a.shape(0) > 6)
        throw py::value_error(field + ": expected a square matrix of up to 6 rows, got shape (" +
                              std::to_string(a.shape(0)) + ", " + std::to_string(a.shape(1)) + ")");
    Eigen::MatrixXd out(a.shape(0), a.shape(1));
    for (py::ssize_t i = 0; i < a.shape(0); ++i)
        for (py::ssize_t j = 0; j < a.shape(1); ++j) out(i, j) = a.at(i, j);
    return out;
}

BodyId body_of(const LoadsView& view, py::handle body) {
    return find_id<BodyId>(view.of(), body, "body");
}

}  // namespace

static void bind_step(py::module_& module) {
    py::class_<StepView, std::shared_ptr<StepView>>(
        module, "Step", "The step that begins; valid within System.prestep() only.")
        .def_property_readonly(
            "time", [](const StepView& v) { return v.get().time; }, "Start of the step [s].")
        .def_property_readonly(
            "step", [](const StepView& v) { return v.get().step; }, "Time step h [s].")
        .def_property_readonly(
            "count", [](const StepView& v) { return v.get().count; }, "Number of steps taken.")
        .def_property_readonly(
            "world",
            [](const StepView& v) {
                static_cast<void>(v.get());
                return v.box.lock();
            },
            "The world before the step, for reading.")
        .def(
            "set_input",
            [](const StepView& v, py::handle input, py::handle value) {
                const InputId id = find_id<InputId>(*v.box.lock(), input, "input");
                v.get().set_input(id, number(value, "value"));
            },
            py::arg("input"), py::arg("value"), "Set an input of the world for this step.")
        .def(
            "remove_body",
            [](const StepView& v, py::handle body) {
                v.get().edits.remove_body(find_id<BodyId>(*v.box.lock(), body, "body"));
            },
            py::arg("body"), "Remove a body in this step.")
        .def(
            "remove_interaction",
            [](const StepView& v, py::handle it) {
                v.get().edits.remove_interaction(
                    find_id<InteractionId>(*v.box.lock(), it, "interaction"));
            },
            py::arg("interaction"), "Remove an interaction in this step.")
        .def(
            "part",
            [](const StepView& v, py::handle it) {
                v.get().edits.part(find_id<InteractionId>(*v.box.lock(), it, "interaction"));
            },
            py::arg("interaction"), "Break an element of a wire in this step.");

    py::class_<LoadsView, std::shared_ptr<LoadsView>>(
        module, "Loads",
        "Loads of systems in one step: f − A v̇ − D v − K (x − x_k). The step treats the matrices\n"
        "A, D and K implicitly; they are symmetric and positive semi-definite.")
        .def(
            "add_force",
            [](const LoadsView& v, py::handle body, py::handle force, py::handle torque) {
                v.get().add_force(body_of(v, body), vector(force, "force"),
                                  torque.is_none() ? Vec3::Zero() : vector(torque, "torque"));
            },
            py::arg("body"), py::arg("force"), py::arg("torque") = py::none(),
            "Add a force at the centre of mass and a torque, world frame [N, N m].")
        .def(
            "add_mass",
            [](const LoadsView& v, py::handle body, py::handle a) {
                v.get().add_mass(body_of(v, body), matrix(a, "mass"));
            },
            py::arg("body"), py::arg("matrix"), "Add added mass A [kg, kg m, kg m²].")
        .def(
            "add_damping",
            [](const LoadsView& v, py::handle body, py::handle d) {
                v.get().add_damping(body_of(v, body), matrix(d, "damping"));
            },
            py::arg("body"), py::arg("matrix"), "Add damping D [N s/m, N s, N m s].")
        .def(
            "add_stiffness",
            [](const LoadsView& v, py::handle body, py::handle k) {
                v.get().add_stiffness(body_of(v, body), matrix(k, "stiffness"));
            },
            py::arg("body"), py::arg("matrix"), "Add stiffness K [N/m, N, N m].");
}

void bind_systems(py::module_& module) {
    bind_step(module);
    const auto add = [](SystemCore& core, SystemCore::Signal signal) {
        if (core.bridge != nullptr)
            throw DefError("system \"" + core.name + "\": add signals before World.add_system()");
        for (const auto& s : core.signals)
            if (s.name == signal.name)
                throw DefError("system \"" + core.name + "\": the signal \"" + signal.name +
                               "\" exists already");
        core.signals.push_back(std::move(signal));
    };
    py::class_<SystemCore, std::shared_ptr<SystemCore>>(
        module, "System",
        "Component that acts on a world at the start of each step. Derive from it, call\n"
        "``super().__init__(name)``, and define ``prestep(self, step, loads)``.\n\n"
        "An exception in prestep() makes the step fail without effect, and World.step() raises "
        "it.\n"
        "Later steps may depend on values in `state` and signals only: these are saved, restored,\n"
        "hashed, and undone if a step fails.\n\n"
        "Optional methods: ``holds()`` returns handles of objects that must not be removed.\n"
        "``clone()`` returns a system of the same definition, for World.twin().\n\n"
        "Parameters\n----------\nname : str\n    Unique name among the systems of a world.\n"
        "state : int\n    Number of values in `state`.")
        .def(py::init([](const std::string& name, std::int64_t state) {
                 if (state < 0) throw py::value_error("state: the number of values must be >= 0");
                 return std::make_shared<SystemCore>(name, static_cast<std::size_t>(state));
             }),
             py::arg("name"), py::arg("state") = 0)
        .def_readonly("name", &SystemCore::name, "Name of the system.")
        .def_property_readonly(
            "state",
            [](py::object self) {
                auto& core = self.cast<SystemCore&>();
                return py::array_t<double>(static_cast<py::ssize_t>(core.state.size()),
                                           core.state.data(), self);
            },
            "Numbers on which later steps depend, as a writable array.")
        .def(
            "add_input",
            [add](SystemCore& core, const std::string& name, const std::string& unit, double value,
                  double min, double max) { add(core, {name, unit, value, true, min, max}); },
            py::arg("name"), py::arg("unit") = "", py::arg("value") = 0.0, py::arg("min") = -1e300,
            py::arg("max") = 1e300,
            "Add a signal that may be set between steps as \"system.signal\".")
        .def(
            "add_output",
            [add](SystemCore& core, const std::string& name, const std::string& unit) {
                add(core, {name, unit});
            },
            py::arg("name"), py::arg("unit") = "",
            "Add a signal that others read as \"system.signal\".")
        .def(
            "prestep",
            [](const SystemCore& core, const py::args&) {
                throw py::type_error("system \"" + core.name + "\" must define prestep()");
            },
            "Apply loads and inputs of the step that begins.")
        .def(
            "__getitem__",
            [](SystemCore& core, const std::string& name) { return core.signal(name).value; },
            py::arg("name"), "Return the value of a signal.")
        .def(
            "__setitem__",
            [](SystemCore& core, const std::string& name, py::handle value) {
                core.signal(name).value = number(value, core.name + "." + name);
            },
            py::arg("name"), py::arg("value"), "Set the value of a signal.");
}

}  // namespace hawser::python
