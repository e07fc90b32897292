// SPDX-License-Identifier: Apache-2.0
/// Outputs of the commands that read scenes, compared with those of an earlier commit
/// (CONTRIBUTING.md, "Golden files").
#include "golden/outputs.h"

#include <array>

namespace hawser::golden {
namespace {

using SceneOutputs = Outputs;

/// Scenes with many kinds of mistakes.
constexpr std::array<const char*, 14> kBadScenes{
    R"({"version": 1, "name": "syntax" "bodies": []})",
    R"({"version": 2, "name": "version"})",
    R"({"version": 1, "name": "types", "bodies": {}, "settings": {"step": "long", "stp": 1}})",
    R"({"version": 1, "name": "mass", "bodies": [{"name": "x", "kind": "lump", "mass": -1},
        {"name": "y", "mass": 2}, {"name": "x", "mass": 1, "box": [1, 1, 1]}]})",
    R"({"version": 1, "name": "names", "bodies": [{"name": "boom", "mass": 1, "sphere": 1}],
        "interactions": [{"kind": "hing", "bodies": ["boom", "world"]},
                         {"kind": "ball", "bodies": ["bom", "world"]},
                         {"kind": "ball", "bodies": ["boom"]},
                         {"kind": "hinge_motor", "bodies": ["boom", "world"], "spede": 3}]})",
    R"({"version": 1, "name": "cable", "line_types": {"wire": {"mass_per_length": 0}},
        "cables": [{"name": "c", "line_type": "wyre", "elements": 0, "from": {"at": [0, 0, 0]},
                    "to": {"body": "nobody"}},
                   {"name": "d", "line_type": {"mass_per_length": 3, "EA": 1e6}, "elements": 4,
                    "length": 5, "shape": "catenary", "from": {"at": [0, 0, 0]},
                    "to": {"at": [10, 0, 0]}}]})",
    R"({"version": 1, "name": "shapes", "bodies": [{"name": "a", "mass": 1, "sphere": 1,
        "shapes": [{"kind": "sphere", "radius": -1}, {"kind": "cube"},
                   {"kind": "box", "half_size": [1, 1]}]}]})",
    R"({"version": 1, "name": "inside", "bodies": [
        {"name": "a", "mass": 1, "box": [1, 1, 1],
         "shapes": [{"kind": "box", "half_size": [1, 1, 1]}]},
        {"name": "b", "mass": 1, "box": [1, 1, 1], "position": [0.2, 0, 0],
         "shapes": [{"kind": "box", "half_size": [1, 1, 1]}]}]})",
    R"({"version": 1, "name": "joints", "bodies": [
        {"name": "a", "mass": 4, "box": [1, 1, 0.3]},
        {"name": "b", "mass": 5, "box": [0.2, 1, 0.5], "position": [0, 2, -0.5]}],
        "interactions": [
         {"name": "c", "kind": "cylindrical", "bodies": ["a", "b"], "at": [0.5, -0.5, 1],
          "axis": [0, 0, 1]},
         {"name": "l", "kind": "lock", "bodies": ["a", "b"],
          "points": [[-1, 0.5, 0], [0.5, -0.7, 0.7]]}]})",
    R"({"version": 1, "name": "repeated", "bodies": [{"name": "a", "mass": 4, "box": [1, 1, 1]}],
        "interactions": [
         {"name": "h1", "kind": "hinge", "bodies": ["a", "world"], "at": [1, 0, 0],
          "axis": [0, 1, 0]},
         {"name": "h2", "kind": "hinge", "bodies": ["a", "world"], "at": [1, 1, 0],
          "axis": [0, 1, 0]}]})",
    R"({"version": 1, "name": "inertia", "bodies": [
        {"name": "a", "mass": 1, "inertia": [1, 1, 5]}, {"name": "b", "mass": 1,
         "inertia": [1, 2, -1]}]})",
    R"({"version": 1, "name": "winch", "line_types": {"wire": {"mass_per_length": 5, "EA": 1e7}},
        "cables": [{"name": "c", "line_type": "wire", "elements": 4, "from": {"at": [0, 0, 0]},
                    "to": {"at": [40, 0, 0]}}],
        "winches": [{"name": "w", "cable": "c", "core_radius": 0.01, "width": 1, "stored": 1e4,
                     "mode": "fast"}],
        "timeline": [{"at": -1, "cut": "d", "s": 3}, {"at": 1, "set": {"w.sped": 1}}]})",
    R"({"version": 1, "name": "inputs", "bodies": [{"name": "a", "mass": 1, "sphere": 1}],
        "inputs": [{"name": "i", "body": "a", "component": "force_w"},
                   {"name": "i", "body": "a", "component": "force_x", "min": 2, "max": 1}],
        "outputs": [{"name": "o", "kind": "pose", "body": "a", "component": "up"}],
        "plot": {"motions": ["b"]}})",
    R"({"version": 1, "name": "template", "templates": {"t": {"parameters": {"m": 1},
        "bodies": [{"name": "x", "mass": "${n}", "sphere": 1}]}},
        "instances": [{"template": "t", "name": "i", "parameters": {"q": 2}},
                      {"template": "u", "name": "k"}]})"};

TEST_F(SceneOutputs, CheckOfBadScenesIsThatOfTheFile) {
    std::vector<std::string> all{"check"}, as_json{"check", "--json"};
    for (std::size_t i = 0; i < kBadScenes.size(); ++i) {
        const std::string file = out("bad" + std::to_string(i + 1) + ".json");
        write_text(file, kBadScenes[i]);
        all.push_back(file);
        as_json.push_back(file);
    }
    run(all);
    run(as_json);
    run({"run", out("bad5.json")});
    check_log("check_bad");
}

TEST_F(SceneOutputs, CheckOfGoodScenesIsThatOfTheFile) {
    std::vector<std::string> all{"check", "--cables"};
    for (const char* name : {"anchor_drag", "arch", "buoy", "cantilever", "chain_pile",
                             "crane_lattice", "heavy_hook", "payout", "scheme_decay", "tackle",
                             "tow_payout", "wire_cross", "wire_pulse", "wire_slide"})
        all.push_back(std::string("scenes/") + name + ".json");
    run(all);
    run({"check", "--signals", "scenes/crane_knuckle.json"});
    run({"check", "--signals", "scenes/tow_payout.json"});
    run({"check", "--json", "scenes/chain_pile.json", "scenes/tow_payout.json"});
    check_log("check_good");
}

TEST_F(SceneOutputs, InspectIsThatOfTheFiles) {
    run({"inspect", "scenes/tow_payout.json", "-o", out("")});
    check_file("spy.svg", "inspect_spy.svg");
    add_picture("spy.png");
    run({"inspect", "scenes/crane_lattice.json", "--form", "saddle", "--steps", "5"});
    run({"inspect", "scenes/arch.json", "--parts", "2", "--steps", "10"});
    run({"inspect", "scenes/floating_box.json", "--hydrostatics"});
    check_log("inspect");
}

TEST_F(SceneOutputs, SettleIsThatOfTheFiles) {
    run({"settle", "scenes/tackle.json", "-o", out("tackle.json")});
    check_file("tackle.json", "settle_tackle.json");
    run({"settle", "scenes/buoy.json", "-o", out("buoy.json"), "--max-time", "20"});
    check_file("buoy.json", "settle_buoy.json");
    check_log("settle");
}

TEST_F(SceneOutputs, FiguresAreThoseOfTheFiles) {
    run({"figures", "scenes/tackle.json", "-o", out(""), "--at", "0.5", "--samples", "1",
         "--threads", "1"});
    for (const char* panel :
         {"fig1_matrix", "fig1_split_matrix", "fig1_graph", "fig1_cut_graph", "fig2_full_natural",
          "fig2_full_amd", "fig2_split_natural", "fig2_split_amd"}) {
        const std::string name = panel;
        check_file(name + ".json", "figures_" + name + ".json");
        check_file(name + ".svg", "figures_" + name + ".svg");
    }
    check_log("figures");
}

TEST_F(SceneOutputs, ValidateIsThatOfTheFiles) {
    run({"validate", "decay", "motor_limits", "joint_limits", "belt", "painleve", "sea_box",
         "--json", out("cases.json")});
    check_file("cases.json", "validate.json");
    run({"validate", "--list"});
    run({"validate", "pendulam"});
    check_log("validate");
}

TEST_F(SceneOutputs, HelpIsThatOfTheFile) {
    run({"--help"});
    run({"--version"});
    for (const char* command : {"run", "check", "settle", "replay", "plot", "exercise", "export",
                                "inspect", "figures", "validate", "view", "bench"})
        run({command, "--help"});
    check_log("help");
}

}  // namespace
}  // namespace hawser::golden
