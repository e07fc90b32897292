// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ours.h
/// Hawser's factorisation as one of the compared solvers, and in separate steps for timing.

#include "factor/numeric.h"
#include "factor/repair.h"
#include "linear/placer.h"
#include "linear/solver.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace hawser::bench {

/// Writes the values of a few fronts just before it factors them, and continues with the
/// substitution while they are in cache, like a time step.
class Ours final : public Solver {
  public:
    explicit Ours(Order order) : analysis_(planner(order)) {}

    void analyse(const Input& input, base::Executor& executor) override;
    /// Update the analysis. Nodes keep their numbers; the pattern has all data of the analysis.
    void update(const Input& input, const std::vector<int>& changed,
                base::Executor& executor) override;
    /// Compute order and structure: the first part of analyse() and update(). The second part finds
    /// the address of each block.
    void plan(const Input& input, base::Executor& executor);
    void repair(const Input& input, base::Executor& executor);
    void find_places(base::Executor& executor);

    /// Do nothing: values are written as the fronts are factored.
    void refresh(const Input& input, base::Executor& executor) override;
    void factor(base::Executor& executor) override;
    void factor_and_begin(std::vector<double>& x, base::Executor& executor) override;
    void finish(std::vector<double>& x, base::Executor& executor) override;
    void solve(std::vector<double>& x, base::Executor& executor) override;
    /// Write all values separately. The factor is lost.
    void write_values() noexcept;
    [[nodiscard]] double factor_nnz() const override {
        return static_cast<double>(symbolic_.factor_nnz);
    }
    [[nodiscard]] double flops() const override { return static_cast<double>(symbolic_.flops); }
    [[nodiscard]] double bytes() const override {
        return static_cast<double>(symbolic_.bytes() + numeric_.bytes());
    }

  private:
    factor::Analysis::Planner planner(Order order);
    int start(double* x, base::Executor& executor);
    void write(std::size_t piece, double* panel) const noexcept;
    void permute(const std::vector<double>& x, base::Executor& executor);
    void permute_back(std::vector<double>& x, base::Executor& executor) const;

    factor::Orderer orderer_;
    const BlockForm* form_ = nullptr;
    factor::Analysis analysis_;
    const factor::Symbolic& symbolic_ = analysis_.symbolic();
    factor::Numeric numeric_;
    std::vector<BlockWrite> ops_;
    std::vector<Placer::Range> piece_ops_;  ///< Begin and end for each piece.
    Input input_;
    std::vector<std::int32_t> place_;  ///< Index in the form of each permuted scalar.
    std::vector<double> x_;
    Placer placer_;
};

}  // namespace hawser::bench
