// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"
#include "factor/repair.h"
#include "index.h"
#include "linear/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// Sorts by address, so that the panels are written from front to back: least digit first, 11 bits
/// each.
class PlaceSorter {
  public:
    void sort(std::vector<BlockOp>& ops, std::int64_t size) {
        constexpr int kBits = 11;
        constexpr std::size_t kDigits = std::size_t{1} << kBits;
        keys_.resize(ops.size());
        other_.resize(ops.size());
        for (std::size_t i = 0; i < ops.size(); ++i)
            keys_[i] = {ops[i].to, static_cast<std::int64_t>(i)};
        for (int shift = 0; size >> shift != 0; shift += kBits) {
            const auto digit = [&](const Key& k) {
                return static_cast<std::size_t>(k.place >> shift) & (kDigits - 1);
            };
            start_.assign(kDigits + 1, 0);
            for (const Key& k : keys_) ++start_[digit(k) + 1];
            std::partial_sum(start_.begin(), start_.end(), start_.begin());
            for (const Key& k : keys_) other_[start_[digit(k)]++] = k;
            keys_.swap(other_);
        }
        sorted_.resize(ops.size());
        for (std::size_t i = 0; i < ops.size(); ++i) sorted_[i] = ops[at(keys_[i].index)];
        ops.swap(sorted_);
    }

  private:
    struct Key {
        std::int64_t place, index;
    };
    std::vector<Key> keys_, other_;
    std::vector<std::size_t> start_;
    std::vector<BlockOp> sorted_;
};

class Ours final : public Solver {
  public:
    explicit Ours(Order order)
        : order_(order), analysis_([this](const factor::Pattern& p) {
              if (order_ == Order::library) return factor::plan_elimination(p);
              return factor::Elimination{order_blocks(*form_, order_), {}};
          }) {}

    void analyse(const Input& input, base::Executor& executor) override {
        form_ = input.form;
        analysis_.plan(form_->pattern);
        find_places(executor);
    }
    /// Nodes keep their numbers; all that the analysis needs to know is in the pattern.
    void update(const Input& input, const std::vector<int>&, base::Executor& executor) override {
        form_ = input.form;
        analysis_.update(form_->pattern);
        find_places(executor);
    }
    void refresh(const Input& input, base::Executor& executor) override {
        numeric_.clear(symbolic_, executor);
        assemble(*input.system, ops_, form_->contributions, *input.inverse, numeric_.values(),
                 executor);
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
    /// Where each block is written.
    void find_places(base::Executor& executor) {
        numeric_.reserve(symbolic_, executor.threads());
        ops_ = form_->ops;
        reorient(ops_, symbolic_.position);
        for (BlockOp& op : ops_) {
            const factor::BlockTarget t = symbolic_.target(op.row, op.col);
            op.to = t.address;
            op.step = t.step;
            op.stride = t.ld;
        }
        sorter_.sort(ops_, symbolic_.panel_size);
        x_.assign(static_cast<std::size_t>(symbolic_.scalars) + 8, 0.0);
    }

    Order order_;
    const BlockForm* form_ = nullptr;
    factor::Analysis analysis_;
    const factor::Symbolic& symbolic_ = analysis_.symbolic();
    factor::Numeric numeric_;
    std::vector<BlockOp> ops_;
    std::vector<double> x_;
    PlaceSorter sorter_;
};

}  // namespace

std::unique_ptr<Solver> make_ours(Order order) { return std::make_unique<Ours>(order); }

}  // namespace hawser::bench
