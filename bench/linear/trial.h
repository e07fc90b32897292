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
    /// Values from the blocks, condensed if the form is, and its right-hand side.
    double refresh = 0.0;
    double factor = 0.0;  ///< Hawser: including the values of each part, written just before it is
                          ///< factored.
    double solve = 0.0;   ///< Includes unfolding of eliminated rows.
    double refine = 0.0;  ///< Saddle residual, second solution, addition.
    [[nodiscard]] double total() const noexcept { return refresh + factor + solve + refine; }
};

/// Time to follow changed contacts.
struct UpdateTime {
    int changed = 0;                      ///< Number of contacts.
    double time = 0.0;                    ///< Median [s].
    double analysis_from_scratch = -1.0;  ///< Time of a new analysis of the same systems, in turns
                                          ///< with it; −1: the solver has no other method.
};

/// Reported results of one solver on one problem with one number of threads.
struct Result {
    std::string library, form, order, failure;
    int threads = 1;
    double analyse = 0.0;              ///< [s]
    double own_order_analysis = -1.0;  ///< With the library's own order; −1: none.
    Phases phases{};                   ///< Medians.
    double total = 0.0;                ///< Median of the totals [s].
    std::vector<UpdateTime> update{};
    double factor_nnz = 0.0, flops = 0.0, bytes = 0.0, error = 0.0;
    std::vector<double> totals{};  ///< Each sample [s].
};

struct TrialOptions {
    int rounds = 11;                       ///< Number of turns of each solver.
    std::vector<std::string> libraries{};  ///< Parts of names; empty: all.
    std::vector<int> edits{10, 50, 200};   ///< Numbers of changed contacts, if the problem has any.
    bool quick_choice = false;             ///< Try only AMD on blocks; for Hawser only its own
                                           ///< order.
    bool run_in_turns = true;              ///< Keep all solvers in memory and alternate.
    bool updates = true;
    bool through_public = false;  ///< See all_variants().
};

/// One solver on one problem.
class Candidate {
  public:
    Candidate(Problem& problem, const Variant& variant, int threads);
    ~Candidate();

    /// Analyse. @return time [s].
    double analyse() { return analyse(problem_->input(variant_.condensed)); }
    double analyse(const Input& input);
    /// Analyse after contacts changed. @return time [s].
    double update(const Input& input, const std::vector<int>& changed);
    /// Run the library's own analysis of the scalar matrix. @return time [s]; −1: it has none.
    double analyse_own();
    /// Refresh, factor, solve, refine. Threads stay awake afterwards, until sleep().
    Phases work();
    void sleep();
    [[nodiscard]] const Variant& variant() const noexcept { return variant_; }
    [[nodiscard]] int threads() const noexcept { return threads_; }
    [[nodiscard]] const std::vector<double>& x() const noexcept { return vectors_.x; }
    [[nodiscard]] Solver& solver() noexcept { return *solver_; }

  private:
    [[nodiscard]] base::Executor& executor() noexcept { return pool_ ? *pool_ : serial(); }
    [[nodiscard]] static base::Executor& serial() noexcept;
    /// True if the processor time is measured: with one thread. Several threads are timed by wall
    /// time.
    [[nodiscard]] bool processor_time() const noexcept { return threads_ == 1; }
    void wake();
    void sleep_pool();

    Problem* problem_;
    Variant variant_;
    int threads_;
    std::unique_ptr<Solver> solver_;
    std::unique_ptr<runtime::Pool> pool_;
    base::Executor* own_;  ///< Executor of the solver's own phases.
    SweepVectors vectors_;
};

/// Compare the best variants of every library on this problem, in turns. @param all  Receives the
/// results of every tried variant.
[[nodiscard]] std::vector<Result> compare(Problem& problem, const ProblemSource& source,
                                          int threads, const TrialOptions& options,
                                          std::vector<Result>& all);

}  // namespace hawser::bench
