// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solver.h
/// One interface for all solvers compared, and the list of their variants.
///
/// Forms, orders and threads:
/// - hawser: saddle and condensed; its own order, minimum degree alone, METIS on blocks; ours.
/// - hawser blocks: the same through hawser/factor.h.
/// - Eigen SimplicialLDLT, CHOLMOD simplicial, SuiteSparse LDL: both; all three; one thread.
/// - CHOLMOD supernodal: condensed, as it has no LDLᵀ; all three; those of BLAS.
/// - KLU: both; all three and COLAMD; one thread.
/// - MUMPS: both with SYM = 1, without pivoting; all three; those of BLAS.

#include "linear/form.h"
#include "linear/scalar.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

/// Input of a solver: the blocks, the form, and the scalar matrix of the form for libraries.
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
    /// Update the analysis after the given nodes of the system, contacts, have new neighbours.
    virtual void update(const Input& input, const std::vector<int>& changed,
                        base::Executor& executor) {
        (void)changed;
        analyse(input, executor);
    }
    /// Run the library's own analysis of the scalar matrix, as its users call it. It uses the
    /// default order and no permutation beforehand; the result is not used. @return true if the
    /// library has one.
    virtual bool prepare_own(const Input& input) {
        (void)input;
        return false;
    }
    virtual void analyse_own() {}
    /// Compute the values from the blocks of the system, condensed if the form is.
    virtual void refresh(const Input& input, base::Executor& executor) = 0;
    /// @throws std::runtime_error if it fails.
    virtual void factor(base::Executor& executor) = 0;
    /// Factor with a known right-hand side: a solver may begin with x, which finish() completes.
    virtual void factor_and_begin(std::vector<double>& x, base::Executor& executor) {
        (void)x;
        factor(executor);
    }
    virtual void finish(std::vector<double>& x, base::Executor& executor) { solve(x, executor); }
    /// Solve for the scalars of the kept nodes in natural order, in place.
    virtual void solve(std::vector<double>& x, base::Executor& executor) = 0;
    /// Return the entries of L with its diagonal, as the library counts or stores them.
    [[nodiscard]] virtual double factor_nnz() const = 0;
    /// Return the flops of one factorisation; 0: unknown.
    [[nodiscard]] virtual double flops() const { return 0.0; }
    /// Return the memory of the solver; 0: unknown.
    [[nodiscard]] virtual double bytes() const { return 0.0; }
};

struct Variant {
    std::string library;
    bool condensed = false;
    Order order = Order::amd_scalars;
    bool threaded = false;  ///< The factorisation itself can use threads.
    std::unique_ptr<Solver> (*make)(Order order) = nullptr;

    [[nodiscard]] std::string form() const { return condensed ? "condensed" : "saddle"; }
};

/// Return every variant in this build; "hawser" is first. @param through_public  With "hawser
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

/// Set the threads of the BLAS and of OpenMP if possible.
void set_library_threads(int threads);
/// Return the name of the kernels of the BLAS, e.g. "OpenBLAS SkylakeX"; "unknown" for another
/// BLAS.
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
    virtual void solve_permuted(std::vector<double>& x) = 0;  ///< In place.
    /// Return the array for the permuted values.
    virtual double* values() { return matrix_.value.data(); }

    Order order_;
    Triangle triangle_;
    Permuted matrix_;

  private:
    std::vector<double> permuted_;
};

}  // namespace hawser::bench
