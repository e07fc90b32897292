// SPDX-License-Identifier: Apache-2.0
#include "marine/hull_kernels.h"

namespace hawser::HAWSER_ISA {
namespace {

#if defined(__AVX512F__)
inline constexpr int kSides = 8;
#elif defined(__AVX2__)
inline constexpr int kSides = 4;
#else
inline constexpr int kSides = 2;
#endif
typedef double Sides __attribute__((vector_size(8 * kSides), aligned(8), may_alias));

#define HAWSER_HULL __attribute__((always_inline)) inline

/// Number of entries of a corner: x, y, z, depth, pressure.
constexpr int kCornerEntries = 5;

struct Corner {
    Sides x, y, z, depth, pressure;
};
struct Arrow {
    Sides x, y, z;
};
HAWSER_HULL Arrow between(const Corner& a, const Corner& b) {
    return {b.x - a.x, b.y - a.y, b.z - a.z};
}
HAWSER_HULL Arrow cross(const Arrow& a, const Arrow& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Add completely wet triangles, like HullSums::add_wet().
HAWSER_HULL void add(const Corner& a, const Corner& b, const Corner& c, Sides* to) {
    const Arrow twice = cross(between(a, b), between(a, c));  // normal by twice the area
    const Sides p = a.pressure + b.pressure + c.pressure, push = p * (1.0 / 6.0);
    to[marine::kForce] -= twice.x * push;
    to[marine::kForce + 1] -= twice.y * push;
    to[marine::kForce + 2] -= twice.z * push;
    const Sides pa = p + a.pressure, pb = p + b.pressure, pc = p + c.pressure;
    const Arrow turn = cross({pa * a.x + pb * b.x + pc * c.x, pa * a.y + pb * b.y + pc * c.y,
                              pa * a.z + pb * b.z + pc * c.z},
                             twice);
    to[marine::kTorque] -= turn.x * (1.0 / 24.0);
    to[marine::kTorque + 1] -= turn.y * (1.0 / 24.0);
    to[marine::kTorque + 2] -= turn.z * (1.0 / 24.0);
    const Sides third = twice.z * (-1.0 / 6.0);
    to[marine::kPlane] += 3.0 * third;
    const auto middle = [&](const Corner& u, const Corner& w) __attribute__((always_inline)) {
        const Sides x = 0.5 * (u.x + w.x), y = 0.5 * (u.y + w.y), z = 0.5 * (u.z + w.z);
        const Sides s = 0.5 * (u.depth + w.depth), v = third * s, tx = third * x, ty = third * y;
        to[marine::kVolume] += v;
        to[marine::kMoment] += v * x;
        to[marine::kMoment + 1] += v * y;
        to[marine::kMoment + 2] += v * (z + 0.5 * s);
        to[marine::kPlaneX] += tx;
        to[marine::kPlaneY] += ty;
        to[marine::kPlaneXX] += tx * x;
        to[marine::kPlaneYY] += ty * y;
        to[marine::kPlaneXY] += tx * y;
    };
    middle(a, b);
    middle(b, c);
    middle(c, a);
}

int wet(const double* corners, const std::int32_t* triangles, int count, int* cut,
        double* sums) noexcept {
    // Gather the wet triangles first, by entry of a corner, then triangle. Reading a vector
    // directly after its parts were written would stall.
    alignas(64) double gathered[3 * kCornerEntries][marine::kHullBlock];
    int whole = 0, cuts = 0;
    for (int t = 0; t < count; ++t) {
        const double* const corner[] = {corners + kCornerEntries * triangles[3 * t],
                                        corners + kCornerEntries * triangles[3 * t + 1],
                                        corners + kCornerEntries * triangles[3 * t + 2]};
        const int under = static_cast<int>(corner[0][3] > 0.0) +
                          static_cast<int>(corner[1][3] > 0.0) +
                          static_cast<int>(corner[2][3] > 0.0);
        if (under == 0) continue;
        if (under < 3) {
            cut[cuts++] = t;
            continue;
        }
#pragma GCC unroll 3
        for (int c = 0; c < 3; ++c)
#pragma GCC unroll 5
            for (int e = 0; e < kCornerEntries; ++e)
                gathered[kCornerEntries * c + e][whole] = corner[c][e];
        ++whole;
    }
    for (; whole % kSides != 0; ++whole)  // pad with triangles of no area
        for (int e = 0; e < 3 * kCornerEntries; ++e) gathered[e][whole] = 0.0;
    Sides all[marine::kHullSums]{};
    for (int t = 0; t < whole; t += kSides) {
        const auto at = [&](int e) __attribute__((always_inline)) {
            return *reinterpret_cast<const Sides*>(&gathered[e][t]);
        };
        add({at(0), at(1), at(2), at(3), at(4)}, {at(5), at(6), at(7), at(8), at(9)},
            {at(10), at(11), at(12), at(13), at(14)}, all);
    }
    for (int s = 0; s < marine::kHullSums; ++s) {
        sums[s] = 0.0;
        for (int i = 0; i < kSides; ++i) sums[s] += all[s][i];
    }
    return cuts;
}

#undef HAWSER_HULL

}  // namespace

extern const marine::HullKernels kHullKernels;
const marine::HullKernels kHullKernels = {wet};

}  // namespace hawser::HAWSER_ISA
