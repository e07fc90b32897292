// SPDX-License-Identifier: Apache-2.0
/// VTK XML, read back: offsets of appended blocks, points, tensions, strains, contact forces.
#include "export/export.h"
#include "record/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace hawser::test {
namespace {

/// A .vtp file with raw appended blocks.
class Vtp {
  public:
    explicit Vtp(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        text_.assign((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
        data_ = text_.find('_', text_.find("<AppendedData")) + 1;
    }
    /// Read an array. @param from  Key after which the array is searched.
    template <class T>
    [[nodiscard]] std::vector<T> array(const std::string& name, const std::string& from) const {
        std::size_t at = text_.find("Name=\"" + name + "\"", text_.find("<" + from));
        EXPECT_LT(at, data_) << name;
        at = text_.find("offset=\"", at) + 8;
        const std::size_t offset = data_ + std::stoul(text_.substr(at, 20));
        std::uint64_t size = 0;
        std::memcpy(&size, text_.data() + offset, sizeof size);
        EXPECT_LE(offset + 8 + size, text_.size());
        std::vector<T> out(size / sizeof(T));
        std::memcpy(out.data(), text_.data() + offset + 8, size);
        return out;
    }
    [[nodiscard]] bool has(const std::string& part) const {
        return text_.find(part) != std::string::npos;
    }

  private:
    std::string text_;
    std::size_t data_ = 0;
};

TEST(Vtk, HasPosesTensionsAndStrainsOfTheRecording) {
    const auto folder = fresh_folder();
    SmallScene scene;
    scene.record(folder / "r.hwr", 90);
    const record::Recording r = record::Recording::open(folder / "r.hwr");
    exporting::write_vtk(r, exporting::choose_frames(r, 10, 0.0, 1e9), folder / "r.pvd");
    EXPECT_TRUE(Vtp(folder / "r.pvd").has("file=\"r/frame_000009.vtp\""));
    for (const std::size_t i : {0U, 4U, 9U}) {
        const record::Frame frame = r.frame(10 * i);
        const Vtp vtp(folder / "r" / ("frame_00000" + std::to_string(i) + ".vtp"));
        const auto points = vtp.array<double>("Points", "Points");
        const auto kind = vtp.array<std::int32_t>("kind", "CellData"),
                   index = vtp.array<std::int32_t>("index", "CellData"),
                   parted = vtp.array<std::int32_t>("parted", "CellData"),
                   lines = vtp.array<std::int32_t>("connectivity", "Lines");
        const auto tension = vtp.array<float>("tension", "CellData"),
                   strain = vtp.array<float>("strain", "CellData"),
                   turn = vtp.array<float>("orientation", "CellData");
        ASSERT_EQ(kind, (std::vector<std::int32_t>{0, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3}));
        EXPECT_EQ(index[0], 2) << "the box; nodes of wires and the world have no vertex";
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(points[static_cast<std::size_t>(k)], frame.poses[2].position[k]);
        EXPECT_EQ(turn[0], static_cast<float>(frame.poses[2].orientation.w()));
        EXPECT_TRUE(std::isnan(tension[0]) && std::isnan(turn[4]));
        for (std::size_t e = 0; e < 2; ++e) {
            EXPECT_EQ(tension[1 + e], frame.tensions[e]);
            EXPECT_EQ(strain[1 + e], static_cast<float>(frame.tensions[e] / 1e5));
        }
        EXPECT_EQ(parted[2], i == 9 ? 1 : 0);
        const auto first = static_cast<std::size_t>(lines[1]);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(points[3 * first + k], frame.poses[1].position[static_cast<int>(k)]);
    }
}

TEST(Vtk, HasContactForcesOfWhoKnowsThem) {
    const auto folder = fresh_folder();
    SmallScene scene;
    scene.record(folder / "r.hwr", 3);
    const record::Recording r = record::Recording::open(folder / "r.hwr");
    const exporting::ContactForces at{{1, 2, 3, 4, 5, 6}, {10, 20, 30, 40, 50, 60}};
    exporting::write_vtk(r, {1}, folder / "r.pvd",
                         [&](const record::Frame& frame) -> const exporting::ContactForces& {
                             EXPECT_EQ(frame.step, 1);
                             return at;
                         });
    const Vtp vtp(folder / "r" / "frame_000000.vtp");
    const auto points = vtp.array<double>("Points", "Points");
    const auto force = vtp.array<float>("force", "CellData");
    EXPECT_EQ(vtp.array<std::int32_t>("kind", "CellData")[2], 1);
    EXPECT_EQ(std::vector<double>(points.begin() + 3, points.begin() + 9), at.points);
    EXPECT_EQ(std::vector<double>(force.begin() + 3, force.begin() + 9), at.forces);
    EXPECT_TRUE(std::isnan(force[0]));
}

}  // namespace
}  // namespace hawser::test
