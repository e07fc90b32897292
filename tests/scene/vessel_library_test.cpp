// SPDX-License-Identifier: Apache-2.0
/// The library of vessels (scenes/parts/vessel_*.json): each floats upright at its design draught
/// in still water with the coefficients of its scene.
#include <hawser/hawser.h>
#include <hawser/scene.h>
#include <hawser/sea.h>
#include <hawser/vessel.h>

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace hawser::test {
namespace {

using LibraryJson = nlohmann::json;

/// A folder with the parts, from which scenes can include them.
class LibraryFolder {
  public:
    LibraryFolder() {
        std::filesystem::create_directories(path_ / "parts");
        for (const auto& each : std::filesystem::directory_iterator("scenes/parts"))
            if (each.path().filename().string().starts_with("vessel_"))
                std::filesystem::copy_file(each.path(), path_ / "parts" / each.path().filename(),
                                           std::filesystem::copy_options::overwrite_existing);
    }
    ~LibraryFolder() { std::filesystem::remove_all(path_); }
    LibraryFolder(const LibraryFolder&) = delete;
    LibraryFolder& operator=(const LibraryFolder&) = delete;

    /// Return a shipped scene in still water, without orders and without the cables of the scene
    /// itself.
    [[nodiscard]] scene::Scene still(const char* name) const {
        LibraryJson doc =
            LibraryJson::parse(std::ifstream("scenes/" + std::string(name) + ".json"));
        for (const char* key : {"$schema", "timeline", "cables", "plot"}) doc.erase(key);
        for (const char* key : {"waves", "current", "wind"}) doc["sea"].erase(key);
        for (LibraryJson& one : doc["instances"]) one.erase("parameters");
        const std::string file = (path_ / "scene.json").string();
        std::ofstream(file) << doc;
        return scene::load_file(file);
    }

  private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("hawser_vessels_" + std::to_string(::getpid()));
};

/// Check the draught of a ship against its definition, and its displacement against the volume of
/// the sea's hull.
void expect_upright(const World& world, const char* body, double height, double allowed) {
    const Pose pose = world.pose(world.find_body(body));
    const Mat3 axes = pose.orientation.toRotationMatrix();
    const double degree = 57.29577951308232;
    EXPECT_NEAR(pose.position.z(), height, allowed) << body;
    EXPECT_LT(std::abs(std::atan2(axes(2, 1), axes(2, 2))) * degree, 0.1) << body;
    EXPECT_LT(std::abs(std::asin(axes(2, 0))) * degree, 0.1) << body;
}

// One hundredth of the draught.
TEST(VesselLibrary, FloatsUprightAtItsDraught) {
    const LibraryFolder folder;
    scene::Scene tow = folder.still("tow_barge");
    scene::Scene rig = folder.still("semi_moored");
    for (World* w : {&tow.world, &rig.world})
        for (int i = 0; i < 20 * 60; ++i) ASSERT_EQ(w->step(), Status::ok);
    expect_upright(tow.world, "ahts/hull", 1.2, 0.05);
    expect_upright(tow.world, "barge/hull", 1.5, 0.04);
    expect_upright(rig.world, "semi/hull", 3.0, 0.18);
    expect_upright(rig.world, "tug/hull", 0.35, 0.043);
    for (const World* w : {&tow.world, &rig.world})
        for (const VesselDef* def : vessels_of(*w))
            EXPECT_TRUE(unusual_values(*w, *def).empty()) << unusual_values(*w, *def).front();
}

// Full ahead: thrust at rest by the class rule of ducted propellers, 1250 (P D)^(2/3), within 3 %.
TEST(VesselLibrary, PullsWhatItsPageSays) {
    const LibraryFolder folder;
    scene::Scene rig = folder.still("semi_moored");
    World& w = rig.world;
    for (const char* side : {"tug/ship.port", "tug/ship.starboard"}) w.set_system_signal(side, 1.0);
    double most = 0.0;
    for (int i = 0; i < 8 * 60; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        most = std::max(most, w.system_signal("tug/ship.port_thrust"));
    }
    EXPECT_LT(most, 1.03 * 1250.0 * std::pow(1900.0 * 2.6, 2.0 / 3.0));
    EXPECT_GT(most, 0.75 * 1250.0 * std::pow(1900.0 * 2.6, 2.0 / 3.0));  // it accelerates
    EXPECT_GT(w.system_signal("tug/ship.speed"), 2.0);
}

}  // namespace
}  // namespace hawser::test
