// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file small.h
/// Three-vectors and 3×3 matrices for code that is compiled once per instruction set.
///
/// All definitions live in `hawser::HAWSER_ISA`, a separate namespace for each instruction set.
/// Otherwise the linker could select an AVX version of a shared inline function on a machine
/// without AVX. For the same reason this code uses neither Eigen nor containers.

#ifndef HAWSER_ISA
#define HAWSER_ISA generic
#endif

namespace hawser::HAWSER_ISA {

/// T is double, or a vector with one lane per body or row (base/simd.h).
template <class T>
struct V3T {
    T x, y, z;
};
using V3 = V3T<double>;

template <class T>
inline V3T<T> operator+(const V3T<T>& a, const V3T<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
inline V3T<T> operator-(const V3T<T>& a, const V3T<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
inline V3T<T> operator-(const V3T<T>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
inline V3T<T> operator*(const T& s, const V3T<T>& a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T>
inline T dot(const V3T<T>& a, const V3T<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
inline V3T<T> cross(const V3T<T>& a, const V3T<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const V3& a) { return __builtin_sqrt(dot(a, a)); }
inline V3 load3(const double* p) { return {p[0], p[1], p[2]}; }
inline void store3(double* p, const V3& a) {
    p[0] = a.x;
    p[1] = a.y;
    p[2] = a.z;
}
inline bool any3(const double* d) { return d[0] != 0.0 || d[1] != 0.0 || d[2] != 0.0; }
inline void add3(double* p, const V3& a) {
    p[0] += a.x;
    p[1] += a.y;
    p[2] += a.z;
}

/// Row-major 3×3 matrix. The columns of a rotation are the axes of the body in the world frame.
template <class T>
struct M3T {
    T a[9];
};
using M3 = M3T<double>;

template <class T>
inline V3T<T> operator*(const M3T<T>& m, const V3T<T>& v) {
    return {m.a[0] * v.x + m.a[1] * v.y + m.a[2] * v.z, m.a[3] * v.x + m.a[4] * v.y + m.a[5] * v.z,
            m.a[6] * v.x + m.a[7] * v.y + m.a[8] * v.z};
}
/// Multiply the transpose by a vector: world to body.
template <class T>
inline V3T<T> tmul(const M3T<T>& m, const V3T<T>& v) {
    return {m.a[0] * v.x + m.a[3] * v.y + m.a[6] * v.z, m.a[1] * v.x + m.a[4] * v.y + m.a[7] * v.z,
            m.a[2] * v.x + m.a[5] * v.y + m.a[8] * v.z};
}
inline M3 load9(const double* p) {
    return {{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]}};
}
/// Return the rotation matrix of a unit quaternion q = (w, x, y, z).
template <class T>
inline M3T<T> rotation(const T* q, const T& unit) {
    const T w = q[0], x = q[1], y = q[2], z = q[3];
    return {{unit - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y),
             2.0 * (x * y + w * z), unit - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),
             2.0 * (x * z - w * y), 2.0 * (y * z + w * x), unit - 2.0 * (x * x + y * y)}};
}
inline M3 rotation(const double* q) { return rotation(q, 1.0); }
/// Compute R S Rᵀ for a full symmetric S given row-major.
template <class T>
inline M3T<T> congruence(const M3T<T>& r, const T* s) {
    M3T<T> t{}, o{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            t.a[3 * i + j] =
                r.a[3 * i] * s[j] + r.a[3 * i + 1] * s[3 + j] + r.a[3 * i + 2] * s[6 + j];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            o.a[3 * i + j] = t.a[3 * i] * r.a[3 * j] + t.a[3 * i + 1] * r.a[3 * j + 1] +
                             t.a[3 * i + 2] * r.a[3 * j + 2];
    return o;
}
/// Solve a symmetric or general 3×3 system by Cramer's rule (well-conditioned Jacobians only).
template <class T>
inline V3T<T> solve3(const M3T<T>& m, const V3T<T>& b) {
    const V3T<T> c0{m.a[0], m.a[3], m.a[6]}, c1{m.a[1], m.a[4], m.a[7]}, c2{m.a[2], m.a[5], m.a[8]};
    const V3T<T> k = cross(c1, c2);
    const T inv = 1.0 / dot(c0, k);
    return {inv * dot(b, k), inv * dot(c0, cross(b, c2)), inv * dot(c0, cross(c1, b))};
}

}  // namespace hawser::HAWSER_ISA
