// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file residual.h
/// Refinement of a solution: what is left of K x = b in double, and how much that is.
///
/// Iterative refinement (Wilkinson 1963) solves K d = r for the residual r = b − K x with the
/// factor at hand and adds d to x. The factor may be a poor one, in single precision even: each
/// step takes the error down by about cond(K) times its rounding, while x ends as exact as r is
/// (Moler 1967; Langou et al., "Exploiting the performance of 32 bit floating point arithmetic in
/// obtaining 64 bit accuracy", 2006). Where to stop is asked of the componentwise backward error
///
///     ω = max_i |b − K x|_i / (|K| |x| + |b|)_i
///
/// (Oettli, Prager 1964): x solves some system exactly each of whose entries differs from that of K
/// and b by no more than ω of itself. Scaling rows and columns, or choosing other units, does not
/// change it, so light bodies count as much as heavy ones; a norm would ask little of them. It is
/// at least as large as residuals relative to ‖K‖ ‖x‖ + ‖b‖.
///
/// Where hardly anything adds up, far from all loads, ω would ask for digits of next to nothing
/// (Arioli, Demmel, Duff, "Solving sparse linear systems with sparse backward error", 1989). No
/// denominator therefore counts as less than kLeast of the largest |b| or of the largest |x|, of
/// the lesser of the two, all scaled by the diagonal: |x_i| √|K_ii|, |b_i| / √|K_ii|. Then |b − K
/// x| is at most ω (‖K‖ max|x| + max|b|) still, as K's largest entry bounds √|K_ii K_jj|.
///
/// Each node adds up its own rows, in the order of its blocks: K is kept both ways round, so that
/// all blocks are read by columns of the node's own rows, a vector each, one after another.

#include "base/executor.h"
#include "base/memory.h"

#include <hawser/factor.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::factor {

/// One block in the rows of a node.
struct ResidualTerm {
    std::int64_t value = 0;    ///< First of its values, by columns.
    std::int32_t scalar = 0;   ///< First scalar of its columns.
    std::int32_t columns = 0;  ///< Of the block.
};

/// Raw view for the kernel (isa/residual.cpp).
struct ResidualView {
    const std::int64_t* term;  ///< First term of each node, and one more at the end.
    const ResidualTerm* terms;
    const std::int64_t* scalar;  ///< First scalar of each node, and one more at the end.
    const double* values;
    const double* scale;  ///< Of each scalar: powers of two.
    const double* x;
    const double* b;
    double* r;     ///< Becomes b − K x.
    double guard;  ///< No scaled denominator counts as less.
};

/// Largest of some rows.
struct ResidualSize {
    double error = 0.0;  ///< ω; not finite where anything is not.
    double size = 0.0;   ///< Scaled |b − K x|.
};

/// K of a pattern in double. Vectors have 8 more numbers at the end, for vector loads.
class BlockResidual {
  public:
    static constexpr double kLeast = 0x1p-30;

    /// Room for a pattern. @throws std::bad_alloc.
    void reserve(const BlockPattern& pattern);

    /// Take the values of all blocks, or of one.
    void keep(std::span<const double> values, base::Executor& executor) noexcept;
    void keep(std::span<const double> values, std::int32_t block) noexcept;
    /// As they were given.
    [[nodiscard]] std::span<const double> values() const noexcept {
        return {store_.data(), static_cast<std::size_t>(value_.back())};
    }

    /// scale[i] = 2^k: a diagonal entry times its square is in [1, 4). Other scalars, with nothing
    /// on the diagonal, get 1. With S of these, S K S is a matrix that floats can hold; no bit of
    /// its factors depends on S unless something leaves their range.
    void find_scale(double* scale, base::Executor& executor) const noexcept;
    /// How many powers of two the scale of a node's scalars is off at most.
    [[nodiscard]] int off_scale(const double* scale, std::int32_t node) const noexcept;

    /// r = b − K x, and how much that is.
    ResidualSize run(const double* scale, const double* x, const double* b, double guard, double* r,
                     base::Executor& executor) noexcept;

    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    static constexpr int kNodes = 64, kBlocks = 256;  ///< Done by a task.
    void turn(std::size_t block) noexcept;

    struct Block {
        std::int8_t rows = 0, columns = 0;
    };
    std::vector<Block> blocks_;
    std::vector<std::int64_t> value_, scalar_, term_;
    std::vector<ResidualTerm> terms_;
    base::Array<double> store_;        ///< The values as given, then each block transposed.
    std::vector<ResidualSize> sizes_;  ///< One a task.
    std::size_t nodes_ = 0;
};

}  // namespace hawser::factor
