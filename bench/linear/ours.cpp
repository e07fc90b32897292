// SPDX-License-Identifier: Apache-2.0
#include "factor/numeric.h"
#include "factor/repair.h"
#include "index.h"
#include "linear/pieces.h"
#include "linear/placer.h"
#include "linear/solver.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace hawser::bench {
namespace {

class Ours final : public Solver {
  public:
    explicit Ours(Order order) : analysis_(planner(order)) {}

    void analyse(const Input& input, base::Executor& executor) override {
        form_ = input.form;
        analysis_.use(&executor);
        analysis_.plan(form_->pattern);
        find_places(executor);
    }
    /// Nodes keep their numbers; all that the analysis needs to know is in the pattern.
    void update(const Input& input, const std::vector<int>&, base::Executor& executor) override {
        form_ = input.form;
        analysis_.use(&executor);
        analysis_.update(form_->pattern);
        find_places(executor);
    }
    /// The values are written as the fronts are factored.
    void refresh(const Input& input, base::Executor&) override { input_ = input; }
    void factor(base::Executor& executor) override { check(start(x_.data(), executor)); }
    void factor_and_begin(std::vector<double>& x, base::Executor& executor) override {
        permute(x, executor);
        check(start(x_.data(), executor));
    }
    void finish(std::vector<double>& x, base::Executor& executor) override {
        numeric_.backward(symbolic_, x_.data(), executor);
        permute_back(x, executor);
    }
    void solve(std::vector<double>& x, base::Executor& executor) override {
        permute(x, executor);
        numeric_.solve(symbolic_, x_.data(), executor);
        permute_back(x, executor);
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
    static constexpr std::int64_t kScalars = 4096;  ///< Moved by a task at least.
    void permute(const std::vector<double>& x, base::Executor& executor) {
        in_pieces(
            std::ssize(place_), executor,
            [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t i = begin; i < end; ++i) x_[at(i)] = x[at(place_[at(i)])];
            },
            kScalars);
    }
    void permute_back(std::vector<double>& x, base::Executor& executor) const {
        in_pieces(
            std::ssize(place_), executor,
            [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t i = begin; i < end; ++i) x[at(place_[at(i)])] = x_[at(i)];
            },
            kScalars);
    }
    /// Where each block is written.
    void find_places(base::Executor& executor) {
        numeric_.reserve(symbolic_, executor.threads());
        placer_.place(*form_, analysis_, numeric_.pieces(), ops_, piece_ops_, executor);
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
