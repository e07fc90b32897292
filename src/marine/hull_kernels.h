// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull_kernels.h
/// Sums of hull_sums.h over the triangles that are wet as a whole, several at a time, compiled once
/// for each instruction set. Most of a hull is such: what the surface cuts is left to
/// HullSums::add_triangle().

#include <cstdint>

namespace hawser::marine {

/// Where HullSums' members stand in what a kernel adds up.
enum HullSum : int {
    kForce,
    kTorque = 3,
    kVolume = 6,
    kMoment,
    kPlane = 10,
    kPlaneX,
    kPlaneY,
    kPlaneXX,
    kPlaneYY,
    kPlaneXY,
    kHullSums
};

/// Triangles of one call at most.
inline constexpr int kHullBlock = 64;

struct HullKernels {
    /// @param corners  x, y, z, depth, pressure of each. @param triangles  Corners, three each.
    /// @param cut  Takes the numbers of the triangles that are wet in part. @param sums  Written.
    /// @return how many are cut.
    int (*wet)(const double* corners, const std::int32_t* triangles, int count, int* cut,
               double* sums) noexcept;
};
/// For the instruction set in use.
[[nodiscard]] const HullKernels& hull_kernels() noexcept;

}  // namespace hawser::marine

namespace hawser::sse2 {
extern const marine::HullKernels kHullKernels;
}
namespace hawser::avx2 {
extern const marine::HullKernels kHullKernels;
}
namespace hawser::avx512 {
extern const marine::HullKernels kHullKernels;
}
