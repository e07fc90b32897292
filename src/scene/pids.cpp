// SPDX-License-Identifier: Apache-2.0
/// Section "pids": controllers of a force (hawser/systems/pid.h). The worked example of a section.
#include "scene/sections.h"

#include <hawser/systems/pid.h>

#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>

namespace hawser::scene {
namespace {

constexpr double kPidAny = 1e30;
constexpr FieldInfo<PidDef> kPidNumbers[] = {
    {"sign", &PidDef::sign, "1", "-1", "Sign of the force; -1: the tension of a line is positive.",
     -1.0, 1.0},
    {"target", &PidDef::target, "N or N m", "0", "Set value of the force.", -kPidAny, kPidAny},
    {"bias", &PidDef::bias, "of the input", "0", "Value of the input without an error.", -kPidAny,
     kPidAny},
    {"gain", &PidDef::gain, "input/N", "0", "Proportional gain.", -kPidAny, kPidAny},
    {"reset", &PidDef::reset, "s", "1e30", "Integral time; large values disable the integral.",
     1e-9, kPidAny},
    {"rate", &PidDef::rate, "s", "0", "Derivative time.", 0.0, kPidAny},
    {"filter", &PidDef::filter, "s", "0", "Time constant of the derivative's filter.", 0.0,
     kPidAny},
    {"low", &PidDef::low, "of the input", "-1e30", "Least value of the input.", -kPidAny, kPidAny},
    {"high", &PidDef::high, "of the input", "1e30", "Largest value of the input.", -kPidAny,
     kPidAny},
};

}  // namespace

ShapePtr pid_shape() {
    std::vector<Field> fields{
        {"name", make::name("a name"), true, "", "", "Unique name among systems."},
        {"measured", make::text("an interaction name"), true, "", "",
         "Interaction with the measured force."},
        {"row", make::integer("a row", 0, 5), false, "0", "", "Index of its measured row."},
        {"input", make::text("an input name"), true, "", "", "Input that the controller drives."}};
    add_fields(fields, kPidNumbers);
    fields.push_back({"description", make::text("a text"), false, "", "", "Remarks."});
    return make::object("pid", "a PID controller",
                        "Controller from the force of an interaction to an input: u = bias + gain "
                        "(e + integral of e/reset - rate d(measured)/dt), e = target - measured.",
                        std::move(fields));
}

SectionItem read_pid(const Description& out, const Scope& scope, const Json& json,
                     const SourceLocation& location) {
    PidDef def;
    read_fields(def, json, kPidNumbers);
    def.row = static_cast<int>(number_or(json, "row", 0.0));
    if (!(def.low < def.high)) throw_error(location / "low", "must be less than \"high\"");
    const std::string measured = interaction_name(out, scope, json, "measured", location);
    const auto& of =
        out.interactions[static_cast<std::size_t>(out.find_interaction(measured).index)];
    const int rows = kind_info(of.kind).rows;
    if (def.row >= rows)
        throw_error(location / "row", fmt::format("a {} has {} row{}", kind_info(of.kind).name,
                                                  rows, rows == 1 ? "" : "s"));
    const std::string driven = input_name(out, scope, json, "input", location);
    return {.add = [def, measured, driven](World& world, const std::string& prefix,
                                           const std::string& name) mutable {
        def.name = name;
        def.measured = world.find_interaction(prefix + measured);
        def.driven = world.find_input(prefix + driven);
        world.add_system(std::make_unique<Pid>(def));
    }};
}

}  // namespace hawser::scene
