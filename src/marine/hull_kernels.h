// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull_kernels.h
/// Sum the integrals of hull_sums.h over completely wet triangles, several at a time, compiled once
/// for each instruction set. Most triangles of a hull are completely wet. Triangles cut by the
/// surface are left to HullSums::add_triangle().

#include <cstdint>

namespace hawser::marine {

/// Offsets of the members of HullSums in the sums of a kernel.
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

/// Maximum number of triangles of one call.
inline constexpr int kHullBlock = 64;

struct HullKernels {
    /// Sum the wet triangles. @param corners  x, y, z, depth, pressure of each. @param triangles
    /// Corners, three each. @param cut  Output: numbers of the partly wet triangles. @param sums
    /// Output.
    /// @return number of partly wet triangles.
    int (*wet)(const double* corners, const std::int32_t* triangles, int count, int* cut,
               double* sums) noexcept;
};
/// Return the kernels for the instruction set in use.
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
