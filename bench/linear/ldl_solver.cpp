// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#if HAWSER_HAVE_LDL
extern "C" {
#include <amd.h>
#include <ldl.h>
}

#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// LDL (T. Davis), up-looking; the matrix is permuted before, and its upper triangle is read.
class LdlSolver final : public ScalarSolver {
  public:
    explicit LdlSolver(Order order) : ScalarSolver(order, Triangle::upper) {}

    /// It has no order of its own; its examples call AMD. With an order it needs both triangles.
    bool prepare_own(const Input& input) override {
        const Sparse& lower = input.matrix->lower;
        std::vector<std::int32_t> natural(static_cast<std::size_t>(lower.rows()));
        std::iota(natural.begin(), natural.end(), 0);
        full_.build(lower, std::move(natural), Triangle::full);
        return true;
    }
    void analyse_own() override {
        const int n = full_.size();
        const auto size = static_cast<std::size_t>(n);
        for (std::vector<int>* v : {&own_order_, &own_slot_, &own_parent_, &own_count_, &own_flag_})
            v->resize(size);
        own_start_.resize(size + 1);
        if (amd_order(n, full_.start.data(), full_.row.data(), own_order_.data(), nullptr,
                      nullptr) < 0)
            throw std::runtime_error("AMD failed");
        ldl_symbolic(n, full_.start.data(), full_.row.data(), own_start_.data(), own_parent_.data(),
                     own_count_.data(), own_flag_.data(), own_order_.data(), own_slot_.data());
        own_row_.resize(static_cast<std::size_t>(own_start_.back()));
        own_value_.resize(own_row_.size());
    }
    void factor(base::Executor&) override {
        const int n = matrix_.size();
        const int done =
            ldl_numeric(n, matrix_.start.data(), matrix_.row.data(), matrix_.value.data(),
                        start_.data(), parent_.data(), count_.data(), row_.data(), value_.data(),
                        d_.data(), y_.data(), pattern_.data(), flag_.data(), nullptr, nullptr);
        if (done != n) throw std::runtime_error("LDL: a zero pivot");
    }
    [[nodiscard]] double factor_nnz() const override {
        return static_cast<double>(start_.back()) + matrix_.size();
    }
    [[nodiscard]] double flops() const override {
        double sum = 0.0;
        for (const int c : count_) sum += static_cast<double>(c) * (c + 2);
        return sum;
    }

  protected:
    void analyse_pattern() override {
        const int n = matrix_.size();
        const auto size = static_cast<std::size_t>(n);
        start_.resize(size + 1);
        for (std::vector<int>* v : {&parent_, &count_, &pattern_, &flag_}) v->resize(size);
        d_.resize(size);
        y_.resize(size);
        ldl_symbolic(n, matrix_.start.data(), matrix_.row.data(), start_.data(), parent_.data(),
                     count_.data(), flag_.data(), nullptr, nullptr);
        row_.resize(static_cast<std::size_t>(start_.back()));
        value_.resize(row_.size());
    }
    void solve_permuted(std::vector<double>& x) override {
        const int n = matrix_.size();
        ldl_lsolve(n, x.data(), start_.data(), row_.data(), value_.data());
        ldl_dsolve(n, x.data(), d_.data());
        ldl_ltsolve(n, x.data(), start_.data(), row_.data(), value_.data());
    }

  private:
    std::vector<int> start_, parent_, count_, pattern_, flag_, row_;
    std::vector<double> value_, d_, y_;
    // Matrix of its own analysis.
    Permuted full_;
    std::vector<int> own_order_, own_slot_, own_start_, own_parent_, own_count_, own_flag_,
        own_row_;
    std::vector<double> own_value_;
};

}  // namespace

std::unique_ptr<Solver> make_ldl(Order order) { return std::make_unique<LdlSolver>(order); }

}  // namespace hawser::bench
#endif
