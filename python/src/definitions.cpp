// SPDX-License-Identifier: Apache-2.0
#include "bindings.h"
#include "convert.h"
#include "system.h"

#include <algorithm>
#include <string_view>
#include <type_traits>

namespace hawser::python {
namespace {

using Box = std::shared_ptr<WorldBox>;

/// Add a method that reads a definition and passes it to a function of World.
template <class Def, class F>
void method(WorldClass& c, const char* name, const char* doc, F add) {
    const std::string path = std::string(name).substr(std::string_view("add_").size());
    c.def(
        name,
        [add, path](const Box& box, const py::kwargs& given) {
            if (given.contains("from_")) {  // `from` is a keyword of Python
                given["from"] = given["from_"];
                given.attr("pop")("from_");
            }
            Def def;
            Reader::read(*box, given, path, def);
            World& world = box->read();
            if constexpr (std::is_void_v<decltype(add(world, def))>) {
                add(world, def);
                box->refresh_arrays();
            } else {
                auto result = add(world, def);
                box->refresh_arrays();
                return ResultWriter(box).write(result);
            }
        },
        doc);
}

/// Add a method for a definition of World::add().
template <class Def>
void defined(WorldClass& c, const char* name, const char* doc) {
    method<Def>(c, name, doc, [](World& w, const Def& d) { return w.add(d); });
}

py::object add_interaction(const Box& box, const std::string& kind, const py::sequence& bodies,
                           const py::kwargs& given) {
    const KindInfo* const info = find_kind(kind);
    if (info == nullptr) {
        std::vector<std::string> names;
        for (const KindInfo& k : interaction_kinds()) names.emplace_back(k.name);
        throw py::value_error("kind: there is no interaction \"" + kind + "\"" +
                              nearest(kind, names));
    }
    InteractionDef def;
    def.kind = info->kind;
    if (static_cast<int>(py::len(bodies)) != info->bodies)
        throw py::value_error("bodies: a " + kind + " has " + std::to_string(info->bodies) +
                              " bodies, got " + std::to_string(py::len(bodies)));
    for (std::size_t i = 0; i < py::len(bodies); ++i)
        def.body[i] = find_id<BodyId>(*box, py::object(bodies[i]), "bodies");
    std::vector<std::string> known{"name",       "points",       "frames",
                                   "compliance", "damping_time", "loads"};
    for (const ParamInfo& p : info->params) known.emplace_back(p.name);
    for (const auto& [key, value] : given) {
        const auto field = py::str(key).cast<std::string>();
        if (value.is_none()) continue;
        if (field == "name") {
            def.name = text(value, field);
        } else if (field == "points") {
            const auto a = numbers(value, field, {info->bodies, 3});
            for (int i = 0; i < info->bodies; ++i)
                def.point[static_cast<std::size_t>(i)] = {a.at(i, 0), a.at(i, 1), a.at(i, 2)};
        } else if (field == "frames") {
            const auto a = numbers(value, field, {info->bodies, 4});
            for (int i = 0; i < info->bodies; ++i)
                def.frame[static_cast<std::size_t>(i)] =
                    Quat(a.at(i, 0), a.at(i, 1), a.at(i, 2), a.at(i, 3));
        } else if (field == "compliance" || field == "damping_time") {
            const auto a = numbers(value, field, {info->rows});
            auto& to = field == "compliance" ? def.compliance : def.damping_time;
            std::copy_n(a.data(), info->rows, to.begin());
        } else if (field == "loads") {
            std::size_t i = 0;
            for (const py::handle load : value) {
                if (i >= def.load.size()) throw py::value_error("loads: at most two");
                Reader::read(*box, load.cast<py::dict>(), field, def.load[i++]);
            }
        } else if (std::find(known.begin(), known.end(), field) == known.end()) {
            throw py::type_error("interaction: " + kind + " has no field \"" + field + "\"" +
                                 nearest(field, known));
        } else {
            def.set(field, number(value, field));
        }
    }
    World& world = box->read();
    const InteractionId id = world.add_interaction(def);
    box->refresh_arrays();
    return handle_of(box, id);
}

py::object add_system(const Box& box, py::object instance) {
    if (!py::isinstance<SystemCore>(instance))
        refuse("system", "an instance of a class derived from hawser.System", instance);
    auto core = instance.cast<std::shared_ptr<SystemCore>>();
    World& world = box->read();
    auto bridge = std::make_unique<SystemBridge>(instance, std::move(core));
    SystemBridge& added = *bridge;
    world.add_system(std::move(bridge));
    added.enter(*box);
    return instance;
}

}  // namespace

void bind_definitions(WorldClass& c) {
    method<BodyDef>(c, "add_body", doc_add_body,
                    [](World& w, const BodyDef& d) { return w.add_body(d); });
    method<InputDef>(c, "add_input", doc_add_input,
                     [](World& w, const InputDef& d) { return w.add_input(d); });
    method<OutputDef>(c, "add_output", doc_add_output,
                      [](World& w, const OutputDef& d) { return w.add_output(d); });
    method<MaterialDef>(c, "add_material", doc_add_material,
                        [](World& w, const MaterialDef& d) { return w.add_material(d); });
    method<MaterialPairDef>(c, "add_material_pair", doc_add_material_pair,
                            [](World& w, const MaterialPairDef& d) { w.add_material_pair(d); });
    method<ShapeDef>(c, "add_shape", doc_add_shape,
                     [](World& w, const ShapeDef& d) { return w.add_shape(d); });
    method<WireDef>(c, "add_wire", doc_add_wire,
                    [](World& w, const WireDef& d) { return w.wires().add(d); });
    defined<HingeDef>(c, "add_hinge", doc_add_hinge);
    defined<PrismaticDef>(c, "add_prismatic", doc_add_prismatic);
    defined<CylindricalDef>(c, "add_cylindrical", doc_add_cylindrical);
    defined<UniversalDef>(c, "add_universal", doc_add_universal);
    defined<BallDef>(c, "add_ball", doc_add_ball);
    defined<LockDef>(c, "add_lock", doc_add_lock);
    defined<GearDef>(c, "add_gear", doc_add_gear);
    defined<DistanceDef>(c, "add_distance", doc_add_distance);
    defined<StretchDef>(c, "add_stretch", doc_add_stretch);
    defined<WinchStretchDef>(c, "add_winch_stretch", doc_add_winch_stretch);
    defined<BendDef>(c, "add_bend", doc_add_bend);
    defined<TwistDef>(c, "add_twist", doc_add_twist);
    defined<HydrostaticDef>(c, "add_hydrostatic", doc_add_hydrostatic);
    defined<DrumDef>(c, "add_drum", doc_add_drum);
    defined<WinchDef>(c, "add_winch", doc_add_winch);
    defined<KnuckleCraneDef>(c, "add_knuckle_crane", doc_add_knuckle_crane);
    defined<LatticeCraneDef>(c, "add_lattice_crane", doc_add_lattice_crane);
    method<SeaDef>(c, "add_sea", doc_add_sea,
                   [](World& w, const SeaDef& d) { static_cast<void>(w.add(d)); });
    c.def("add_interaction", add_interaction, py::arg("kind"), py::arg("bodies"),
          "Add an interaction of any kind.\n\n"
          "Parameters\n----------\nkind : str\n    Name of the kind, as in scene files.\n"
          "bodies : list of Body or name\n    Bodies in the kind's order.\n"
          "name : str, optional\npoints : array (bodies, 3), optional\n"
          "    Attachment points in the bodies' frames [m].\n"
          "frames : array (bodies, 4), optional\n"
          "    Quaternions w, x, y, z of the joint frame in the bodies' frames.\n"
          "compliance, damping_time : array (rows,), optional\n    [m/N or rad/(N m)], [s].\n"
          "loads : list of dict, optional\n    Loads of friction: interaction, factor.\n"
          "**params : float\n    Parameters of the kind.\n\nReturns\n-------\nInteraction");
    c.def("add_system", add_system, py::arg("system"),
          "Add a hawser.System, which acts from the next step on after the others.\n\n"
          "Parameters\n----------\nsystem : System\n\nReturns\n-------\nSystem\n    The same.");
    c.def(
        "remove_system",
        [](const Box& box, py::handle system) {
            World& world = box->read();
            auto* const core = system.cast<SystemCore*>();
            if (core->bridge == nullptr) throw DefError("this system acts on no world");
            static_cast<void>(world.remove_system(*core->bridge));
        },
        py::arg("system"), "Remove a hawser.System.");
}

}  // namespace hawser::python
