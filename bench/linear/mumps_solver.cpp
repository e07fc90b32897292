// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#if HAWSER_HAVE_MUMPS
extern "C" {
#include <dmumps_c.h>
}

#include <fmt/core.h>
#include <numeric>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// MUMPS without MPI. SYM = 1 accepts pivots of either sign in their order. This holds if the root
/// front is not factored by ScaLAPACK, which the version without MPI lacks.
class MumpsSolver final : public ScalarSolver {
  public:
    explicit MumpsSolver(Order order) : ScalarSolver(order, Triangle::lower) {
        data_.job = -1;
        data_.par = 1;
        data_.sym = 1;
        data_.comm_fortran = -987654;  // MPI_COMM_WORLD
        dmumps_c(&data_);
        for (int k = 1; k <= 4; ++k) icntl(k) = k == 4 ? 0 : -1;  // silent
        icntl(6) = 0;                                             // no maximum transversal
        icntl(7) = 1;                                             // the order is given
        icntl(8) = 0;                                             // no scaling
        icntl(10) = 0;                                            // refinement is done by this
                                                                  // program
        icntl(13) = 1;                                            // no ScaLAPACK
    }
    ~MumpsSolver() override {
        data_.job = -2;
        dmumps_c(&data_);
    }
    MumpsSolver(const MumpsSolver&) = delete;
    MumpsSolver& operator=(const MumpsSolver&) = delete;

    void factor(base::Executor&) override { run(2); }
    [[nodiscard]] double factor_nnz() const override {
        // INFOG(9): entries of the factors; negative: millions.
        const double n = data_.infog[8];
        return n < 0 ? -1e6 * n : n;
    }
    [[nodiscard]] double flops() const override { return data_.rinfog[2]; }

  protected:
    void analyse_pattern() override {
        const int n = matrix_.size();
        row_.clear();
        column_.clear();
        for (int j = 0; j < n; ++j)
            for (int k = matrix_.start[static_cast<std::size_t>(j)];
                 k < matrix_.start[static_cast<std::size_t>(j) + 1]; ++k) {
                row_.push_back(matrix_.row[static_cast<std::size_t>(k)] + 1);
                column_.push_back(j + 1);
            }
        place_.resize(static_cast<std::size_t>(n));
        std::iota(place_.begin(), place_.end(), 1);
        data_.n = n;
        data_.nnz = static_cast<MUMPS_INT8>(row_.size());
        data_.irn = row_.data();
        data_.jcn = column_.data();
        data_.a = matrix_.value.data();
        data_.perm_in = place_.data();
        run(1);
    }
    void solve_permuted(std::vector<double>& x) override {
        data_.rhs = x.data();
        data_.nrhs = 1;
        data_.lrhs = data_.n;
        run(3);
    }

  private:
    int& icntl(int k) { return data_.icntl[k - 1]; }
    void run(int job) {
        data_.job = job;
        dmumps_c(&data_);
        if (data_.infog[0] < 0)
            throw std::runtime_error(fmt::format("MUMPS: error {}", data_.infog[0]));
    }
    DMUMPS_STRUC_C data_{};
    std::vector<int> row_, column_, place_;
};

}  // namespace

std::unique_ptr<Solver> make_mumps(Order order) { return std::make_unique<MumpsSolver>(order); }

}  // namespace hawser::bench
#endif
