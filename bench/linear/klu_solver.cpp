// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#if HAWSER_HAVE_KLU
extern "C" {
#include <klu.h>
}

#include <stdexcept>

namespace hawser::bench {
namespace {

/// KLU: LU of the full matrix. Pivots on the diagonal, no scaling, no block triangular form. The
/// first factorisation finds the structure, klu_refactor reuses it.
class KluSolver final : public ScalarSolver {
  public:
    explicit KluSolver(Order order) : ScalarSolver(order, Triangle::full) {
        klu_defaults(&common_);
        common_.btf = 0;
        common_.scale = 0;
        common_.tol = 0.0;
        common_.ordering = order == Order::library ? 1 : 2;  // 1: COLAMD; 2: a given order
    }
    ~KluSolver() override {
        klu_free_numeric(&numeric_, &common_);
        klu_free_symbolic(&symbolic_, &common_);
    }
    KluSolver(const KluSolver&) = delete;
    KluSolver& operator=(const KluSolver&) = delete;

    void factor(base::Executor&) override {
        int* start = matrix_.start.data();
        int* row = matrix_.row.data();
        if (numeric_ == nullptr)
            numeric_ = klu_factor(start, row, matrix_.value.data(), symbolic_, &common_);
        else
            klu_refactor(start, row, matrix_.value.data(), symbolic_, numeric_, &common_);
        if (numeric_ == nullptr || common_.status != KLU_OK)
            throw std::runtime_error("KLU: singular");
    }
    [[nodiscard]] double factor_nnz() const override {
        return numeric_ == nullptr ? 0.0 : numeric_->lnz + numeric_->unz;
    }

  protected:
    void analyse_pattern() override {
        klu_free_numeric(&numeric_, &common_);
        klu_free_symbolic(&symbolic_, &common_);
        const int n = matrix_.size();
        symbolic_ = order_ == Order::library
                        ? klu_analyze(n, matrix_.start.data(), matrix_.row.data(), &common_)
                        : klu_analyze_given(n, matrix_.start.data(), matrix_.row.data(), nullptr,
                                            nullptr, &common_);
        if (symbolic_ == nullptr) throw std::runtime_error("KLU: analysis failed");
    }
    void solve_permuted(std::vector<double>& x) override {
        klu_solve(symbolic_, numeric_, matrix_.size(), 1, x.data(), &common_);
    }

  private:
    klu_common common_{};
    klu_symbolic* symbolic_ = nullptr;
    klu_numeric* numeric_ = nullptr;
};

}  // namespace

std::unique_ptr<Solver> make_klu(Order order) { return std::make_unique<KluSolver>(order); }

}  // namespace hawser::bench
#endif
