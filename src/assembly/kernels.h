// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kernels.h
/// Loops over bodies and interactions that are compiled for each instruction set.

#include "assembly/view.h"

#include <cstdint>

namespace hawser::assembly {

/// Table of the compiled loops. A range of bodies or interactions writes only its own entries.
struct Kernels {
    /// Compute violation, Jacobian, c and geometric record of pool entries [begin, end); also G
    /// v_start and M̃ v_start.
    void (*evaluate)(const View&, InteractionKind kind, const std::int32_t* ids, const void* data,
                     std::int32_t begin, std::int32_t end) noexcept;
    /// Compute c of the completed ones of pool entries [begin, end), linearised about the packed
    /// velocities u. `first`: write to c, else to c_next.
    Turning (*complete_rows)(const View&, InteractionKind kind, const std::int32_t* ids,
                             const void* data, std::int32_t begin, std::int32_t end,
                             const double* u, bool first) noexcept;
    /// Compute the terms from spins of turning bodies, linearised about u. First call: add to a;
    /// else write to spin_next.
    Turning (*complete_spins)(const View&, std::int32_t begin, std::int32_t end, const double* u,
                              bool first) noexcept;
    /// Copy c_next to c, for the completed ones of ids[begin, end).
    void (*adopt_completed)(const View&, const std::int32_t* ids, std::int32_t begin,
                            std::int32_t end) noexcept;
    /// Replace the spin terms in the right-hand sides a of turning bodies by spin_next.
    void (*adopt_spins)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Compute body blocks and a, including geometric terms.
    void (*body_terms)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Write blocks of the matrix into the panels.
    void (*gather_blocks)(const View&, const Op* ops, std::int64_t begin, std::int64_t end,
                          double* panel) noexcept;
    /// Write blocks of the matrix into the panels, eight lanes at a time.
    void (*gather_lane_blocks)(const View&, const LaneOp* ops, std::int64_t begin, std::int64_t end,
                               double* panel) noexcept;
    /// Compute the first residual, for λ = 0 and v₊ = 0. If `moving`, v₊ = v_start, for which
    /// evaluate() stored G v₊ in place of the residuals. For kept interactions also write to the
    /// vector of the solver. λ keeps the values of the last step until the first row_update().
    void (*first_rhs)(const View&, std::int32_t begin, std::int32_t end, bool moving) noexcept;
    /// Compute the right-hand side of the solver from the residuals, for bodies. The first call
    /// also writes the initial v₊.
    void (*first_body_rhs)(const View&, std::int32_t begin, std::int32_t end, bool moving) noexcept;
    void (*body_rhs)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Add the solution to v₊.
    void (*add_solution)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Add the solution to λ, then compute the residual of every row, then K v₊. For kept
    /// interactions also write the residual to the vector of the solver. `first`: set λ to the
    /// solution.
    void (*row_update)(const View&, std::int32_t begin, std::int32_t end, bool first) noexcept;
    /// Compute norms over bodies, with the momentum residual.
    void (*body_norms)(const View&, std::int32_t begin, std::int32_t end, Norms*) noexcept;
    /// Compute norms over interactions.
    void (*row_norms)(const View&, std::int32_t begin, std::int32_t end, Norms*) noexcept;
    /// Return the energy that rows of at most kLossChunk interactions absorb in the step [J], see
    /// solve/losses.cpp. Interactions that need more data than their rows are excluded. They are
    /// written to `left` (capacity kLossChunk), and their number to `left_count`.
    double (*row_losses)(const View&, std::int32_t begin, std::int32_t end, std::int32_t* left,
                         int* left_count) noexcept;
    /// Add up the energy that lines store beyond the work of the bodies at their ends, and the
    /// absolute change of stored energy.
    void (*line_gains)(const View&, const std::int32_t* ids, std::int32_t count,
                       LineGain*) noexcept;
    /// Sum the energies of the leading rigid bodies with consecutive indices among `count` bodies,
    /// eight at a time. @param after  Packed velocities after the step. @param half  Half of the
    /// step, or 0. @return their number, a multiple of eight.
    std::int32_t (*rigid_energies)(const View&, const std::int32_t* bodies, std::int32_t count,
                                   const double* after, double half, BodyEnergies*) noexcept;
    /// Return the row of [begin, end) with the largest weighted violation |g| × fraction, if it
    /// exceeds *most; *most is then set to it. Otherwise return −1.
    std::int32_t (*widest_row)(const double* g, const double* fraction, std::int32_t begin,
                               std::int32_t end, double* most) noexcept;
    /// Move bodies by h v₊ and store v₊.
    void (*integrate)(const View&, std::int32_t begin, std::int32_t end) noexcept;
};

[[nodiscard]] const Kernels& kernels() noexcept;

}  // namespace hawser::assembly

namespace hawser::sse2 {
extern const assembly::Kernels kAssemblyKernels;
}
namespace hawser::avx2 {
extern const assembly::Kernels kAssemblyKernels;
}
namespace hawser::avx512 {
extern const assembly::Kernels kAssemblyKernels;
}
