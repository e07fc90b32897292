// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#if HAWSER_HAVE_CHOLMOD
#include <cholmod.h>

#include <algorithm>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// The order is applied before: natural order for CHOLMOD. Simplicial LDLᵀ reads the upper
/// triangle, supernodal LLᵀ the lower, without a copy. CHOLMOD postorders, which its supernodes
/// need.
class CholmodSolver final : public ScalarSolver {
  public:
    CholmodSolver(Order order, bool supernodal)
        : ScalarSolver(order, supernodal ? Triangle::lower : Triangle::upper),
          supernodal_(supernodal) {
        cholmod_start(&common_);
        common_.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
        common_.final_ll = supernodal ? 1 : 0;
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_NATURAL;
        common_.postorder = 1;
        common_.print = 0;
        cholmod_start(&own_common_);
        own_common_.supernodal = common_.supernodal;
        own_common_.nmethods = 1;
        own_common_.method[0].ordering = CHOLMOD_AMD;
        own_common_.print = 0;
    }
    ~CholmodSolver() override {
        cholmod_free_factor(&factor_, &common_);
        cholmod_free_factor(&own_, &own_common_);
        cholmod_finish(&own_common_);
        cholmod_free_dense(&x_, &common_);
        cholmod_free_dense(&y_, &common_);
        cholmod_free_dense(&e_, &common_);
        cholmod_finish(&common_);
    }
    CholmodSolver(const CholmodSolver&) = delete;
    CholmodSolver& operator=(const CholmodSolver&) = delete;

    bool prepare_own(const Input& input) override {
        natural_ = &input.matrix->lower;
        return true;
    }
    /// Analyse with AMD, its first choice; no other order is tried.
    void analyse_own() override {
        cholmod_sparse view{};
        view.nrow = view.ncol = static_cast<std::size_t>(natural_->rows());
        view.nzmax = static_cast<std::size_t>(natural_->nonZeros());
        view.p = const_cast<int*>(natural_->outerIndexPtr());
        view.i = const_cast<int*>(natural_->innerIndexPtr());
        view.x = const_cast<double*>(natural_->valuePtr());
        view.stype = -1;
        view.itype = CHOLMOD_INT;
        view.xtype = CHOLMOD_REAL;
        view.sorted = view.packed = 1;
        cholmod_free_factor(&own_, &own_common_);
        own_ = cholmod_analyze(&view, &own_common_);
        if (own_ == nullptr) throw std::runtime_error("CHOLMOD: analysis failed");
    }
    void factor(base::Executor&) override {
        cholmod_factorize(&view_, factor_, &common_);
        if (common_.status != CHOLMOD_OK) throw std::runtime_error("CHOLMOD: status not OK");
    }
    [[nodiscard]] double factor_nnz() const override { return common_.lnz; }
    [[nodiscard]] double flops() const override { return common_.fl; }

  protected:
    void analyse_pattern() override {
        view_ = {};
        view_.nrow = view_.ncol = static_cast<std::size_t>(matrix_.size());
        view_.nzmax = matrix_.row.size();
        view_.p = matrix_.start.data();
        view_.i = matrix_.row.data();
        view_.x = matrix_.value.data();
        view_.stype = supernodal_ ? -1 : 1;
        view_.itype = CHOLMOD_INT;
        view_.xtype = CHOLMOD_REAL;
        view_.sorted = view_.packed = 1;
        cholmod_free_factor(&factor_, &common_);
        factor_ = cholmod_analyze(&view_, &common_);
        if (factor_ == nullptr) throw std::runtime_error("CHOLMOD: analysis failed");
    }
    void solve_permuted(std::vector<double>& x) override {
        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = x.size();
        b.ncol = 1;
        b.x = x.data();
        b.xtype = CHOLMOD_REAL;
        if (cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &x_, nullptr, &y_, &e_, &common_) == 0)
            throw std::runtime_error("CHOLMOD: solve failed");
        std::copy_n(static_cast<const double*>(x_->x), x.size(), x.begin());
    }

  private:
    bool supernodal_;
    cholmod_common common_{}, own_common_{};
    cholmod_sparse view_{};
    cholmod_factor *factor_ = nullptr, *own_ = nullptr;
    const Sparse* natural_ = nullptr;
    cholmod_dense *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

}  // namespace

std::unique_ptr<Solver> make_cholmod_simplicial(Order order) {
    return std::make_unique<CholmodSolver>(order, false);
}
std::unique_ptr<Solver> make_cholmod_supernodal(Order order) {
    return std::make_unique<CholmodSolver>(order, true);
}

}  // namespace hawser::bench
#endif
