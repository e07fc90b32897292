// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"
#include "factor/repair.h"
#include "index.h"
#include "linear/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace hawser::bench {
namespace {

/// Gives every block of a form its place in the panels, and brings the blocks into the sequence of
/// the columns, so that the panels are written from front to back.
class Placer {
  public:
    void place(const BlockForm& form, const factor::Analysis& analysis, std::vector<BlockOp>& ops) {
        const factor::Symbolic& s = analysis.symbolic();
        sort_by_column(form, s);
        ops.resize(form.ops.size());
        local_.resize(s.order.size());
        for (const factor::Front& front : s.fronts) {
            if (front.batch >= 0) continue;
            // Where each update row of this front is.
            std::int32_t row = front.p;
            for (const std::int32_t v : analysis.columns().rows(s.order[at(front.node_end - 1)])) {
                local_[at(v)] = row;
                row += form.pattern.size[at(v)];
            }
            for (auto k = at(start_[at(front.node_begin)]); k < at(start_[at(front.node_end)]);
                 ++k) {
                const BlockOp& op = ops[k] = turned(form.ops[at(index_[k])], s.position);
                const std::int32_t offset = s.node_offset[at(op.row)] - front.offset;
                const std::int32_t column = s.node_offset[at(op.col)] - front.offset;
                write(ops[k], {front.panel + static_cast<std::int64_t>(column) * front.ld +
                                   (offset < front.p ? offset : local_[at(op.row)]),
                               1, front.ld});
            }
        }
        for (auto k = at(start_[s.order.size()]); k < ops.size(); ++k) {
            ops[k] = turned(form.ops[at(index_[k])], s.position);
            write(ops[k], s.target(ops[k].row, ops[k].col));
        }
    }

    /// Where block i of the form is among the ops.
    [[nodiscard]] std::size_t where(std::int32_t i) const { return at(where_[at(i)]); }

  private:
    /// A counting sort; chains come last, those in the lanes of one step together.
    void sort_by_column(const BlockForm& form, const factor::Symbolic& s) {
        const std::size_t n = s.order.size();
        key_ = s.position;
        for (std::size_t v = 0; v < s.node_step.size(); ++v)
            if (s.node_step[v] >= 0) key_[v] = static_cast<std::int32_t>(n) + s.node_step[v];
        start_.assign(n + s.batch_steps.size() + 1, 0);
        column_key_.resize(form.ops.size());
        for (std::size_t i = 0; i < form.ops.size(); ++i) {
            const std::size_t row = at(form.ops[i].row), column = at(form.ops[i].col);
            column_key_[i] = s.position[row] < s.position[column] ? key_[row] : key_[column];
            ++start_[at(column_key_[i])];
        }
        std::int32_t sum = 0;
        for (std::int32_t& k : start_) sum += std::exchange(k, sum);
        cursor_ = start_;
        index_.resize(form.ops.size());
        where_.resize(form.ops.size());
        for (std::size_t i = 0; i < form.ops.size(); ++i)
            index_[at(where_[i] = cursor_[at(column_key_[i])]++)] = static_cast<std::int32_t>(i);
    }

    /// The row node must not come before the column node.
    static BlockOp turned(BlockOp op, const std::vector<std::int32_t>& position) {
        if (position[at(op.row)] >= position[at(op.col)]) return op;
        std::swap(op.row, op.col);
        std::swap(op.row_size, op.col_size);
        op.by_rows = !op.by_rows;
        op.turned = !op.turned;
        return op;
    }

    static void write(BlockOp& op, const factor::BlockTarget& t) {
        op.to = t.address;
        op.step = t.step;
        op.stride = t.ld;
    }

    std::vector<std::int32_t> key_, start_, cursor_, column_key_, index_, where_, local_;
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
    /// The values are written as the fronts are factored.
    void refresh(const Input& input, base::Executor&) override { input_ = input; }
    void factor(base::Executor& executor) override { check(start(x_.data(), executor)); }
    void factor_and_begin(std::vector<double>& x, base::Executor& executor) override {
        permute(x);
        check(start(x_.data(), executor));
    }
    void finish(std::vector<double>& x, base::Executor& executor) override {
        numeric_.backward(symbolic_, x_.data(), executor);
        permute_back(x);
    }
    void solve(std::vector<double>& x, base::Executor& executor) override {
        permute(x);
        numeric_.solve(symbolic_, x_.data(), executor);
        permute_back(x);
    }
    [[nodiscard]] double factor_nnz() const override {
        return static_cast<double>(symbolic_.factor_nnz);
    }
    [[nodiscard]] double flops() const override { return static_cast<double>(symbolic_.flops); }
    [[nodiscard]] double bytes() const override {
        return static_cast<double>(symbolic_.bytes() + numeric_.bytes());
    }

  private:
    int start(double* x, base::Executor& executor) {
        auto write = [](void* self, int piece, double* panel) noexcept {
            static_cast<Ours*>(self)->write(at(piece), panel);
        };
        return numeric_.factor_forward(symbolic_, {write, this}, x, executor);
    }
    void write(std::size_t piece, double* panel) const noexcept {
        const auto [begin, end] = piece_ops_[piece];
        assemble(*input_.system, std::span(ops_).subspan(begin, end - begin), form_->contributions,
                 *input_.inverse, panel);
    }
    static void check(int wrong) {
        if (wrong != 0) throw std::runtime_error(fmt::format("{} pivots of the wrong sign", wrong));
    }
    void permute(const std::vector<double>& x) {
        for (std::size_t i = 0; i < place_.size(); ++i) x_[i] = x[at(place_[i])];
    }
    void permute_back(std::vector<double>& x) const {
        for (std::size_t i = 0; i < place_.size(); ++i) x[at(place_[i])] = x_[i];
    }
    /// The blocks of each piece: they lie together, as pieces end where fronts end. Within a piece,
    /// which stays in cache while it is filled, alike ones follow each other.
    void sort_by_piece() {
        const std::vector<factor::Piece>& pieces = numeric_.pieces();
        piece_ops_.resize(pieces.size());
        by_place_.resize(pieces.size());
        std::iota(by_place_.begin(), by_place_.end(), std::size_t{0});
        std::sort(by_place_.begin(), by_place_.end(), [&](std::size_t a, std::size_t b) {
            return pieces[a].panel_begin < pieces[b].panel_begin;
        });
        piece_of_.resize(ops_.size());
        next_.resize(pieces.size());
        std::size_t k = 0;
        for (const std::size_t piece : by_place_) {
            const std::size_t begin = k;
            while (k < ops_.size() && ops_[k].to < pieces[piece].panel_end) ++k;
            piece_ops_[piece] = {begin, k};
            std::fill_n(piece_of_.begin() + static_cast<std::ptrdiff_t>(begin), k - begin,
                        static_cast<std::int32_t>(piece));
            next_[piece] = begin;
        }
        grouped_.resize(ops_.size());
        for (const std::int32_t i : form_->alike) {
            const std::size_t from = placer_.where(i);
            grouped_[next_[at(piece_of_[from])]++] = ops_[from];
        }
        ops_.swap(grouped_);
    }
    /// Where each block is written.
    void find_places(base::Executor& executor) {
        numeric_.reserve(symbolic_, executor.threads());
        placer_.place(*form_, analysis_, ops_);
        sort_by_piece();
        x_.resize(static_cast<std::size_t>(symbolic_.scalars) + 8, 0.0);
        place_.resize(static_cast<std::size_t>(symbolic_.scalars));
        for (std::size_t a = 0; a < form_->kept.size(); ++a)
            for (int i = 0; i < form_->pattern.size[a]; ++i)
                place_[at(symbolic_.node_offset[a] + i)] = form_->offset[a] + i;
    }

    Order order_;
    const BlockForm* form_ = nullptr;
    factor::Analysis analysis_;
    const factor::Symbolic& symbolic_ = analysis_.symbolic();
    factor::Numeric numeric_;
    std::vector<BlockOp> ops_;
    std::vector<std::pair<std::size_t, std::size_t>> piece_ops_;  ///< Of each piece: begin, end.
    std::vector<std::size_t> by_place_, next_;
    std::vector<std::int32_t> piece_of_;
    std::vector<BlockOp> grouped_;
    Input input_;
    std::vector<std::int32_t> place_;  ///< Of each permuted scalar in the form.
    std::vector<double> x_;
    Placer placer_;
};

}  // namespace

std::unique_ptr<Solver> make_ours(Order order) { return std::make_unique<Ours>(order); }

}  // namespace hawser::bench
