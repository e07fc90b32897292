// SPDX-License-Identifier: Apache-2.0
// Hulls: statics against closed forms, clipping against brute force, files.
#include <hawser/hull.h>
#include <hawser/sea.h>

#include "marine/hull_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace hawser::test {
namespace {

double degrees(double x) { return x * std::numbers::pi / 180.0; }

TEST(Hulls, BoxHasItsStatics) {
    // 10 × 10 × 4 m, draught 2 m, G 1 m above the waterline.
    const double rho = 1025.0, mass = rho * 200.0;
    HullMesh box = box_hull({5, 5, 2});
    for (Vec3& v : box.vertices) v.z() -= 1.0;
    const Flotation f = float_hull(box, mass, rho);
    ASSERT_TRUE(f.floats);
    EXPECT_NEAR(f.draught, mass / (rho * 100.0), 1e-12);
    EXPECT_NEAR(f.kb, 1.0, 1e-12);
    EXPECT_NEAR(f.bm, 1e4 / 12.0 / 200.0, 1e-12);
    EXPECT_NEAR(f.kg, 3.0, 1e-12);
    EXPECT_NEAR(f.gm, 1.0 + 1e4 / 2400.0 - 3.0, 1e-12);
    // Wall-sided: sin φ (GM + ½ BM tan² φ).
    for (const double heel : {5.0, 15.0}) {
        const double phi = degrees(heel), t = std::tan(phi);
        EXPECT_NEAR(righting_lever(box, mass, rho, phi),
                    std::sin(phi) * (f.gm + 0.5 * f.bm * t * t), 1e-12);
    }
    EXPECT_FALSE(float_hull(box, 2.1 * mass, rho).floats);
}

TEST(Hulls, PrismAndTurnedBoxHaveTheirVolumes) {
    // A wedge, edge down: at half its height, a quarter of its area is wet.
    HullMesh wedge;
    wedge.vertices = {{0, 0, -1}, {0, 1, 1}, {0, -1, 1}, {6, 0, -1}, {6, 1, 1}, {6, -1, 1}};
    wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                       {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    for (auto& t : wedge.triangles) (void)t;
    if (!hull_fault(wedge).empty())
        for (auto& t : wedge.triangles) std::swap(t[0], t[1]);
    ASSERT_EQ(hull_fault(wedge), "");
    const HullStatics s = hull_statics(wedge, Pose{});
    EXPECT_NEAR(s.volume, 6.0 * 0.5, 1e-13);
    EXPECT_NEAR(s.buoyancy.z(), -1.0 / 3.0, 1e-13);
    EXPECT_NEAR(s.plane_area, 6.0, 1e-13);
    EXPECT_NEAR(s.plane_centre.x(), 3.0, 1e-13);
    EXPECT_NEAR(s.inertia_x, 6.0 / 12.0, 1e-13);
    // At any rotation, half of a box is wet, by symmetry.
    for (int i = 0; i < 20; ++i) {
        Pose pose;
        pose.orientation =
            Quat(std::cos(i), std::sin(2.0 * i), std::cos(3.0 * i), 0.3).normalized();
        EXPECT_NEAR(hull_statics(box_hull({3, 2, 1}, 2, 3, 1), pose).volume, 24.0, 1e-12);
    }
}

TEST(Hulls, CutTrianglesAgreeWithBruteForce) {
    // Any triangle, with depths linear over it: 4^9 pieces, by their centres.
    for (int i = 0; i < 12; ++i) {
        marine::HullCorner c[3];
        const Vec3 slope(0.2 * std::sin(i), 0.3 * std::cos(2.0 * i), -1.0);
        for (int k = 0; k < 3; ++k) {
            c[k].x = {std::sin(3.0 * i + k), std::cos(5.0 * i + 2.0 * k),
                      0.8 * std::sin(7.0 * i * k)};
            c[k].depth = 0.1 + slope.dot(c[k].x);
            c[k].pressure = 3.0 * c[k].depth;
        }
        marine::HullSums sums;
        sums.add_triangle(c[0], c[1], c[2]);
        const Vec3 area = 0.5 * (c[1].x - c[0].x).cross(c[2].x - c[0].x);
        constexpr int kCuts = 600;
        Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
        double volume = 0.0, xy = 0.0;
        for (int u = 0; u < kCuts; ++u)
            for (int v = 0; v < kCuts - u; ++v)
                for (const int half : {1, 2}) {
                    if (half == 2 && v + u + 1 >= kCuts) continue;
                    const double p = (u + half / 3.0) / kCuts, q = (v + half / 3.0) / kCuts;
                    const Vec3 x = c[0].x + p * (c[1].x - c[0].x) + q * (c[2].x - c[0].x);
                    const double s = 0.1 + slope.dot(x);
                    if (s <= 0.0) continue;
                    const Vec3 da = area / (kCuts * kCuts);
                    force -= 3.0 * s * da;
                    torque -= 3.0 * s * x.cross(da);
                    volume -= s * da.z();
                    xy -= x.x() * x.y() * da.z();
                }
        // The pieces cut by the surface are 1/600 of it, at small depth.
        const double most = 3e-5;
        EXPECT_LT((sums.force - force).norm(), most) << i;
        EXPECT_LT((sums.torque - torque).norm(), most) << i;
        EXPECT_NEAR(sums.volume, volume, most) << i;
        EXPECT_NEAR(sums.xy, xy, 3e-3) << i;  // not at small depth: the step at the surface counts
    }
}

class HullFiles : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& bytes) {
        const auto file = std::filesystem::path(testing::TempDir()) / name;
        std::ofstream(file, std::ios::binary) << bytes;
        return file.string();
    }
    static std::string fault(const std::string& file) {
        try {
            (void)read_hull(file);
        } catch (const DefError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(HullFiles, AreReadAsTheyWereWritten) {
    const HullMesh box = box_hull({1, 2, 3});
    std::string obj = "# a box\no box\n", stl = "solid box\n";
    std::string binary(80, ' ');
    const auto append = [&](const auto& value) {
        binary.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (const Vec3& v : box.vertices)
        obj += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
               std::to_string(v.z()) + "\n";
    append(static_cast<std::uint32_t>(box.triangles.size()));
    for (const auto& t : box.triangles) {
        obj += "f";
        stl += "facet normal 0 0 0\nouter loop\n";
        for (int k = 0; k < 3; ++k) append(0.0F);
        for (const auto i : t) {
            const Vec3& v = box.vertices[static_cast<std::size_t>(i)];
            obj += " " + std::to_string(i + 1) + "/1/1";
            stl += "vertex " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
                   std::to_string(v.z()) + "\n";
            for (int k = 0; k < 3; ++k) append(static_cast<float>(v[k]));
        }
        obj += "\n";
        stl += "endloop\nendfacet\n";
        append(std::uint16_t{0});
    }
    for (const std::string& file :
         {write("box.obj", obj), write("box.stl", stl), write("binary.STL", binary)}) {
        const HullMesh mesh = read_hull(file);
        EXPECT_EQ(mesh.vertices.size(), 8u) << file;
        EXPECT_EQ(mesh.triangles.size(), 12u);
        EXPECT_EQ(hull_fault(mesh), "");
        EXPECT_NEAR(hull_statics(mesh, Pose{}).volume, 24.0, 1e-12);
    }
    // Faces of four corners, with negative indices that count from the end.
    const std::string quads =
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f -8 -5 -6 -7\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    EXPECT_EQ(hull_fault(read_hull(write("quads.obj", quads))), "");
}

TEST_F(HullFiles, ThatAreWrongAreRefusedByTheirLine) {
    EXPECT_NE(fault("nowhere.obj").find("cannot open"), std::string::npos);
    EXPECT_NE(fault(write("a.obj", "v 1 2 x\n")).find("line 1"), std::string::npos);
    EXPECT_NE(fault(write("b.obj", "v 1 2 3\nf 1 2 3\n")).find("line 2"), std::string::npos);
    EXPECT_NE(fault(write("c.obj", "v 1 2 nan\n")).find("line 1"), std::string::npos);
    EXPECT_NE(fault(write("d.obj", "")).find("no triangles"), std::string::npos);
    EXPECT_NE(fault(write("e.stl", std::string(80, ' ') + std::string("\xff\xff\xff\x7f", 4)))
                  .find("ends before"),
              std::string::npos);
    EXPECT_NE(fault(write("f.xyz", "v 1 2 3")).find("none of"), std::string::npos);
    EXPECT_NE(fault(write("g.stl", "short")).find("too short"), std::string::npos);
}

}  // namespace
}  // namespace hawser::test
