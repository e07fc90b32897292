// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solver.h
/// One interface for all compared solvers, and the list of their variants.
///
/// Forms, orders and threads:
/// - hawser: saddle and condensed; its own order, minimum degree alone, METIS on blocks; Hawser's
///   threads.
/// - hawser blocks: the same through hawser/factor.h.
/// - Eigen SimplicialLDLT, CHOLMOD simplicial, SuiteSparse LDL: both forms; all three orders; one
///   thread.
/// - CHOLMOD supernodal: condensed, as it has no LDLᵀ; all three orders; threads of the BLAS.
/// - KLU: both forms; all three orders and COLAMD; one thread.
/// - MUMPS: both forms with SYM = 1, without pivoting; all three orders; threads of the BLAS.

#include "linear/form.h"
#include "linear/scalar.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

/// Input of a solver: the blocks, the form, and the form's scalar matrix for libraries.
struct Input {
    const BlockSystem* system = nullptr;
    const BlockForm* form = nullptr;
    ScalarMatrix* matrix = nullptr;
    const std::vector<double>* inverse = nullptr;  ///< 1/Σ of eliminated rows.
};

class Solver {
  public:
    Solver() = default;
    virtual ~Solver() = default;
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// Compute the order and all other data that do not depend on values.
    virtual void analyse(const Input& input, base::Executor& executor) = 0;
    /// Analyse after the given nodes of the system, contacts, got other neighbours.
    virtual void update(const Input& input, const std::vector<int>& changed,
                        base::Executor& executor) {
        (void)changed;
        analyse(input, executor);
    }
    /// Run the library's own analysis of the scalar matrix like its users: default order, no
    /// permutation before, result unused. @return false if it has none.
    virtual bool prepare_own(const Input& input) {
        (void)input;
        return false;
    }
    virtual void analyse_own() {}
    /// Read values from the blocks of the system, condensed if the form is.
    virtual void refresh(const Input& input, base::Executor& executor) = 0;
    /// Factor. @throws std::runtime_error if it fails.
    virtual void factor(base::Executor& executor) = 0;
    /// Factor with a known right-hand side: a solver may start the solution of x, which finish()
    /// completes.
    virtual void factor_and_begin(std::vector<double>& x, base::Executor& executor) {
        (void)x;
        factor(executor);
    }
    virtual void finish(std::vector<double>& x, base::Executor& executor) { solve(x, executor); }
    /// Solve in place for the scalars of the kept nodes in natural order.
    virtual void solve(std::vector<double>& x, base::Executor& executor) = 0;
    /// Return the entries of L with its diagonal, as counted or stored by the library.
    [[nodiscard]] virtual double factor_nnz() const = 0;
    /// Return the flops of one factorisation; 0: not reported by the library.
    [[nodiscard]] virtual double flops() const { return 0.0; }
    /// Return the memory of the solver; 0: not known.
    [[nodiscard]] virtual double bytes() const { return 0.0; }
};

struct Variant {
    std::string library;
    bool condensed = false;
    Order order = Order::amd_scalars;
    bool threaded = false;  ///< True if the factorisation itself can use threads.
    std::unique_ptr<Solver> (*make)(Order order) = nullptr;

    [[nodiscard]] std::string form() const { return condensed ? "condensed" : "saddle"; }
};

/// Return every variant in this build, "hawser" first. @param through_public  Include "hawser
/// blocks".
[[nodiscard]] std::vector<Variant> all_variants(bool through_public);

std::unique_ptr<Solver> make_ours(Order order);
std::unique_ptr<Solver> make_public(Order order);
std::unique_ptr<Solver> make_eigen(Order order);
std::unique_ptr<Solver> make_cholmod_simplicial(Order order);
std::unique_ptr<Solver> make_cholmod_supernodal(Order order);
std::unique_ptr<Solver> make_ldl(Order order);
std::unique_ptr<Solver> make_klu(Order order);
std::unique_ptr<Solver> make_mumps(Order order);

/// Set the threads of the BLAS and of OpenMP, if they can be set.
void set_library_threads(int threads);
/// Return the name of the BLAS's kernels, e.g. "OpenBLAS SkylakeX"; "unknown" for another BLAS.
[[nodiscard]] std::string blas_core();

/// Permutes, gathers and scatters for libraries with a scalar matrix.
class ScalarSolver : public Solver {
  public:
    ScalarSolver(Order order, Triangle triangle) : order_(order), triangle_(triangle) {}
    void analyse(const Input& input, base::Executor& executor) override;
    void refresh(const Input& input, base::Executor& executor) override;
    void solve(std::vector<double>& x, base::Executor& executor) override;

  protected:
    virtual void analyse_pattern() = 0;
    virtual void solve_permuted(std::vector<double>& x) = 0;  ///< Solve in place.
    /// Return the address for the permuted values.
    virtual double* values() { return matrix_.value.data(); }

    Order order_;
    Triangle triangle_;
    Permuted matrix_;

  private:
    std::vector<double> permuted_;
};

}  // namespace hawser::bench
