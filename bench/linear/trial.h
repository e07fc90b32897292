// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file trial.h
/// Runs solvers on a problem: finds the best variant of each library, then times all of them in
/// turns and takes medians.

#include "linear/problem.h"
#include "linear/sweeps.h"
#include "runtime/tasks.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

/// Times of one solution from blocks to refined result [s].
struct Phases {
    /// Compute the values from the blocks, condensed if the form is, and its right-hand side.
    double refresh = 0.0;
    /// Ours: includes the values of each part, computed just before its factorisation.
    double factor = 0.0;
    double solve = 0.0;   ///< Includes the eliminated rows.
    double refine = 0.0;  ///< Saddle residual, second solution, addition.
    [[nodiscard]] double total() const noexcept { return refresh + factor + solve + refine; }
};

/// Time of the update after contact changes.
struct UpdateTime {
    int changed = 0;    ///< Contacts.
    double time = 0.0;  ///< Median [s].
    /// A new analysis of the same systems, in turns with it; −1: the solver has no update.
    double anew = -1.0;
};

/// Results of one solver on one problem with one number of threads.
struct Result {
    std::string library, form, order, failure;
    int threads = 1;
    double analyse = 0.0;       ///< [s]
    double own_analyse = -1.0;  ///< With the library's own order; −1: none.
    Phases phases{};            ///< Medians.
    double total = 0.0;         ///< Median of the totals [s].
    std::vector<UpdateTime> update{};
    double factor_nnz = 0.0, flops = 0.0, bytes = 0.0, error = 0.0;
    std::vector<double> totals{};  ///< Each sample [s].
};

struct TrialOptions {
    int rounds = 11;                       ///< Turns of each solver.
    std::vector<std::string> libraries{};  ///< Substrings of names; empty: all.
    /// Numbers of contacts changed, if the problem has contacts.
    std::vector<int> edits{10, 50, 200};
    bool quick_choice = false;  ///< Try AMD on blocks only, for ours our own order.
    bool alternate = true;      ///< Keep all solvers in memory and alternate.
    bool updates = true;
    bool through_public = false;  ///< See all_variants().
};

/// One solver on one problem.
class Candidate {
  public:
    Candidate(Problem& problem, const Variant& variant, int threads);
    ~Candidate();

    /// @return time of the analysis [s].
    double analyse() { return analyse(problem_->input(variant_.condensed)); }
    double analyse(const Input& input);
    /// The same after contacts changed. @return time [s].
    double update(const Input& input, const std::vector<int>& changed);
    /// The library's own analysis of the scalar matrix. @return time [s], −1: it has none.
    double analyse_own();
    /// Refresh, factor, solve, refine. Threads are awake afterwards, until sleep().
    Phases work();
    void sleep();
    [[nodiscard]] const Variant& variant() const noexcept { return variant_; }
    [[nodiscard]] int threads() const noexcept { return threads_; }
    [[nodiscard]] const std::vector<double>& x() const noexcept { return vectors_.x; }
    [[nodiscard]] Solver& solver() noexcept { return *solver_; }

  private:
    [[nodiscard]] base::Executor& executor() noexcept { return pool_ ? *pool_ : serial(); }
    [[nodiscard]] static base::Executor& serial() noexcept;
    /// @return true if processor time is used, for one thread; else wall time.
    [[nodiscard]] bool processor_time() const noexcept { return threads_ == 1; }
    void wake();
    void rest();

    Problem* problem_;
    Variant variant_;
    int threads_;
    std::unique_ptr<Solver> solver_;
    std::unique_ptr<runtime::Pool> pool_;
    base::Executor* own_;  ///< Executor of the phases of the solver.
    SweepVectors vectors_;
};

/// The best variant of every library on this problem, alternated. @param all  Receives the
/// results of every variant that was tried.
[[nodiscard]] std::vector<Result> compare(Problem& problem, const ProblemSource& source,
                                          int threads, const TrialOptions& options,
                                          std::vector<Result>& all);

}  // namespace hawser::bench
