// SPDX-License-Identifier: Apache-2.0
// Kernels of waves, hulls and memory for every instruction set, against plain sums.
#include <hawser/sea.h>

#include "base/isa.h"
#include "base/memory.h"
#include "marine/hull_kernels.h"
#include "marine/hull_sums.h"
#include "marine/memory_sums.h"
#include "marine/spectra.h"
#include "marine/wave_sums.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace hawser::test {
namespace {

struct Kernels {
    const char* name;
    const marine::WaveKernels* waves;
    const marine::HullKernels* hulls;
    const marine::MemoryKernels* memory;
};

std::vector<Kernels> kernels() {
    std::vector<Kernels> all{
        {"sse2", &sse2::kWaveKernels, &sse2::kHullKernels, &sse2::kMemoryKernels}};
#if !defined(HAWSER_NO_AVX2)
    if (base::isa() >= base::Isa::avx2)
        all.push_back({"avx2", &avx2::kWaveKernels, &avx2::kHullKernels, &avx2::kMemoryKernels});
#endif
#if !defined(HAWSER_NO_AVX512)
    if (base::isa() >= base::Isa::avx512)
        all.push_back(
            {"avx512", &avx512::kWaveKernels, &avx512::kHullKernels, &avx512::kMemoryKernels});
#endif
    return all;
}

/// Sum all components at every depth by functions of the standard library.
marine::WaveSums plain_sums(const Sea& sea, const SeaMoment& now, double x, double y, double z) {
    marine::WaveSums out{};
    const double d = sea.depth();
    for (std::size_t i = 0; i < sea.components().size(); ++i) {
        const WaveComponent& w = sea.components()[i];
        const double cx = std::cos(w.direction), cy = std::sin(w.direction), k = w.wave_number;
        const double theta = k * (cx * x + cy * y) + marine::kTwoPi * now.phase[i];
        const double speed = -w.amplitude * w.frequency / std::expm1(-2.0 * k * d);
        const double up = std::exp(k * z), down = std::exp(-k * (z + 2.0 * d));
        const double level = speed * (up + down), steep = speed * (up - down);
        const double c = std::cos(theta), s = std::sin(theta), o = w.frequency;
        out.u[0] += level * c * cx;
        out.u[1] += level * c * cy;
        out.u[2] += steep * s;
        out.a[0] += o * level * s * cx;
        out.a[1] += o * level * s * cy;
        out.a[2] -= o * steep * c;
        out.p += level * c * o / k;
    }
    return out;
}

/// Make a swell and a wind sea: groups contain components of very different lengths where both
/// overlap.
SeaDef mixed(double depth) {
    SeaDef sea{.depth = depth};
    sea.waves.push_back({.height = 1.0, .period = 18.0});
    sea.waves.push_back({.kind = WaveKind::jonswap,
                         .height = 2.0,
                         .period = 5.0,
                         .spreading = 8.0,
                         .components = 150});
    return sea;
}

TEST(SeaKernels, WavesAtAllDepths) {
    for (const double depth : {6.0, 60.0, 4000.0}) {
        const Sea sea(mixed(depth));
        const auto table = marine::wave_table(sea.components(), depth);
        const int padded = static_cast<int>(table.size()) / marine::kWaveRows;
        const SeaMoment now = sea.at(30.0);
        double speeds = 0.0, rates = 0.0, heights = 0.0;  // sums of amplitudes
        for (const WaveComponent& w : sea.components()) {
            const double tanh = std::tanh(w.wave_number * depth);
            heights += w.amplitude;
            speeds += w.amplitude * w.frequency / tanh;
            rates += w.amplitude * w.frequency * w.frequency / tanh;
        }
        // sin and cos of angles up to 40 m · k are exact to 1e-12, E to 1e-12; omitted terms are
        // 1.2e-13. Pressure is p/ρ, at most g a.
        const double most = 4e-12;
        for (const Kernels& by : kernels())
            for (int i = 0; i < 200; ++i) {
                double x[4], y[4], z[4], sum[4], p[4];
                std::vector<double> circle(static_cast<std::size_t>(8 * padded));
                for (int n = 0; n < 4; ++n) {
                    x[n] = 40.0 * std::sin(i + n);
                    y[n] = 40.0 * std::cos(3.0 * i + n);
                    z[n] = -depth * std::pow((i % 50 + 0.25 * n) / 49.75, 2.0);
                }
                z[3] = i % 7 == 0 ? -std::numeric_limits<double>::infinity() : z[3];
                marine::WaveSums got[4];
                by.waves->many.surface(table.data(), padded, now.phase.data(), x, y, circle.data(),
                                       sum);
                by.waves->many.sums(table.data(), padded, circle.data(), z, got);
                by.waves->many.pressure(table.data(), padded, circle.data(), z, p);
                for (int n = 0; n < 4; ++n) {
                    marine::WaveSums one;
                    double alone = 0.0;
                    by.waves->one.surface(table.data(), padded, now.phase.data(), x + n, y + n,
                                          circle.data(), &alone);
                    by.waves->one.sums(table.data(), padded, circle.data(), z + n, &one);
                    double height = 0.0;
                    for (std::size_t c = 0; c < sea.components().size(); ++c) {
                        const WaveComponent& w = sea.components()[c];
                        height +=
                            w.amplitude * std::cos(w.wave_number * (std::cos(w.direction) * x[n] +
                                                                    std::sin(w.direction) * y[n]) +
                                                   marine::kTwoPi * now.phase[c]);
                    }
                    EXPECT_NEAR(sum[n], height, most * heights) << by.name;
                    EXPECT_NEAR(alone, height, most * heights) << by.name;
                    if (!std::isfinite(z[n])) {
                        EXPECT_EQ(got[n].u[0], 0.0);
                        EXPECT_EQ(p[n], 0.0);
                        continue;
                    }
                    const marine::WaveSums want = plain_sums(sea, now, x[n], y[n], z[n]);
                    for (int k = 0; k < 3; ++k) {
                        EXPECT_NEAR(got[n].u[k], want.u[k], most * speeds) << by.name << z[n];
                        EXPECT_NEAR(got[n].a[k], want.a[k], most * rates) << by.name << z[n];
                        EXPECT_NEAR(one.u[k], want.u[k], most * speeds) << by.name << z[n];
                    }
                    EXPECT_NEAR(got[n].p, want.p, most * 9.81 * heights / std::tanh(0.03 * depth))
                        << by.name << z[n];
                    EXPECT_NEAR(p[n], got[n].p, 1e-14 * 9.81 * heights * 100.0) << by.name;
                }
            }
    }
}

TEST(SeaKernels, WholeTrianglesAgreeWithSingleOnes) {
    const HullMesh mesh = box_hull({4, 3, 2}, 7, 5, 3);
    std::vector<marine::HullCorner> corners;
    for (const Vec3& x : mesh.vertices) {
        const double depth = 0.4 * std::sin(2.0 * x.x()) - x.z() + 0.1 * x.y();
        corners.push_back({x + Vec3(0.3, -0.2, 0.1), depth, 1e4 * std::max(depth, 0.0)});
    }
    for (const Kernels& by : kernels())
        for (const int count : {1, 7, 8, 63, marine::kHullBlock}) {
            marine::HullSums want, cut_sums;
            int cut[marine::kHullBlock], cuts = 0, dry = 0;
            const auto add = [&](marine::HullSums& to, int t) {
                const auto& c = mesh.triangles[static_cast<std::size_t>(t)];
                to.add_triangle(corners[static_cast<std::size_t>(c[0])],
                                corners[static_cast<std::size_t>(c[1])],
                                corners[static_cast<std::size_t>(c[2])]);
            };
            for (int t = 0; t < count; ++t) add(want, t);
            double s[marine::kHullSums];
            cuts = by.hulls->wet(corners.front().x.data(), mesh.triangles.front().data(), count,
                                 cut, s);
            for (int i = 0; i < cuts; ++i) add(cut_sums, cut[i]);
            ASSERT_LE(cuts + dry, count);
            const auto near = [&](int at, double cut_part, double all, double scale) {
                EXPECT_NEAR(s[at] + cut_part, all, 1e-13 * scale) << by.name << " " << at;
            };
            for (int k = 0; k < 3; ++k) {
                near(marine::kForce + k, cut_sums.force[k], want.force[k], 1e6);
                near(marine::kTorque + k, cut_sums.torque[k], want.torque[k], 1e7);
                near(marine::kMoment + k, cut_sums.moment[k], want.moment[k], 1e3);
            }
            near(marine::kVolume, cut_sums.volume, want.volume, 1e2);
            near(marine::kPlane, cut_sums.plane, want.plane, 1e2);
            near(marine::kPlaneX, cut_sums.x, want.x, 1e2);
            near(marine::kPlaneY, cut_sums.y, want.y, 1e2);
            near(marine::kPlaneXX, cut_sums.xx, want.xx, 1e3);
            near(marine::kPlaneYY, cut_sums.yy, want.yy, 1e3);
            near(marine::kPlaneXY, cut_sums.xy, want.xy, 1e3);
        }
}

/// A ring buffer with any start, lengths that are no multiple of a block, some pairs or all.
TEST(SeaKernels, MemoryOfAnyLengthAndBeginning) {
    std::mt19937 dice(first_seed(5));
    const int rounds = by_tier(1, 4, 40);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    std::vector<int> all;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) all.insert(all.end(), {i, j});
    const std::vector<int> some = {0, 0, 1, 1, 3, 1, 4, 0, 5, 5};
    for (int round = 0; round < rounds; ++round)
        for (const std::vector<int>& pairs : {all, some})
            for (const std::int64_t count : {1, 5, 8, 9, 64, 131, 400}) {
                const auto n = static_cast<std::int64_t>(pairs.size()) / 2;
                const std::int64_t stride = marine::memory_stride(count);
                base::Array<double> k(static_cast<std::size_t>(n * marine::memory_padded(count)),
                                      0.0);
                std::vector<double> v(static_cast<std::size_t>(6 * stride));
                const auto kernel = [&](std::int64_t m, std::int64_t p) -> double& {
                    return k[static_cast<std::size_t>((m / 8 * n + p) * 8 + m % 8)];
                };
                const auto past = [&](std::int64_t i, std::int64_t m) -> double& {
                    return v[static_cast<std::size_t>(i * stride + m)];
                };
                for (std::int64_t m = 0; m < count; ++m)
                    for (std::int64_t p = 0; p < n; ++p) kernel(m, p) = value(dice);
                for (std::int64_t i = 0; i < 6; ++i)
                    for (std::int64_t m = 0; m < stride; ++m)
                        past(i, m) = m < count ? value(dice) : past(i, m % count);
                for (std::int64_t newest = 0; newest < count; newest += 1 + count / 7) {
                    double want[6] = {};
                    for (std::int64_t m = 0; m < count; ++m)
                        for (std::int64_t p = 0; p < n; ++p) {
                            const int i = pairs[static_cast<std::size_t>(2 * p)],
                                      j = pairs[static_cast<std::size_t>(2 * p + 1)];
                            const std::int64_t at = (newest + m) % count;
                            want[i] += kernel(m, p) * past(j, at);
                            if (i != j) want[j] += kernel(m, p) * past(i, at);
                        }
                    for (const Kernels& by : kernels()) {
                        double got[6] = {};
                        by.memory->sums(k.data(), v.data(), count, newest, pairs.data(),
                                        static_cast<int>(n), got);
                        // Rounding of up to 400 · 6 products of numbers below 1.
                        for (int i = 0; i < 6; ++i)
                            EXPECT_NEAR(got[i], want[i], 1e-12) << by.name << count << newest;
                    }
                }
            }
}

}  // namespace
}  // namespace hawser::test
