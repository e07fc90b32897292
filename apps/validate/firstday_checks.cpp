// SPDX-License-Identifier: Apache-2.0
// Scenes with a beginner's mistake, and the warning of hawser check.
#include <hawser/exercise.h>

#include "record/scene_info.h"
#include "report/start/check.h"
#include "report/start/parts.h"
#include "validate/firstday.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

using report::start::FindingKind;

/// A moored barge with a winch on a pier, without a mistake; `set` changes it.
constexpr const char* kValidScene = R"({"version": 1, "name": "warned",
  "line_types": {
    "chain": {"mass_per_length": 126.5, "EA": 5.83e8, "diameter": 0.076, "cd_normal": 2.4, "displaced_area": 0.01604},
    "wire": {"mass_per_length": 23, "EA": 2.4e8, "diameter": 0.076, "cd_normal": 1.2}},
  "sea": {"depth": 60, "waves": [{"kind": "regular", "height": 1, "period": 12}],
    "hulls": [{"body": "barge", "mesh": {"box": [20, 6, 4]}, "added_mass": [1e5, 5e5, 1e6, 5e6, 2e7, 2e7]}]},
  "bodies": [
    {"name": "bed", "kind": "fixed", "position": [0, 0, -60], "shapes": [{"kind": "plane"}]},
    {"name": "barge", "position": [0, 0, 1], "mass": 1476000, "box": [20, 6, 4]}],
  "cables": [
    {"name": "mooring", "line_type": "chain", "length": 300, "elements": 40, "shape": "hanging",
     "seabed": {"height": -60}, "from": {"body": "barge", "point": [20, 0, -2]},
     "to": {"at": [280, 0, -59.962]}, "contact": {}},
    {"name": "hoist", "line_type": "wire", "length": 40, "elements": 10,
     "from": {"at": [0, 60, 20]}, "to": {"at": [0, 60, -20]}}],
  "winches": [{"name": "winch", "cable": "hoist", "core_radius": 0.5, "width": 1.5, "wire_diameter": 0.076,
     "stored": 100, "inertia": 1000, "brake_static": 4e5}]})";

struct Slip {
    const char* what;
    std::vector<std::string> set;
    FindingKind kind;
    int count;  ///< Number of warnings of this kind.
};

int warnings(const std::vector<std::string>& set, FindingKind kind) {
    scene::Options options;
    options.set = set;
    const scene::Scene scene = scene::load_text(kValidScene, "warned", options);
    const auto found = report::start::check_start(record::make_scene_info(scene), scene.world);
    return static_cast<int>(std::count_if(found.list.begin(), found.list.end(), [&](const auto& f) {
        return f.kind == kind && !f.error;
    }));
}

int point_warnings(double pass) {
    exercise::Exercise e{.name = "exercise"};
    e.goals = {{.name = "a", .points = 60.0}, {.name = "b", .points = 40.0}};
    e.pass = pass;
    report::start::Findings found;
    report::start::check_points(e, found);
    return static_cast<int>(found.list.size());
}

}  // namespace

void case_first_warnings(Report& report) {
    const std::vector<Slip> slips = {
        {"sea 10 m deeper than the plane and the cable's seabed",
         {"sea.depth=70"},
         FindingKind::depth,
         2},
        {"seabed of a cable 5 m below the sea's",
         {"cables.mooring.seabed.height=-65"},
         FindingKind::depth,
         1},
        {"all depths alike", {}, FindingKind::depth, 0},
        {"a winch braked without a brake", {"winches.winch.brake_static=0"}, FindingKind::brake, 1},
        {"a winch in mode speed without a brake",
         {"winches.winch.brake_static=0", "winches.winch.mode=\"speed\""},
         FindingKind::brake,
         0},
        {"a winch with a brake", {}, FindingKind::brake, 0},
        {"EA in kN", {"line_types.chain.EA=5.83e5"}, FindingKind::stiffness, 1},
        {"EA 1,000 times too large", {"line_types.wire.EA=2.4e11"}, FindingKind::stiffness, 1},
        {"EA that fits", {}, FindingKind::stiffness, 0},
        {"mass of chain in t/m",
         {"line_types.chain.mass_per_length=0.1265"},
         FindingKind::density,
         1},
        {"mass of wire in g/m", {"line_types.wire.mass_per_length=23000"}, FindingKind::density, 1},
        {"masses that fit", {}, FindingKind::density, 0},
        {"a wire in the sea without cd_normal",
         {"line_types.wire={\"mass_per_length\": 23, \"EA\": 2.4e8, \"diameter\": 0.076}"},
         FindingKind::dry,
         1},
        {"a wire in the sea with cd_normal 0",
         {"line_types.wire.cd_normal=0"},
         FindingKind::dry,
         1},
        {"wires with drag", {}, FindingKind::dry, 0},
        {"waves of 0.97 lengths of the hull",
         {"sea.waves.0.period=5"},
         FindingKind::short_waves,
         1},
        {"waves of 5.6 lengths of the hull", {}, FindingKind::short_waves, 0},
    };
    for (const Slip& slip : slips)
        report.compare(fmt::format("warnings \"{}\": {}", to_string(slip.kind), slip.what),
                       {static_cast<double>(slip.count)},
                       {static_cast<double>(warnings(slip.set, slip.kind))}, 0.0, "count", 1.0);
    for (const double pass : {100.0, 101.0})
        report.compare(fmt::format("warnings \"points\": {:.0f} of 100 points needed", pass),
                       {pass > 100.0 ? 1.0 : 0.0}, {static_cast<double>(point_warnings(pass))}, 0.0,
                       "count", 1.0);
}

}  // namespace hawser::validate
