// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#include <dlfcn.h>

#include <numeric>

namespace hawser::bench {
namespace {

template <class F>
F symbol(const char* name) {
    return reinterpret_cast<F>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

void set_library_threads(int threads) {
    static const auto blas = symbol<void (*)(int)>("openblas_set_num_threads");
    static const auto omp = symbol<void (*)(int)>("omp_set_num_threads");
    if (blas != nullptr) blas(threads);
    if (omp != nullptr) omp(threads);
}

std::string blas_core() {
    const auto name = symbol<char* (*)()>("openblas_get_corename");
    return name == nullptr ? "unknown" : std::string("OpenBLAS ") + name();
}

std::vector<Variant> all_variants(bool through_public) {
    std::vector<Variant> all;
    constexpr Order kBlockOrders[] = {Order::library, Order::amd_blocks, Order::metis_blocks};
    constexpr Order kOrders[] = {Order::amd_scalars, Order::amd_blocks, Order::metis_blocks};
    auto possible = [](Order order) {
        return HAWSER_HAVE_METIS != 0 || order != Order::metis_blocks;
    };
    auto add = [&](const char* name, auto make, bool threaded, bool saddle) {
        for (const bool condensed : {false, true})
            for (const Order order : kOrders)
                if (possible(order) && (condensed || saddle))
                    all.push_back({name, condensed, order, threaded, make});
    };
    for (const bool condensed : {false, true})
        for (const Order order : kBlockOrders)
            if (possible(order)) all.push_back({"hawser", condensed, order, true, make_ours});
    for (const bool condensed : {false, true})
        for (const Order order : kBlockOrders) {
            if (!through_public || !possible(order)) continue;
            all.push_back({"hawser blocks", condensed, order, true, make_public});
        }
    add("Eigen SimplicialLDLT", make_eigen, false, true);
#if HAWSER_HAVE_CHOLMOD
    add("CHOLMOD simplicial", make_cholmod_simplicial, false, true);
    add("CHOLMOD supernodal", make_cholmod_supernodal, true, false);
#endif
#if HAWSER_HAVE_LDL
    add("SuiteSparse LDL", make_ldl, false, true);
#endif
#if HAWSER_HAVE_KLU
    add("KLU", make_klu, false, true);
    for (const bool condensed : {false, true})
        all.push_back({"KLU", condensed, Order::library, false, make_klu});
#endif
#if HAWSER_HAVE_MUMPS
    add("MUMPS", make_mumps, true, true);
#endif
    return all;
}

void ScalarSolver::analyse(const Input& input, base::Executor&) {
    const Sparse& lower = input.matrix->lower;
    std::vector<std::int32_t> order(static_cast<std::size_t>(lower.rows()));
    if (order_ == Order::library)
        std::iota(order.begin(), order.end(), 0);
    else
        order = input.matrix->order_scalars(*input.form, order_);
    matrix_.build(lower, std::move(order), triangle_);
    permuted_.resize(matrix_.order.size());
    analyse_pattern();
}

void ScalarSolver::refresh(const Input& input, base::Executor& executor) {
    input.matrix->refresh(*input.system, *input.form, *input.inverse, executor);
    matrix_.gather(input.matrix->lower, values(), executor);
}

void ScalarSolver::solve(std::vector<double>& x, base::Executor&) {
    const std::size_t n = permuted_.size();
    for (std::size_t k = 0; k < n; ++k)
        permuted_[k] = x[static_cast<std::size_t>(matrix_.order[k])];
    solve_permuted(permuted_);
    for (std::size_t k = 0; k < n; ++k)
        x[static_cast<std::size_t>(matrix_.order[k])] = permuted_[k];
}

}  // namespace hawser::bench
