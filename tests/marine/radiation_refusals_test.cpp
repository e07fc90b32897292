// SPDX-License-Identifier: Apache-2.0
// Impossible coefficients and hulls are rejected; trim, and decks of open meshes.
#include <hawser/hawser.h>

#include "marine/floater.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace hawser::test {
namespace {

void refused(const WaveCoefficients& c, const char* why) {
    const std::string fault = coefficients_fault(c);
    EXPECT_NE(fault.find(why), std::string::npos) << "'" << fault << "' has no '" << why << "'";
}

TEST(Radiation, CoefficientsThatCannotBeAreRefused) {
    const WaveCoefficients good = coupled();
    EXPECT_EQ(coefficients_fault(good), "");
    WaveCoefficients c = good;
    c.damping.pop_back();
    refused(c, "damping: 239 matrices");
    c = good;
    c.damping[7](3, 3) = -c.damping[20](3, 3);
    refused(c, "is not positive semi-definite");
    c = good;  // All with the wrong sign, as if phases were read by the other convention.
    for (Matrix6& m : c.damping) m = -m;
    refused(c, "is not positive semi-definite");
    c = good;
    c.frequency[3] = c.frequency[2];
    refused(c, "they have to ascend");
    c = good;
    c.added_mass[5](2, 2) = std::nan("");
    refused(c, "not finite");
    c = good;
    c.infinite(2, 2) = -1.0;
    refused(c, "A(inf) is not positive");
    c = good;
    c.heading = {0.0};
    c.excitation.assign(5, 0.0);
    refused(c, "5 entries");
    // A(0) and A(∞) exchanged.
    c = good;
    for (std::size_t w = 0; w < c.frequency.size(); ++w) {
        const double more = bell_added(c.frequency[w], 1.0, 0.5);
        c.added_mass[w](1, 1) += 2e6 * more;
        c.added_mass[w](2, 2) += 4e6 * more;
        c.added_mass[w](3, 3) += 5e7 * more;
    }
    c.zero = c.infinite * 1.5;
    c.has_zero = true;
    EXPECT_EQ(coefficients_fault(c), "");
    std::swap(c.zero, c.infinite);
    refused(c, "swapped");
}

TEST(Radiation, WavesOfBothKindsAreRefused) {
    WaveCoefficients c = coupled();
    add_waves(c);
    const auto fails = [&](auto&& change, const char* why) {
        Floater f(c);
        change(f);
        try {
            f.start();
            ADD_FAILURE() << why;
        } catch (const SeaError& error) {
            EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
        }
    };
    fails(
        [](Floater& f) {
            f.hull.linear.on = false;
            f.hull.mesh = box_hull({5, 5, 5});
            f.hull.wave_pressure = true;
            f.hull.excitation = ExcitationKind::full;
        },
        "wave_pressure false");
    fails([](Floater& f) { f.hull.excitation = ExcitationKind::scattering; },
          "needs the wave pressure on the mesh");
    fails([](Floater& f) { f.hull.radiation = RadiationKind::constant; }, "constant_period");
    fails([](Floater& f) { f.hull.memory = 0.01; }, "memory");
    fails(
        [](Floater& f) {
            auto one = std::make_shared<WaveCoefficients>(*f.hull.coefficients);
            one->heading = {0.0, 0.5, 1.0};
            f.hull.coefficients = one;
            f.hull.excitation = ExcitationKind::full;
            f.sea.waves = {{.height = 1.0, .period = 9.0, .direction = 2.0}};
        },
        "not among the directions");
}

TEST(Radiation, HullTrims) {
    // A box whose centre of mass is 0.5 m forward. Trim of the wall-sided body: lever = tan θ (GM_L
    // + ½ BM_L tan²θ) about the middle.
    HullMesh mesh = box_hull({20, 5, 3}, 20, 4, 4);
    for (Vec3& v : mesh.vertices) v -= Vec3(0.5, 0, 0.5);
    const double mass = 1025.0 * 40 * 10 * 2.5;
    const Flotation f = float_hull(mesh, mass, 1025.0, 0.0, true);
    EXPECT_NEAR(f.statics.buoyancy.x(), 0.0, 1e-9);
    const double bm = 40.0 * 40 / (12 * 2.5), t = std::tan(f.trim);
    const double gm = 1.25 + bm - 3.5;
    EXPECT_NEAR(t * (gm + 0.5 * bm * t * t), 0.5, 1e-9);
    EXPECT_GT(f.trim, 0.0);
    EXPECT_GT(righting_lever(mesh, mass, 1025.0, 0.2, true), 0.0);
}

TEST(Radiation, OpenMeshGetsWallsAndDeck) {
    HullMesh mesh = box_hull({4, 2, 1}, 4, 2, 2);
    std::erase_if(mesh.triangles, [&](const auto& t) {
        return mesh.vertices[std::size_t(t[0])].z() == 1.0 &&
               mesh.vertices[std::size_t(t[1])].z() == 1.0 &&
               mesh.vertices[std::size_t(t[2])].z() == 1.0;
    });
    EXPECT_NE(hull_fault(mesh), "");
    for (const double top : {1.0, 3.0}) {
        HullMesh closed = mesh;
        close_hull(closed, top);
        EXPECT_EQ(hull_fault(closed), "");
        EXPECT_NEAR(hull_statics(closed, {}, 10.0).volume, 8 * 4 * (top + 1), 1e-9);
    }
    HullMesh hole = box_hull({4, 2, 1}, 4, 2, 2);
    hole.triangles.erase(hole.triangles.begin());
    EXPECT_THROW(close_hull(hole, 5.0), DefError);
}

}  // namespace
}  // namespace hawser::test
