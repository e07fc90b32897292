// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"
#include "factor/repair.h"
#include "index.h"
#include "linear/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hawser::bench {
namespace {

/// Gives every block of a form its place in the panels. Blocks of a piece lie together, as pieces
/// end where fronts end; within a piece, which stays in cache while it is filled, alike ones follow
/// each other.
class Placer {
  public:
    using Range = std::pair<std::size_t, std::size_t>;

    /// @param of_piece  By piece: begin and end of its blocks.
    void place(const BlockForm& form, const factor::Analysis& analysis,
               const std::vector<factor::Piece>& pieces, std::vector<BlockWrite>& ops,
               std::vector<Range>& of_piece) {
        const factor::Symbolic& s = analysis.symbolic();
        rank_pieces(s, pieces);
        sort(form, s);
        of_piece.resize(pieces.size());
        for (std::size_t r = 0; r < pieces.size(); ++r)
            of_piece[at(by_place_[r].second)] = {at(r == 0 ? 0 : next_[r - 1]), at(next_[r])};
        ops.resize(form.ops.size());
        local_.resize(s.order.size());
        std::int32_t k = 0;
        for (const factor::Front& front : s.fronts) {
            const std::int32_t end = start_[at(front.node_end) - 1];
            if (front.batch >= 0) {
                for (; k < end; ++k)
                    put(form, s, index_[at(k)], ops,
                        [&](std::int32_t row, std::int32_t col) { return s.target(row, col); });
                continue;
            }
            find_rows(form, analysis, front);
            for (; k < end; ++k)
                put(form, s, index_[at(k)], ops, [&](std::int32_t row, std::int32_t col) {
                    const std::int64_t column = s.node_offset[at(col)] - front.offset;
                    const std::int32_t pivot = s.node_offset[at(row)] - front.offset;
                    const std::int32_t inside = -static_cast<std::int32_t>(pivot < front.p);
                    const std::int32_t place = (pivot & inside) | (local_[at(row)] & ~inside);
                    return factor::BlockTarget{front.panel + column * front.ld + place, 1,
                                               front.ld};
                });
        }
    }

  private:
    /// Pieces in the sequence of their panels, and the rank of each node's, by position.
    void rank_pieces(const factor::Symbolic& s, const std::vector<factor::Piece>& pieces) {
        by_place_.clear();
        for (const factor::Piece& p : pieces)
            by_place_.emplace_back(p.panel_begin, static_cast<std::int32_t>(by_place_.size()));
        std::sort(by_place_.begin(), by_place_.end());
        rank_.resize(s.order.size());
        step_rank_.resize(s.batch_steps.size());
        for (std::size_t r = 0; r < pieces.size(); ++r) {
            const factor::Piece& p = pieces[at(by_place_[r].second)];
            const auto rank = static_cast<std::int32_t>(r);
            if (p.begin == p.end)
                std::fill(step_rank_.begin() + p.step_begin, step_rank_.begin() + p.step_end, rank);
            else
                std::fill(rank_.begin() + s.fronts[at(p.begin)].node_begin,
                          rank_.begin() + s.fronts[at(p.end) - 1].node_end, rank);
        }
        if (s.batches.empty()) return;
        for (std::size_t k = 0; k < s.order.size(); ++k)
            if (const std::int32_t step = s.node_step[at(s.order[k])]; step >= 0)
                rank_[k] = step_rank_[at(step)];
    }

    /// Two counting sorts: by column, to find rows, and by piece, for where they end up.
    void sort(const BlockForm& form, const factor::Symbolic& s) {
        start_.assign(s.order.size(), 0);
        next_.assign(by_place_.size(), 0);
        column_.resize(form.ops.size());
        for (std::size_t i = 0; i < form.ops.size(); ++i) {
            const std::int32_t column =
                std::min(s.position[at(form.ops[i].row)], s.position[at(form.ops[i].col)]);
            column_[i] = column;
            ++start_[at(column)];
            ++next_[at(rank_[at(column)])];
        }
        for (auto* counts : {&start_, &next_}) {
            std::int32_t sum = 0;
            for (std::int32_t& k : *counts) sum += std::exchange(k, sum);
        }
        index_.resize(form.ops.size());
        to_.resize(form.ops.size());
        for (std::size_t i = 0; i < form.ops.size(); ++i)
            index_[at(start_[at(column_[i])]++)] = static_cast<std::int32_t>(i);
        for (const std::int32_t i : form.alike) to_[at(i)] = next_[at(rank_[at(column_[at(i)])])]++;
    }

    /// Rows of a front by node, where they are none of its pivots.
    void find_rows(const BlockForm& form, const factor::Analysis& analysis,
                   const factor::Front& front) {
        std::int32_t row = front.p;
        const std::int32_t last = analysis.symbolic().order[at(front.node_end - 1)];
        for (const std::int32_t v : analysis.columns().rows(last)) {
            local_[at(v)] = row;
            row += form.pattern.size[at(v)];
        }
    }

    /// Write block i of the form where it ends up. The row node must not come before the column
    /// node. @param target  Of (row, column).
    template <class Target>
    void put(const BlockForm& form, const factor::Symbolic& s, std::int32_t i,
             std::vector<BlockWrite>& ops, Target&& target) const {
        const BlockOp& from = form.ops[at(i)];
        const bool turned = s.position[at(from.row)] < s.position[at(from.col)];
        const std::int32_t row = turned ? from.col : from.row, col = turned ? from.row : from.col;
        const factor::BlockTarget to = target(row, col);
        ops[at(to_[at(i)])] = BlockWrite(from, turned, to.address, to.step, to.ld);
    }

    std::vector<std::pair<std::int64_t, std::int32_t>> by_place_;  ///< Panels, pieces.
    std::vector<std::int32_t> rank_, step_rank_, start_, next_, column_, index_, to_, local_;
};

class Ours final : public Solver {
  public:
    explicit Ours(Order order) : analysis_(planner(order)) {}

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
    factor::Analysis::Planner planner(Order order) {
        if (order == Order::library) return nullptr;
        if (order == Order::amd_blocks)
            return [this](const factor::Pattern& p) {
                factor::Elimination plan;
                orderer_.order(p, plan.order);
                return plan;
            };
        return [this, order](const factor::Pattern&) {
            return factor::Elimination{order_blocks(*form_, order), {}};
        };
    }
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
    /// Where each block is written.
    void find_places(base::Executor& executor) {
        numeric_.reserve(symbolic_, executor.threads());
        placer_.place(*form_, analysis_, numeric_.pieces(), ops_, piece_ops_);
        const std::size_t n = at(symbolic_.scalars);
        x_.resize(n + 8, 0.0);
        // What is written past the end of a node is written again by the next.
        constexpr std::int32_t kWide = 8;
        place_.resize(n + kWide);
        std::int32_t* place = place_.data();
        for (const std::int32_t a : symbolic_.order) {
            const std::int32_t offset = form_->offset[at(a)];
            for (std::int32_t i = 0; i < kWide; ++i) place[i] = offset + i;
            place += form_->pattern.size[at(a)];
        }
        place_.resize(n);
    }

    factor::Orderer orderer_;
    const BlockForm* form_ = nullptr;
    factor::Analysis analysis_;
    const factor::Symbolic& symbolic_ = analysis_.symbolic();
    factor::Numeric numeric_;
    std::vector<BlockWrite> ops_;
    std::vector<std::pair<std::size_t, std::size_t>> piece_ops_;  ///< Of each piece: begin, end.
    Input input_;
    std::vector<std::int32_t> place_;  ///< Of each permuted scalar in the form.
    std::vector<double> x_;
    Placer placer_;
};

}  // namespace

std::unique_ptr<Solver> make_ours(Order order) { return std::make_unique<Ours>(order); }

}  // namespace hawser::bench
