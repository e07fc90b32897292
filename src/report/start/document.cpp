// SPDX-License-Identifier: Apache-2.0
/// Warn about numbers of a scene's document: line types whose stiffness does not fit their
/// diameter, and winches whose brake has no holding force.
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace hawser::report::start {
namespace {

using Json = nlohmann::json;

/// Range of EA over the square of the diameter. Nylon rope has 1.2e8 to 1e9, polyester 1e10, wire
/// 4e10, chain 1e11 N/m², a bar of steel 1.65e11. A confusion of kN and N leaves this range by far.
constexpr double kMinSpecificEA = 1.1e8, kMaxSpecificEA = 5e12;

double number_in(const Json& object, const char* key) {
    const auto at = object.find(key);
    return at != object.end() && at->is_number() ? at->get<double>() : 0.0;
}

void check_line_type(const std::string& name, const Json& line, Findings& out) {
    const double EA = number_in(line, "EA"), d = number_in(line, "diameter");
    if (!(EA > 0.0 && d > 0.0)) return;
    const double ratio = EA / (d * d);
    if (ratio >= kMinSpecificEA && ratio <= kMaxSpecificEA) return;
    out.add(
        false, FindingKind::stiffness, {name}, ratio,
        fmt::format("the line type {} has EA = {} at a diameter of {}, EA/d^2 = {:.2g} N/m^2: "
                    "nylon has 1.2e8 to 1e9, polyester 1e10, wire rope 4e10, chain 1e11; give EA "
                    "in N (not kN) and the diameter in m",
                    record::name_in_quotes(name), record::with_unit(EA, "N"),
                    record::with_unit(d, "m"), ratio));
}

/// Check all objects of a document, recursively. @param key  Name of the object in its parent, or
/// the "name" of the nearest object that has one.
void visit(const Json& json, const std::string& key, Findings& out) {
    if (json.is_array()) {
        for (const Json& entry : json) visit(entry, key, out);
        return;
    }
    if (!json.is_object()) return;
    const auto name = json.find("name");
    const std::string own =
        name != json.end() && name->is_string() ? name->get<std::string>() : key;
    if (json.contains("mass_per_length") && json.contains("EA")) check_line_type(own, json, out);
    for (const auto& [inner, value] : json.items()) {
        if (inner == "winches" && value.is_array())
            for (const Json& winch : value) {
                if (!winch.is_object()) continue;
                const std::string mode = winch.value("mode", "brake");
                const auto held = winch.find("brake_static");
                if (mode != "brake" || (held != winch.end() && !held->is_number())) continue;
                if (number_in(winch, "brake_static") > 0.0) continue;
                const std::string which = winch.value("name", "");
                out.add(
                    false, FindingKind::brake, {which}, 0.0,
                    fmt::format("the winch {} starts in mode \"brake\" without \"brake_static\": "
                                "its brake has no holding torque, and the wire runs out; give the "
                                "torque at which it slips, or another mode",
                                record::name_in_quotes(which)));
            }
        visit(value, value.is_object() && inner != "line_type" ? inner : own, out);
    }
}

}  // namespace

void check_document(const record::SceneInfo& scene, Findings& out) {
    const Json text = Json::parse(scene.text, nullptr, false);
    if (text.is_object()) visit(text, "", out);
}

}  // namespace hawser::report::start
