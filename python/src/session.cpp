// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "convert.h"

#include <hawser/structure.h>

#include <pybind11/stl.h>

namespace hawser::python {
namespace {

using Box = std::shared_ptr<WorldBox>;

/// A session, as seen from Python. It shares the box with its World object.
struct SessionFace {
    Box box;
};

scene::Options options_of(const py::kwargs& given) {
    scene::Options options;
    for (const auto& [key, value] : given) {
        const auto name = py::str(key).cast<std::string>();
        if (value.is_none()) continue;
        if (name == "set")
            for (const py::handle entry : value) options.set.push_back(text(entry, name));
        else if (name == "threads")
            options.threads = static_cast<int>(integer(value, name));
        else if (name == "scale")
            options.scale = static_cast<int>(integer(value, name));
        else if (name == "step")
            options.step = number(value, name);
        else if (name == "budget")
            options.budget = number(value, name);
        else if (name == "budget_work")
            options.budget_work = number(value, name);
        else if (name == "operations")
            options.operations = text(py::str(value), name);
        else
            throw py::type_error("load: there is no option \"" + name + "\"" +
                                 nearest(name, {"set", "threads", "scale", "step", "budget",
                                                "budget_work", "operations", "control", "restore",
                                                "record", "csv", "every", "verify"}));
    }
    return options;
}

/// Start a session of a scene file, or of a text with a name for messages.
std::unique_ptr<SessionFace> start(const std::string& file, const std::string& scene_text,
                                   const std::string& control, const std::string& restore,
                                   const std::string& record, const std::string& csv,
                                   std::int32_t every, bool verify, const py::kwargs& given) {
    const scene::Options options = options_of(given);
    std::unique_ptr<Session> session;
    {
        const py::gil_scoped_release release;
        scene::Scene scene = scene_text.empty() ? scene::load_file(file, options)
                                                : scene::load_text(scene_text, file, options);
        session = std::make_unique<Session>(std::move(scene), SessionDef{.restore = restore,
                                                                         .control = control,
                                                                         .record = record,
                                                                         .csv = csv,
                                                                         .every = every,
                                                                         .verify = verify});
    }
    return std::make_unique<SessionFace>(
        SessionFace{std::make_shared<WorldBox>(std::move(session))});
}

py::list signal_inputs(const scene::Scene& scene) {
    py::list out;
    for (const scene::SignalInput& s : scene.signal_inputs) {
        py::dict one;
        one["name"] = s.name;
        one["signal"] = s.signal;
        one["factor"] = s.factor;
        one["min"] = s.min;
        one["max"] = s.max;
        one["unit"] = s.unit;
        out.append(one);
    }
    return out;
}

py::list cables(const scene::Scene& scene, const Box& box) {
    py::list out;
    for (const scene::Cable& cable : scene.cables) {
        py::dict one;
        one["name"] = cable.name;
        one["line_type"] = cable.line_type;
        one["length"] = cable.length;
        one["EA"] = cable.EA;
        one["breaking_load"] = cable.breaking_load;
        one["nodes"] = handles_of(box, cable.nodes);
        one["elements"] = handles_of(box, cable.stretch);
        out.append(one);
    }
    return out;
}

py::object event_of(const Box& box, const Event& e, const py::object& type) {
    World& w = box->read();
    std::string where;
    if (e.interaction.valid() && w.alive(e.interaction))
        where = w.interaction_def(e.interaction).name;
    else if (e.body.valid() && w.alive(e.body))
        where = w.body_def(e.body).name;
    else if (e.input.valid() && w.alive(e.input))
        where = w.input_def(e.input).name;
    return type(e.time, to_string(e.kind), where, e.value);
}

const char* ending_name(record::Ending ending) {
    switch (ending) {
        case record::Ending::finished:
            return "finished";
        case record::Ending::interrupted:
            return "interrupted";
        case record::Ending::failed:
            return "failed";
        case record::Ending::unknown:
            break;
    }
    return "unknown";
}

using SessionClass = py::class_<SessionFace>;

void bind_reading(SessionClass& c) {
    const auto scene = [](const SessionFace& s) -> const scene::Scene& {
        return s.box->session().scene();
    };
    c.def_property_readonly(
         "world", [](const SessionFace& s) { return s.box; }, "The world of the session.")
        .def_property_readonly(
            "time", [](const SessionFace& s) { return s.box->session().time(); },
            "Simulation time [s].")
        .def_property_readonly(
            "name", [scene](const SessionFace& s) { return scene(s).name; }, "Name of the scene.")
        .def_property_readonly(
            "description", [scene](const SessionFace& s) { return scene(s).description; },
            "Description of the scene.")
        .def_property_readonly(
            "path", [scene](const SessionFace& s) { return scene(s).path; }, "Scene file.")
        .def_property_readonly(
            "scene_text", [scene](const SessionFace& s) { return scene(s).text; },
            "Self-contained JSON document of the scene, with options applied.")
        .def_property_readonly(
            "scene_hash", [scene](const SessionFace& s) { return scene(s).hash; },
            "Hash of `scene_text`.")
        .def_property_readonly(
            "duration", [scene](const SessionFace& s) { return scene(s).duration; },
            "Duration of the run according to the scene [s].")
        .def_property_readonly(
            "cables", [scene](const SessionFace& s) { return cables(scene(s), s.box); },
            "Cables of the scene with nodes and elements.")
        .def_property_readonly("_signal_inputs",
                               [scene](const SessionFace& s) { return signal_inputs(scene(s)); })
        .def(
            "_events",
            [](const SessionFace& s, const py::object& type) {
                py::list out;
                static_cast<void>(s.box->session());
                for (const Event& e : s.box->events()) out.append(event_of(s.box, e, type));
                return out;
            },
            py::arg("type"))
        .def_property_readonly(
            "differences",
            [](const SessionFace& s) {
                const auto all = s.box->session().differences();
                return std::vector<std::string>(all.begin(), all.end());
            },
            "Numbers that differ from the scene of the restored state.");
}

}  // namespace

void bind_session(py::module_& module) {
    SessionClass c(module, "Session", "Run of a scene; see hawser.Session.");
    c.def(py::init(&start), py::arg("file") = "", py::arg("scene_text") = "",
          py::arg("control") = "", py::arg("restore") = "", py::arg("record") = "",
          py::arg("csv") = "", py::arg("every") = 1, py::arg("verify") = false);
    bind_reading(c);
    c.def(
         "_step",
         [](const SessionFace& s, std::int64_t count) {
             static_cast<void>(s.box->session());
             s.box->step(count);
         },
         py::arg("count") = 1)
        .def(
            "set_input",
            [](const SessionFace& s, const std::string& name, py::handle value) {
                s.box->session().set_input(name, number(value, name));
            },
            py::arg("name"), py::arg("value"),
            "Set an input from the next step on. Raises DefError with the nearest name.")
        .def("_save", [](const SessionFace& s) { return save_state(s.box->session().world()); })
        .def(
            "_save_file",
            [](const SessionFace& s, const std::string& file) { s.box->session().save(file); },
            py::arg("file"))
        .def(
            "_restore",
            [](const SessionFace& s, const SavedState& state) {
                Session& session = s.box->session();
                if (state.structure)
                    session.restore(*state.structure, state.bytes);
                else
                    session.restore(session.world().state().structure(), state.bytes);
                s.box->events().clear();
                s.box->refresh_arrays();
            },
            py::arg("state"))
        .def(
            "record",
            [](const SessionFace& s, const py::object& file, std::int32_t every) {
                s.box->session().record(text(py::str(file), "file"), every);
                s.box->refresh_arrays();
            },
            py::arg("file"), py::arg("every") = 1,
            "Start a recording at the present state.\n\n"
            "Parameters\n----------\nfile : path\nevery : int\n    Steps between frames.")
        .def(
            "write_csv",
            [](const SessionFace& s, const py::object& file, std::int32_t every) {
                s.box->session().write_csv(text(py::str(file), "file"), every);
            },
            py::arg("file"), py::arg("every") = 1, "Write tensions and motions over time.")
        .def(
            "finish",
            [](const SessionFace& s, bool interrupted) {
                return ending_name(s.box->session().finish(interrupted));
            },
            py::arg("interrupted") = false,
            "Close the files. Return \"finished\", \"interrupted\" or \"failed\".")
        .def(
            "cancel", [](const SessionFace& s) { s.box->cancel(); },
            "Cancel the running step, or else the next one. Other threads may call it.");
}

}  // namespace hawser::python
