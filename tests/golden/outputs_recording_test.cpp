// SPDX-License-Identifier: Apache-2.0
/// Outputs of the commands that read recordings, and of exercises, compared with those of an
/// earlier commit (CONTRIBUTING.md, "Golden files").
#include "golden/outputs.h"

#include <nlohmann/json.hpp>

namespace hawser::golden {
namespace {

using RecordingOutputs = Outputs;

/// Operations that leave two pieces of a wire, for pictures of wires that change.
constexpr const char* kCut = R"([{"at": 0.3, "cut": "tow", "s": 150}])";

TEST_F(RecordingOutputs, PlotsOfCablesAreThoseOfTheFiles) {
    write_text(out("cut.json"), kCut);
    run({"run", "scenes/tow_payout.json", "--duration", "0.6", "--control", out("cut.json"),
         "--record", out("tow.hwr"), "--record-every", "4", "--quiet"});
    run({"plot", out("tow.hwr"), "-o", out("tow")});
    for (const std::string name : {"tensions", "wires", "motions", "scene", "space", "details"}) {
        check_file("tow/" + name + ".svg", "plot_tow_" + name + ".svg");
        add_picture("tow/" + name + ".png");
    }
    run({"replay", out("tow.hwr")});
    check_log("plot_tow");
}

TEST_F(RecordingOutputs, PlotsOfContactsAreThoseOfTheFiles) {
    run({"run", "scenes/incline.json", "--duration", "0.5", "--record", out("incline.hwr"),
         "--record-every", "5", "--quiet"});
    run({"plot", out("incline.hwr"), "-o", out("all"), "--at", "0.3", "--only", "scene,motions",
         "--size", "640x360"});
    check_file("all/scene.svg", "plot_incline_scene.svg");
    check_file("all/motions.svg", "plot_incline_motions.svg");
    run({"plot", out("incline.hwr"), "-o", out("view"), "--only", "scene", "--view", "3d",
         "--azimuth", "-40", "--elevation", "30", "--size", "640x360"});
    check_file("view/scene.svg", "plot_incline_3d.svg");
    add_picture("view/scene.png");
    run({"plot", out("incline.hwr"), "-o", out("film"), "--only", "scene", "--view", "side",
         "--frames", "2", "--size", "400x240"});
    add_picture("film/frame_0000.png");
    add_picture("film/frame_0001.png");
    run({"plot", out("incline.hwr"), "--only", "scenery"});
    check_log("plot_incline");
}

TEST_F(RecordingOutputs, ExportsAreThoseOfTheFiles) {
    write_text(out("cut.json"), kCut);
    run({"run", "scenes/tow_payout.json", "--duration", "0.5", "--control", out("cut.json"),
         "--record", out("tow.hwr"), "--record-every", "6", "--quiet"});
    run({"export", out("tow.hwr"), "--to", "vtk", "--contacts", "--every", "2", "-o",
         out("vtk/tow.pvd")});
    check_file("vtk/tow.pvd", "export_vtk.pvd");
    add_vtp("vtk/tow/frame_000000.vtp");
    add_vtp("vtk/tow/frame_000002.vtp");
    run({"export", out("tow.hwr"), "--to", "gltf", "-o", out("tow.glb")});
    add_glb("tow.glb");
    run({"export", out("tow.hwr"), "--to", "vtk", "--from", "7", "-o", out("none.pvd")});
    check_log("export");
}

TEST_F(RecordingOutputs, ExportOfContactsIsThatOfTheFiles) {
    run({"run", "scenes/arch.json", "--duration", "0.2", "--record", out("arch.hwr"),
         "--record-every", "6", "--quiet"});
    run({"export", out("arch.hwr"), "--to", "vtk", "--contacts", "-o", out("arch.pvd")});
    add_vtp("arch/frame_000002.vtp");
    run({"export", out("arch.hwr"), "--to", "gltf", "--from", "0.05", "--to-time", "0.15", "-o",
         out("arch.glb")});
    add_glb("arch.glb");
    check_log("export_arch");
}

TEST_F(RecordingOutputs, ExerciseIsThatOfTheFiles) {
    const std::string exercise = "exercises/crane_lift.json";
    run({"exercise", exercise, "--control", "exercises/crane_lift.control.csv", "--record",
         out("lift.hwr"), "--record-every", "60", "--summary", out("lift.json")});
    check_file("lift.json", "exercise.json");
    run({"exercise", exercise, "--replay", out("lift.hwr"), "--summary", out("again.json"),
         "--quiet"});
    check_file("again.json", "exercise_replayed.json");
    check_log("exercise");
}

/// Controls of a short exercise that fails: the load is dropped beside its target.
constexpr const char* kClumsy =
    "time,take,hoist,slew,luff\n0,0,0,0,0\n0.5,1,0,0,0\n1,1,0.5,0,0\n3,1,0.5,0.06,0.05\n"
    "5,1,-0.5,0.06,0\n7,0,0,-0.06,0\n";

TEST_F(RecordingOutputs, FailedExerciseIsThatOfTheFiles) {
    // A report has a curve with a point per step: run 10 s instead of 180 s.
    auto exercise = nlohmann::json::parse(hawser::test::read_text("exercises/crane_lift.json"));
    exercise["duration"] = 10;
    exercise["scene"] = "crane.json";
    write_text(out("lift.json"), exercise.dump());
    write_text(out("crane.json"), hawser::test::read_text("scenes/crane_knuckle.json"));
    write_text(out("clumsy.csv"), kClumsy);
    run({"exercise", out("lift.json"), "--control", out("clumsy.csv"), "--report",
         out("report.html"), "--summary", out("score.json"), "--record", out("lift.hwr")});
    check_file("score.json", "exercise_failed.json");
    check_file("report.html", "exercise_failed.html");
    run({"replay", out("lift.hwr")});
    check_log("exercise_failed");
}

}  // namespace
}  // namespace hawser::golden
