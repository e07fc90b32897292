// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kernels.h
/// The hot loops over bodies and interactions, compiled for each instruction set.

#include "assembly/view.h"

#include <cstdint>

namespace hawser::assembly {

/// Hot loops. Ranges are of bodies or of interactions; a range writes only its own entries.
struct Kernels {
    /// Violation, Jacobian, c and geometric record of pool entries [begin, end); G v_start, M̃
    /// v_start.
    void (*evaluate)(const View&, InteractionKind kind, const std::int32_t* ids, const void* data,
                     std::int32_t begin, std::int32_t end) noexcept;
    /// c of the completed ones among pool entries [begin, end), about the packed velocities u: as
    /// the step's `first` into c, else into c_next.
    Turning (*complete_rows)(const View&, InteractionKind kind, const std::int32_t* ids,
                             const void* data, std::int32_t begin, std::int32_t end,
                             const double* u, bool first) noexcept;
    /// What spins of turning bodies give, about u: as the first one into a, else into spin_next.
    Turning (*complete_spins)(const View&, std::int32_t begin, std::int32_t end, const double* u,
                              bool first) noexcept;
    /// c becomes c_next, of the completed ones among ids[begin, end).
    void (*adopt_completed)(const View&, const std::int32_t* ids, std::int32_t begin,
                            std::int32_t end) noexcept;
    /// Right-hand sides a of turning bodies take spin_next.
    void (*adopt_spins)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Body blocks and a, geometric terms included.
    void (*body_terms)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// Write blocks of the matrix into the panels.
    void (*gather_blocks)(const View&, const Op* ops, std::int64_t begin, std::int64_t end,
                          double* panel) noexcept;
    /// Write blocks of the matrix into the panels, eight lanes at a time.
    void (*gather_lane_blocks)(const View&, const LaneOp* ops, std::int64_t begin, std::int64_t end,
                               double* panel) noexcept;
    /// First residual, of λ = 0 and v₊ = 0 or, if `moving`, v₊ = v_start, for which evaluate() has
    /// left G v₊ where residuals go; for kept interactions also in the solver's vector. λ itself,
    /// that of the last step, stays until the first row_update().
    void (*first_rhs)(const View&, std::int32_t begin, std::int32_t end, bool moving) noexcept;
    /// Right-hand side of the solver from the residuals: bodies. The first one writes v₊, of which
    /// it starts.
    void (*first_body_rhs)(const View&, std::int32_t begin, std::int32_t end, bool moving) noexcept;
    void (*body_rhs)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// v₊ += solution.
    void (*add_solution)(const View&, std::int32_t begin, std::int32_t end) noexcept;
    /// λ += the solution's part, then the residual of every row, for kept interactions also in the
    /// solver's vector; then K v₊. `first`: λ is the solution itself.
    void (*row_update)(const View&, std::int32_t begin, std::int32_t end, bool first) noexcept;
    /// Norms over bodies, with the momentum residual.
    void (*body_norms)(const View&, std::int32_t begin, std::int32_t end, Norms*) noexcept;
    /// Norms over interactions.
    void (*row_norms)(const View&, std::int32_t begin, std::int32_t end, Norms*) noexcept;
    /// Energy that rows of at most kLossChunk interactions take in the step [J], see
    /// solve/losses.cpp. `left`: those (`left_count`) that are not in the sum, since they need
    /// more than their rows; room for kLossChunk.
    double (*row_losses)(const View&, std::int32_t begin, std::int32_t end, std::int32_t* left,
                         int* left_count) noexcept;
    /// What lines hold more after the step than before, and than the bodies at their ends gave
    /// them; and what they hold more or less. Added up.
    void (*line_gains)(const View&, const std::int32_t* ids, std::int32_t count,
                       LineGain*) noexcept;
    /// Energies of as many of `count` bodies from the first on as are rigid and stand in a row,
    /// eight at a time. @param after  Packed velocities after the step. @param half  Half the step,
    /// or 0. @return how many they are: a multiple of eight.
    std::int32_t (*rigid_energies)(const View&, const std::int32_t* bodies, std::int32_t count,
                                   const double* after, double half, BodyEnergies*) noexcept;
    /// The row of [begin, end) with the largest violation by its share, |g| share, if it is above
    /// *most, which then is that; else −1.
    std::int32_t (*widest_row)(const double* g, const double* share, std::int32_t begin,
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
