// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kernels.h
/// The dense inner loops, compiled once for each instruction set and chosen at run time.

#include <cstdint>

namespace hawser::factor {

struct Batch;
struct BatchStep;
struct Front;
struct Run;

/// Raw view of a factorisation for the kernels.
struct FactorView {
    const Front* fronts;
    const std::int32_t* children;
    const std::int32_t* rows;
    const Run* runs;
    const std::int8_t* sign;
    double* panel;  ///< L below the diagonal of each panel; zeros on and above it.
    double* pivot;  ///< D, one per permuted scalar.
    double* work;   ///< Update matrices that several tasks read.
    double* stack;  ///< `work`, shifted to this thread's stacks from stack_begin on.
    std::int64_t stack_begin;
    double* carry;  ///< Update vectors of the forward substitution, one entry per update row.

    // Batches, see batches.h. Slot arrays have eight lanes per slot.
    const BatchStep* batch_steps;
    const std::int8_t* slot_sign;  ///< One per slot.
    const std::int32_t* slot_index;
    const std::int32_t* tail_slot;
    double* slot_pivot;  ///< 1/D.
    double* slot_y;      ///< Between forward and backward substitution.
    bool distant;        ///< true if the panels are larger than a core's own cache.

    // Unsymmetric fronts, see unsymmetric.h.
    /// 1 for an unsymmetric front; null: all are symmetric.
    const std::uint8_t* unsymmetric = nullptr;
    double* upper = nullptr;        ///< Uᵀ, laid out like the panels.
    double* upper_work = nullptr;   ///< Like work: upper halves of update matrices, transposed.
    double* upper_stack = nullptr;  ///< Like stack.
    std::int8_t* wrong = nullptr;   ///< Set to 1 at wrong pivots, one per permuted scalar.

    [[nodiscard]] double* update(std::int64_t place) const noexcept {
        return (place < stack_begin ? work : stack) + place;
    }
    [[nodiscard]] double* upper_update(std::int64_t place) const noexcept {
        return (place < stack_begin ? upper_work : upper_stack) + place;
    }
    [[nodiscard]] bool is_unsymmetric(std::int32_t front) const noexcept {
        return unsymmetric != nullptr && unsymmetric[front] != 0;
    }
};

/// Weights of nodes as rows of bits. A node weighs `least`, plus more[c] if its bit in row c of
/// `rows` is set. At most one row sets it.
struct NodeWeights {
    /// Number of sizes other than the least: blocks have 1 to 6 scalars.
    static constexpr int kMaximum = 5;
    std::int32_t least = 1, count = 0;
    std::int32_t more[kMaximum] = {};
    const std::uint64_t* rows = nullptr;
};

/// All functions that are compiled for one instruction set.
struct Kernels {
    /// Factor fronts [begin, end) in order.
    /// @return number of pivots of the wrong sign or not finite.
    int (*factor)(const FactorView& view, std::int32_t begin, std::int32_t end,
                  double* scratch) noexcept;
    /// Solve L y = x on fronts [begin, end). x is the permuted right-hand side and is overwritten.
    void (*forward)(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                    double* scratch) noexcept;
    /// Solve U z = D⁻¹ y on fronts [end, begin) from the top down. U = Lᵀ if symmetric.
    void (*backward)(const FactorView& view, std::int32_t begin, std::int32_t end, double* x,
                     double* scratch) noexcept;
    /// Do the same for the chains of a batch, with the updates for their parents. The first two
    /// process steps [begin, end) and continue with the same scratch. The counts of wrong pivots
    /// are valid in the sum over all steps.
    int (*factor_batch)(const FactorView& view, const Batch& batch, std::int32_t begin,
                        std::int32_t end, double* scratch) noexcept;
    void (*forward_batch)(const FactorView& view, const Batch& batch, std::int32_t begin,
                          std::int32_t end, const double* x, double* scratch) noexcept;
    void (*backward_batch)(const FactorView& view, const Batch& batch, double* x,
                           double* scratch) noexcept;
    /// Unite rows of bits (minimum_degree.h) for k < count. Row nodes[k] becomes (row ∪ with) ∩
    /// among, sizes[k] the weight of its nodes, and folds[k] the exclusive or of its words. Rows
    /// are aligned and have 8, 16, 24 or 32 words.
    void (*unite_rows)(std::uint64_t* rows, std::int32_t words, const std::int32_t* nodes,
                       std::int32_t count, const std::uint64_t* with, const std::uint64_t* among,
                       const NodeWeights& weights, std::int32_t* sizes,
                       std::uint64_t* folds) noexcept;
    /// Copy n doubles, a multiple of eight, past the caches, because they are not read soon. A
    /// cached store would first read the old values. Both arrays are aligned to base::kAlign.
    void (*stream)(double* to, const double* from, std::int64_t n) noexcept;
};

/// Number of pivot columns whose unscaled values a front keeps in the scratch.
inline constexpr int kUnscaledColumns = 32;

/// Return the scratch of a thread for symmetric fronts of at most this ld [doubles]. Unsymmetric
/// fronts need twice this, or twice Symbolic::batch_scratch.
[[nodiscard]] constexpr std::int64_t scratch_size(std::int32_t max_front) {
    return kUnscaledColumns * static_cast<std::int64_t>(max_front) + 128;
}

/// Return the kernels for the instruction set of this process.
[[nodiscard]] const Kernels& factor_kernels() noexcept;

}  // namespace hawser::factor

namespace hawser::sse2 {
extern const factor::Kernels kKernels;
}
namespace hawser::avx2 {
extern const factor::Kernels kKernels;
}
namespace hawser::avx512 {
extern const factor::Kernels kKernels;
}
