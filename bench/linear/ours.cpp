// SPDX-License-Identifier: Apache-2.0
#include "linear/ours.h"

#include "index.h"
#include "linear/pieces.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace hawser::bench {
namespace {

void check(int wrong) {
    if (wrong != 0) throw std::runtime_error(fmt::format("{} pivots of the wrong sign", wrong));
}

constexpr std::int64_t kScalars = 4096;  ///< Least number of scalars moved by a task.

}  // namespace

factor::Analysis::Planner Ours::planner(Order order) {
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

void Ours::plan(const Input& input, base::Executor& executor) {
    form_ = input.form;
    analysis_.use(&executor);
    analysis_.plan(form_->pattern);
}

void Ours::repair(const Input& input, base::Executor& executor) {
    form_ = input.form;
    analysis_.use(&executor);
    analysis_.update(form_->pattern);
}

void Ours::analyse(const Input& input, base::Executor& executor) {
    plan(input, executor);
    find_places(executor);
}

void Ours::update(const Input& input, const std::vector<int>&, base::Executor& executor) {
    repair(input, executor);
    find_places(executor);
}

void Ours::find_places(base::Executor& executor) {
    numeric_.reserve(symbolic_, executor.threads());
    placer_.place(*form_, analysis_, numeric_.pieces(), ops_, piece_ops_, executor);
    const std::size_t n = at(symbolic_.scalars);
    x_.resize(n + 8, 0.0);
    // Entries written past the end of a node are overwritten by the next one.
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

void Ours::refresh(const Input& input, base::Executor&) { input_ = input; }

void Ours::factor(base::Executor& executor) { check(start(x_.data(), executor)); }

void Ours::factor_and_begin(std::vector<double>& x, base::Executor& executor) {
    permute(x, executor);
    check(start(x_.data(), executor));
}

void Ours::finish(std::vector<double>& x, base::Executor& executor) {
    numeric_.backward(symbolic_, x_.data(), executor);
    permute_back(x, executor);
}

void Ours::solve(std::vector<double>& x, base::Executor& executor) {
    permute(x, executor);
    numeric_.solve(symbolic_, x_.data(), executor);
    permute_back(x, executor);
}

int Ours::start(double* x, base::Executor& executor) {
    auto write = [](void* self, int piece, double* panel) noexcept {
        static_cast<Ours*>(self)->write(at(piece), panel);
    };
    return numeric_.factor_forward(symbolic_, {write, this}, x, executor);
}

void Ours::write(std::size_t piece, double* panel) const noexcept {
    const auto [begin, end] = piece_ops_[piece];
    assemble(*input_.system, std::span(ops_).subspan(begin, end - begin), form_->contributions,
             *input_.inverse, panel);
}

void Ours::write_values() noexcept {
    for (std::size_t i = 0; i < piece_ops_.size(); ++i) write(i, numeric_.values());
}

void Ours::permute(const std::vector<double>& x, base::Executor& executor) {
    in_pieces(
        std::ssize(place_), executor,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) x_[at(i)] = x[at(place_[at(i)])];
        },
        kScalars);
}

void Ours::permute_back(std::vector<double>& x, base::Executor& executor) const {
    in_pieces(
        std::ssize(place_), executor,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) x[at(place_[at(i)])] = x_[at(i)];
        },
        kScalars);
}

std::unique_ptr<Solver> make_ours(Order order) { return std::make_unique<Ours>(order); }

}  // namespace hawser::bench
