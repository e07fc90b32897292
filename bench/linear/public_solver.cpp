// SPDX-License-Identifier: Apache-2.0
/// Hawser through hawser/factor.h: blocks are written to an array of values, which factor() copies.
#include "index.h"
#include "linear/solver.h"

#include <hawser/factor.h>

#include <fmt/core.h>

#include <stdexcept>

namespace hawser::bench {
namespace {

class PublicSolver final : public Solver {
  public:
    explicit PublicSolver(Order order) : order_(order) {}

    void analyse(const Input& input, base::Executor& executor) override {
        if (executor.threads() != threads_) {
            threads_ = executor.threads();
            factor_ = BlockFactor({.threads = threads_});
        }
        find_pattern(*input.form);
        if (order_ == Order::library)
            factor_.analyse(pattern_);
        else
            factor_.analyse(pattern_, order_ == Order::amd_blocks
                                          ? minimum_degree_order(pattern_)
                                          : order_blocks(*input.form, order_));
        find_places(*input.form);
    }
    void update(const Input& input, const std::vector<int>&, base::Executor&) override {
        find_pattern(*input.form);
        factor_.update(pattern_);
        find_places(*input.form);
    }
    void refresh(const Input& input, base::Executor& executor) override {
        assemble(*input.system, ops_, input.form->contributions, *input.inverse, values_.data(),
                 executor);
    }
    void factor(base::Executor&) override { check(factor_.factor(values_)); }
    void solve(std::vector<double>& x, base::Executor&) override {
        check(factor_.solve({x.data(), at(factor_.info().scalars)}));
    }
    [[nodiscard]] double factor_nnz() const override {
        return static_cast<double>(factor_.info().factor_nnz);
    }
    [[nodiscard]] double flops() const override {
        return static_cast<double>(factor_.info().flops);
    }
    [[nodiscard]] double bytes() const override {
        return static_cast<double>(factor_.info().bytes);
    }

  private:
    static void check(Status status) {
        if (status != Status::ok) throw std::runtime_error(to_string(status));
    }
    /// The form stores the columns of a block contiguously, so that its rows are used as columns.
    void find_pattern(const BlockForm& form) {
        pattern_.size = form.pattern.size;
        pattern_.sign = form.pattern.sign;
        pattern_.edges.clear();
        for (const BlockOp& op : form.ops)
            if (op.row != op.col) pattern_.edges.push_back({op.col, op.row});
    }
    void find_places(const BlockForm& form) {
        values_.assign(at(factor_.value_count()), 0.0);
        ops_.clear();
        auto edge = static_cast<std::int32_t>(pattern_.size.size());
        for (const BlockOp& op : form.ops) {
            const int rows = op.row_size;
            if (op.row == op.col)
                ops_.emplace_back(op, false, factor_.value_begin(op.row), rows, 1);
            else
                ops_.emplace_back(op, false, factor_.value_begin(edge++), 1, rows);
        }
    }

    Order order_;
    int threads_ = 0;
    BlockFactor factor_;
    BlockPattern pattern_;
    std::vector<BlockWrite> ops_;
    std::vector<double> values_;
};

}  // namespace

std::unique_ptr<Solver> make_public(Order order) { return std::make_unique<PublicSolver>(order); }

}  // namespace hawser::bench
