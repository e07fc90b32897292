// SPDX-License-Identifier: Apache-2.0
// Text files of coefficients and meshes in the formats of other programs: small ones written here,
// and hostile ones.
#include <hawser/hull.h>
#include <hawser/hydro_files.h>

#include "scene/hydro_samples.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace hawser::test::hydro {
namespace {

std::string wamit_1(bool swapped = false) {
    std::string out;
    const auto scale = [](int i, int j) { return kRho * std::pow(2.0, 3 + (i > 2) + (j > 2)); };
    for (int i = 0; i < 6; ++i) {
        const double infinite = added(i, i, 1e9), zero = 1.4 * infinite;
        out += line(" -1.0 %d %d %.9E\n", i + 1, i + 1, (swapped ? infinite : zero) / scale(i, i));
        out += line(" 0.0 %d %d %.9E\n", i + 1, i + 1, (swapped ? zero : infinite) / scale(i, i));
    }
    for (std::size_t w = kOmega.size(); w-- > 0;)  // by ascending period
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                if (added(i, j, 1.0) != 0.0)
                    out += line(" %.9E %d %d %.9E %.9E\n", 2 * kPi / kOmega[w], i + 1, j + 1,
                                added(i, j, kOmega[w]) / scale(i, j),
                                damped(i, j, kOmega[w]) / scale(i, j) / kOmega[w]);
    return out;
}

std::string wamit_3() {
    std::string out = " PER BETA I MOD PHA RE IM\n";
    for (std::size_t w = kOmega.size(); w-- > 0;)
        for (int h = 0; h < 2; ++h)
            for (int k = 0; k < 6; ++k) {
                const Complex x =
                    std::conj(pushed(k, h, kOmega[w])) / (kRho * kG * std::pow(2.0, k > 2 ? 3 : 2));
                out += line(" %.9E %.6E %d %.7E %.7E %.9E %.9E\n", 2 * kPi / kOmega[w],
                            kHead[std::size_t(h)], k + 1, std::abs(x), std::arg(x) * 180 / kPi,
                            x.real(), x.imag());
            }
    return out;
}

std::string wamit_9() {
    std::string out;
    for (std::size_t w = kOmega.size(); w-- > 0;)
        for (int h = 0; h < 2; ++h)
            for (int k = 0; k < 6; ++k)
                out += line(" %.9E %.6E %.6E %d 1.0 0.0 %.9E 0.0\n", 2 * kPi / kOmega[w],
                            kHead[std::size_t(h)], kHead[std::size_t(h)], k + 1,
                            100.0 * (k + 1) / (kRho * kG * std::pow(2.0, k > 2 ? 2 : 1)));
    return out;
}

TEST(HydroFiles, Wamit) {
    const Folder folder;
    folder.write("a.gdf", "title\n 2.0 9.81\n");
    folder.write("a.3", wamit_3());
    folder.write("a.9", wamit_9());
    folder.write("a.hst", " 3 3 1.5\n 4 4 2.5\n 5 5 3.5\n");
    const WaveCoefficients c = read_coefficients(folder.write("a.1", wamit_1()), kUnits);
    expect_all(c, false);
    EXPECT_NEAR(c.infinite(2, 2), added(2, 2, 1e9), 1.0);
    EXPECT_NEAR(c.zero(2, 2), 1.4 * added(2, 2, 1e9), 1.0);
    EXPECT_NEAR(c.drift[c.index(1, 2, 4)], 500.0, 1e-3);
    EXPECT_NEAR(c.stiffness(2, 2), 1.5 * kRho * kG * 4, 1e-6);
    EXPECT_NEAR(c.stiffness(3, 3), 2.5 * kRho * kG * 16, 1e-6);
}

TEST(HydroFiles, WamitsMistakes) {
    const Folder folder;
    folder.write("a.gdf", "title\n 2.0 9.81\n");
    const std::string good = wamit_1();
    refuses(folder.write("s.1", ""), "no line of a period");
    const std::size_t last = good.rfind('\n', good.size() - 2);
    refuses(folder.write("a.1", good.substr(0, last + 1)), "missing");
    refuses(folder.write("a.1", good + good.substr(last + 1)), "given twice");
    refuses(folder.write("a.1", good + " 3.0 1 1 x 0\n"), "'x' is no finite number");
    refuses(folder.write("a.1", good + " 3.0 1 1 1e999 0\n"), "is no finite number");
    refuses(folder.write("a.1", good + " 3.0 1 1 1\n"), "5 belong here");
    refuses(folder.write("a.1", good + " 3.0 0 1 1 1\n"), "is none of 1, 2");
    folder.write("a.1", good);
    refuses(folder.write("b.1", good + std::string(1000, '1')), "line");
    std::string three = wamit_3();
    folder.write("a.3", three.substr(0, three.rfind('\n', three.size() - 2) + 1));
    refuses((folder / "a.1").string(), "missing");
    folder.write("a.3", three + " 3.3 0.0 1 1 1 1 1\n");
    refuses((folder / "a.1").string(), "is not in a.1");
    refuses((folder / "none.1").string(), "cannot open");
    refuses(folder.write("a.txt", good), "ends with none of");
}

TEST(HydroFiles, NegativeDampingAndSwappedLimits) {
    const Folder folder;
    std::string text;
    for (int n = 1; n <= 40; ++n) {
        const double omega = 0.1 * n;
        text += line(" %.9E 3 3 %.9E %.9E\n", 2 * kPi / omega, 1.0,
                     n == 7 ? -0.3 : omega * std::exp(-omega));
    }
    refuses(folder.write("a.1", text), "0.7 rad/s is not positive semi-definite");
}

std::string tec_radiation() {
    std::string out = "VARIABLES=\"w (rad/s)\"\n\"A   1   1\" \"B   1   1\"\n";
    for (int j = 0; j < 6; ++j) {
        out += line("Zone t=\"Motion of body  1 in DoF  %d\",I=   5,F=POINT\n", j + 1);
        for (const double w : kOmega) {
            out += line("  %.7E", w);
            for (int i = 0; i < 6; ++i)
                out += line("  %.7E  %.7E", added(i, j, w), damped(i, j, w));
            out += "\n";
        }
    }
    return out;
}

std::string tec_force(double share) {
    std::string out = "VARIABLES=\"w (rad/s)\"\n\"abs(F   1   1)\" \"angle(F   1   1)\"\n";
    for (int h = 0; h < 2; ++h) {
        out += line("Zone t=\"Diffraction force - beta = %7.3f deg\",I=   5,F=POINT\n",
                    kHead[std::size_t(h)]);
        for (const double w : kOmega) {
            out += line("  %.7E", w);
            for (int k = 0; k < 6; ++k) {
                const Complex x = share * pushed(k, h, w);
                out += line("  %.7E  %.7E", std::abs(x), std::arg(x));
            }
            out += "\n";
        }
    }
    return out;
}

TEST(HydroFiles, Nemoh) {
    const Folder folder;
    folder.write("ExcitationForce.tec", tec_force(1.0));
    folder.write("DiffractionForce.tec", tec_force(0.5));
    const std::string file = folder.write("RadiationCoefficients.tec", tec_radiation());
    expect_all(read_coefficients(file), true);
    const std::string good = tec_force(1.0);
    folder.write("ExcitationForce.tec", good.substr(0, good.size() / 2));
    refuses(file, "numbers");
    folder.write("ExcitationForce.tec", "1 2 3\n");
    refuses(file, "no zone");
    std::string other = good;
    other.replace(other.find("4.0000000E-01"), 13, "4.1000000E-01");
    folder.write("ExcitationForce.tec", other);
    refuses(file, "is not that of line 1");
}

TEST(HydroFiles, MeshesOfGdfAndNemoh) {
    const Folder folder;
    // A quarter of a box of 8 × 4 m, 3 m deep, without a deck.
    const std::string gdf =
        "a box\n 2.0 9.81\n 1 1\n 3\n"
        "0 0 -1.5  0 1 -1.5  2 1 -1.5  2 0 -1.5\n"
        "2 0 -1.5  2 1 -1.5  2 1 0  2 0 0\n"
        "2 1 -1.5  0 1 -1.5  0 1 0  2 1 0\n";
    HullMesh mesh = read_hull(folder.write("a.gdf", gdf));
    EXPECT_NE(hull_fault(mesh).find("open"), std::string::npos);
    close_hull(mesh, 2.0);
    EXPECT_EQ(hull_fault(mesh), "");
    EXPECT_NEAR(hull_statics(mesh, {}).volume, 8 * 4 * 3, 1e-9);
    // Half of it, mirrored in y.
    const std::string dat =
        "2 1\n1 -4 0 -3\n2 4 0 -3\n3 4 2 -3\n4 -4 2 -3\n5 -4 0 0\n6 4 0 0\n7 4 2 0\n8 -4 2 0\n"
        "0 0 0 0\n1 4 3 2\n2 3 7 6\n3 4 8 7\n4 1 5 8\n0 0 0 0\n";
    mesh = read_hull(folder.write("a.dat", dat));
    close_hull(mesh, 0.0);
    EXPECT_EQ(hull_fault(mesh), "");
    EXPECT_NEAR(hull_statics(mesh, {}, 0.5).volume, 8 * 4 * 3, 1e-9);
    for (const char* bad : {"", "2 1\n1 0 0\n", "2 1\n1 0 0 0\n0 0 0 0\n1 2 3 4\n", "3 1\n"})
        EXPECT_THROW((void)read_hull(folder.write("b.dat", bad)), DefError) << bad;
    for (const char* bad : {"", "t\n-1 9.81\n0 0\n1\n", "t\n1 9.81\n0 0\n99999999999\n",
                            "t\n1 9.81\n0 0\n1\n0 0 0 0 0 0 0 0 0 0 0\n"})
        EXPECT_THROW((void)read_hull(folder.write("b.gdf", bad)), DefError) << bad;
}

/// Truncated or randomly changed files are rejected, or read as finite values.
TEST(HydroFiles, ChangedFilesDoNoHarm) {
    const Folder folder;
    std::uint64_t seed = first_seed(7);
    const int rounds = by_tier(100, 400, 5000);
    const auto random = [&](std::size_t below) {
        seed = seed * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::size_t>(seed >> 33) % below;
    };
    folder.write("a.gdf", "t\n 2.0 9.81\n");
    int taken = 0;
    for (int round = 0; round < rounds; ++round) {
        std::string one = wamit_1(), three = wamit_3();
        std::string& which = round % 2 == 0 ? one : three;
        for (int n = 0; n < 3; ++n) which[random(which.size())] = "0123456789.-+E \nx"[random(17)];
        if (round % 5 == 0) which.resize(random(which.size()));
        folder.write("a.3", three);
        try {
            const WaveCoefficients c = read_coefficients(folder.write("a.1", one), kUnits);
            EXPECT_EQ(coefficients_fault(c), "");
            ++taken;
        } catch (const DefError&) {
        }
    }
    EXPECT_GT(taken, 0);
    EXPECT_LT(taken, rounds);
}

}  // namespace
}  // namespace hawser::test::hydro
