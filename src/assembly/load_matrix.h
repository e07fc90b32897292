// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file load_matrix.h
/// Symmetric matrices of up to six rows, stored as lower triangle, row by row (hawser/system.h).

#include "model/bodies.h"

#include <cstdint>

namespace hawser::assembly {

/// Return the number of entries of the triangle of `n` rows.
[[nodiscard]] constexpr int entries_of(int n) noexcept { return n * (n + 1) / 2; }

/// Return uᵀ S v for a symmetric matrix S of order n.
[[nodiscard]] double product(const double* s, int n, const double* u, const double* v) noexcept;
/// Add factor · S v to `out`, for a symmetric matrix S of order n.
void add_product(const double* s, int n, double factor, const double* v, double* out) noexcept;
/// True if a matrix is finite and positive semi-definite, independent of the units of its rows.
/// Uses L D Lᵀ of the matrix scaled to a unit diagonal.
[[nodiscard]] bool semidefinite(const double* m, int n) noexcept;
/// Replace a positive definite matrix by its Cholesky factor L.
void factor_triangle(double* m, int n) noexcept;
/// Replace x by (L Lᵀ)⁻¹ x.
void solve_triangle(const double* low, int n, double* x) noexcept;
/// Return tr M⁻¹ S of a positive definite matrix M, which is overwritten.
[[nodiscard]] double trace_over(double* m, const double* s, int n) noexcept;
/// Compute the mass matrix of a body in the world frame.
void mass_matrix(const model::Bodies& b, std::int32_t body, int n, double* out) noexcept;

}  // namespace hawser::assembly
