// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "convert.h"

#include <hawser/recording.h>

#include <pybind11/stl.h>

#include <algorithm>

namespace hawser::python {
namespace {

using record::Frame;
using record::Recording;

const char* ending_name(record::Ending ending) {
    constexpr const char* kNames[] = {"finished", "interrupted", "failed", "unknown"};
    return kNames[static_cast<std::size_t>(ending)];
}

/// Call f(index, frame) for all frames.
template <class F>
void for_frames(const Recording& r, F&& f) {
    for (std::size_t i = 0; i < r.frame_count(); ++i) f(static_cast<py::ssize_t>(i), r.frame(i));
}

/// Return time, step and the figures of all frames.
py::dict heads(const Recording& r) {
    const auto n = static_cast<py::ssize_t>(r.frame_count());
    py::array_t<double> time(n), violation(n), residual(n), energy(n), water(n);
    py::array_t<std::int64_t> step(n), branch(n);
    py::array_t<std::uint64_t> hash(n);
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const Frame f = r.frame_head(i);
        const auto k = static_cast<py::ssize_t>(i);
        time.mutable_at(k) = f.time;
        step.mutable_at(k) = f.step;
        branch.mutable_at(k) = static_cast<std::int64_t>(r.take_of(i));
        hash.mutable_at(k) = f.hash;
        violation.mutable_at(k) = f.violation_max;
        residual.mutable_at(k) = f.momentum_residual;
        energy.mutable_at(k) = f.energy;
        water.mutable_at(k) = f.water;
    }
    py::dict out;
    out["time"] = time;
    out["step"] = step;
    out["branch"] = branch;
    out["hash"] = hash;
    out["violation_max"] = violation;
    out["momentum_residual"] = residual;
    out["energy"] = energy;
    out["water"] = water;
    return out;
}

/// Return positions (frames, bodies, 3) and orientations (frames, bodies, 4); NaN if absent.
py::tuple poses(const Recording& r) {
    const auto n = static_cast<py::ssize_t>(r.frame_count());
    const auto bodies = static_cast<py::ssize_t>(r.bodies.size());
    py::array_t<double> x({n, bodies, py::ssize_t{3}}), q({n, bodies, py::ssize_t{4}});
    for_frames(r, [&](py::ssize_t i, const Frame& f) {
        for (py::ssize_t b = 0; b < bodies; ++b) {
            const auto at = static_cast<std::size_t>(b);
            const bool there = at < f.there.size() && f.there[at];
            const Pose pose = at < f.poses.size() ? f.poses[at] : Pose{};
            const double turn[] = {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                                   pose.orientation.z()};
            for (int k = 0; k < 3; ++k) x.mutable_at(i, b, k) = there ? pose.position[k] : kDefault;
            for (int k = 0; k < 4; ++k) q.mutable_at(i, b, k) = there ? turn[k] : kDefault;
        }
    });
    return py::make_tuple(x, q);
}

/// Return the tensions (frames, elements) of the elements that all cables had at the start.
py::array_t<double> tensions(const Recording& r) {
    const auto n = static_cast<py::ssize_t>(r.frame_count());
    py::array_t<double> out({n, static_cast<py::ssize_t>(r.element_count)});
    for_frames(r, [&](py::ssize_t i, const Frame& f) {
        for (py::ssize_t e = 0; e < r.element_count; ++e) {
            const auto at = static_cast<std::size_t>(e);
            out.mutable_at(i, e) = at < f.tensions.size() ? f.tensions[at] : kDefault;
        }
    });
    return out;
}

py::list cables_of(const Recording& r) {
    py::list out;
    for (const record::RecordedCable& c : r.cables) {
        py::dict one;
        one["name"] = c.name;
        one["line_type"] = c.line_type;
        one["EA"] = c.EA;
        one["breaking_load"] = c.breaking_load;
        one["length"] = c.length;
        one["nodes"] = c.nodes;
        one["elements"] = c.elements;
        one["first_element"] = c.first_element;
        out.append(one);
    }
    return out;
}

/// Return the values of the outputs: (frames, outputs); NaN if an output did not exist.
py::array_t<double> outputs(const Recording& r) {
    py::array_t<double> out(
        {static_cast<py::ssize_t>(r.frame_count()), static_cast<py::ssize_t>(r.outputs.size())});
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const std::vector<double> values = r.output_values(i);
        std::copy(values.begin(), values.end(),
                  out.mutable_data() + i * static_cast<std::size_t>(out.shape(1)));
    }
    return out;
}

py::list events_of(const Recording& r, const py::object& type) {
    py::list out;
    for (const record::RecordedEvent& e : r.events)
        out.append(type(e.time, to_string(e.kind), e.where, e.value));
    return out;
}

}  // namespace

void bind_recording(py::module_& module) {
    py::class_<Recording>(module, "Recording", "Recording in memory; see hawser.Recording.")
        .def(py::init([](const std::string& file) { return Recording::open(file); }),
             py::arg("file"))
        .def_readonly("file", &Recording::file, "File name.")
        .def_readonly("scene_name", &Recording::scene_name, "Name of the scene.")
        .def_readonly("scene_text", &Recording::scene_text, "Scene as JSON text.")
        .def_readonly("scene_hash", &Recording::scene_hash, "Hash of the scene's text.")
        .def_readonly("damage", &Recording::damage,
                      "Reason if reading stopped before the end of the file; else \"\".")
        .def_readonly("start_step", &Recording::start_step, "Step number of the start state.")
        .def_readonly("end_step", &Recording::end_step, "Number of the last step.")
        .def_readonly("end_hash", &Recording::end_hash, "Motion hash at the end.")
        .def_property_readonly(
            "ending", [](const Recording& r) { return ending_name(r.ending); },
            "finished, interrupted, failed or unknown.")
        .def_property_readonly(
            "step", [](const Recording& r) { return r.settings.step; }, "Time step [s].")
        .def_property_readonly(
            "every", [](const Recording& r) { return r.settings.stride; }, "Steps between frames.")
        .def_property_readonly(
            "version", [](const Recording& r) { return r.settings.version; },
            "Version of the library that wrote it.")
        .def_property_readonly(
            "body_names",
            [](const Recording& r) {
                std::vector<std::string> names;
                for (const auto& body : r.bodies) names.push_back(body.name);
                return names;
            },
            "Names of the bodies by index.")
        .def_property_readonly(
            "output_names",
            [](const Recording& r) {
                std::vector<std::string> names;
                for (const auto& output : r.outputs) names.push_back(output.name);
                return names;
            },
            "Names of outputs and signals; empty in recordings of earlier versions.")
        .def_property_readonly(
            "output_units",
            [](const Recording& r) {
                std::vector<std::string> units;
                for (const auto& output : r.outputs) units.push_back(output.unit);
                return units;
            },
            "Units of `output_names`.")
        .def_property_readonly("cables", cables_of, "Cables of the start, as dicts.")
        .def("_heads", heads)
        .def("_poses", poses)
        .def("_tensions", tensions)
        .def("_outputs", outputs)
        .def("_events", events_of, py::arg("type"))
        .def("__len__", &Recording::frame_count);
}

}  // namespace hawser::python
