// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"
#include "index.h"
#include "linear/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// By address, so that the panels are written from front to back: least digit first, 11 bits each.
void sort_by_place(std::vector<BlockOp>& ops, std::int64_t size) {
    constexpr int kBits = 11;
    constexpr std::size_t kDigits = std::size_t{1} << kBits;
    struct Key {
        std::int64_t place;
        std::size_t index;
    };
    std::vector<Key> keys(ops.size()), other(ops.size());
    for (std::size_t i = 0; i < ops.size(); ++i) keys[i] = {ops[i].to, i};
    std::vector<std::size_t> start(kDigits + 1);
    for (int shift = 0; size >> shift != 0; shift += kBits) {
        const auto digit = [&](const Key& k) {
            return static_cast<std::size_t>(k.place >> shift) & (kDigits - 1);
        };
        std::fill(start.begin(), start.end(), 0);
        for (const Key& k : keys) ++start[digit(k) + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (const Key& k : keys) other[start[digit(k)]++] = k;
        keys.swap(other);
    }
    std::vector<BlockOp> sorted(ops.size());
    for (std::size_t i = 0; i < ops.size(); ++i) sorted[i] = ops[keys[i].index];
    ops.swap(sorted);
}

class Ours final : public Solver {
  public:
    explicit Ours(Order order) : order_(order) {}

    void analyse(const Input& input, base::Executor& executor) override {
        const BlockForm& form = *input.form;
        form_ = &form;
        symbolic_ = order_ == Order::library
                        ? factor::analyse(form.pattern, factor::plan_elimination(form.pattern))
                        : factor::analyse(form.pattern, order_blocks(form, order_));
        numeric_.reserve(symbolic_, executor.threads());
        contributions_ = form.contributions;
        ops_ = form.ops;
        reorient(ops_, contributions_, symbolic_.position);
        for (BlockOp& op : ops_) {
            const factor::BlockTarget t = symbolic_.target(op.row, op.col);
            op.to = t.address;
            op.step = t.step;
            op.stride = t.ld;
        }
        sort_by_place(ops_, symbolic_.panel_size);
        x_.assign(static_cast<std::size_t>(symbolic_.scalars) + 8, 0.0);
    }
    void refresh(const Input& input, base::Executor& executor) override {
        numeric_.clear(symbolic_, executor);
        assemble(*input.system, ops_, contributions_, *input.inverse, numeric_.values(), executor);
    }
    void factor(base::Executor& executor) override {
        if (const int wrong = numeric_.factor(symbolic_, executor); wrong != 0)
            throw std::runtime_error(fmt::format("{} pivots of the wrong sign", wrong));
    }
    void solve(std::vector<double>& x, base::Executor& executor) override {
        for (std::size_t a = 0; a < form_->kept.size(); ++a)
            for (int i = 0; i < form_->pattern.size[a]; ++i)
                x_[at(symbolic_.node_offset[a] + i)] = x[at(form_->offset[a] + i)];
        numeric_.solve(symbolic_, x_.data(), executor);
        for (std::size_t a = 0; a < form_->kept.size(); ++a)
            for (int i = 0; i < form_->pattern.size[a]; ++i)
                x[at(form_->offset[a] + i)] = x_[at(symbolic_.node_offset[a] + i)];
    }
    [[nodiscard]] double factor_nnz() const override {
        return static_cast<double>(symbolic_.factor_nnz);
    }
    [[nodiscard]] double flops() const override { return static_cast<double>(symbolic_.flops); }
    [[nodiscard]] double bytes() const override {
        return static_cast<double>(symbolic_.bytes() + numeric_.bytes());
    }

  private:
    Order order_;
    const BlockForm* form_ = nullptr;
    factor::Symbolic symbolic_;
    factor::Numeric numeric_;
    std::vector<BlockOp> ops_;
    std::vector<Contribution> contributions_;
    std::vector<double> x_;
};

}  // namespace

std::unique_ptr<Solver> make_ours(Order order) { return std::make_unique<Ours>(order); }

}  // namespace hawser::bench
