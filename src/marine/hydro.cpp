// SPDX-License-Identifier: Apache-2.0
/// Check the coefficients of floating bodies, and compute K(t).
#include <hawser/def.h>
#include <hawser/hydro.h>

#include "base/dense.h"
#include "marine/checks.h"
#include "marine/radiation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hawser {
namespace {

constexpr std::size_t kMaxFrequencies = 100'000, kMostEntries = 20'000'000;

/// Return the lowest eigenvalue of a matrix with its diagonal scaled to ones. A row without a
/// diagonal is scaled by its other entries.
double lowest_scaled(const Matrix6& m, const Matrix6& size) {
    Matrix6 s = 0.5 * (m + m.transpose());
    double largest = 0.0;
    for (int i = 0; i < 6; ++i) largest = std::max(largest, std::abs(size(i, i)));
    if (!(largest > 0.0)) return 0.0;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            const double scale = std::sqrt(std::max(std::abs(size(i, i)), 1e-12 * largest) *
                                           std::max(std::abs(size(j, j)), 1e-12 * largest));
            s(i, j) /= scale;
        }
    return base::symmetric_eigenvalues(s)(0);
}

/// Tolerated negative damping: 5 % of the largest of each motion. Programs write three digits, and
/// have noise at irregular frequencies.
constexpr double kMinRelativeDamping = -0.05;

/// Return the nearest matrix without negative eigenvalues, scaled as in lowest_scaled().
Matrix6 without_negative_of(const Matrix6& m, const Matrix6& size) {
    double largest = 0.0;
    for (int i = 0; i < 6; ++i) largest = std::max(largest, std::abs(size(i, i)));
    marine::Vec6 scale;
    for (int i = 0; i < 6; ++i)
        scale[i] = std::sqrt(std::max(std::abs(size(i, i)), 1e-12 * largest));
    const Matrix6 s = scale.cwiseInverse().asDiagonal() * (0.5 * (m + m.transpose())) *
                      scale.cwiseInverse().asDiagonal();
    const auto eigen = base::symmetric_eigen(s);
    const marine::Vec6 kept = eigen.values.cwiseMax(0.0);
    return scale.asDiagonal() * (eigen.vectors * kept.asDiagonal() * eigen.vectors.transpose()) *
           scale.asDiagonal();
}

std::string sizes_fault(const WaveCoefficients& c) {
    const std::size_t n = c.frequency.size(), table = c.heading.size() * n * 6;
    if (n > kMaxFrequencies || c.heading.size() > kMaxFrequencies || table > kMostEntries)
        return "more than " + std::to_string(kMostEntries) + " entries";
    if (!c.added_mass.empty() && c.added_mass.size() != n)
        return "added_mass: " + std::to_string(c.added_mass.size()) + " matrices for " +
               std::to_string(n) + " frequencies";
    if (c.damping.size() != c.added_mass.size())
        return "damping: " + std::to_string(c.damping.size()) + " matrices beside " +
               std::to_string(c.added_mass.size()) + " of added mass; give both";
    for (std::size_t i = 0; i < n; ++i) {
        if (!(c.frequency[i] > 0.0 && c.frequency[i] < 1e4))
            return "frequency " + std::to_string(i) + ": " + number(c.frequency[i]) +
                   " rad/s; give more than 0 (A(0) and A(inf) have keys of their own)";
        if (i > 0 && !(c.frequency[i] > c.frequency[i - 1]))
            return "frequency " + std::to_string(i) + ": " + number(c.frequency[i]) +
                   " rad/s after " + number(c.frequency[i - 1]) + "; they have to ascend";
    }
    for (std::size_t i = 0; i < c.heading.size(); ++i)
        if (!(std::abs(c.heading[i]) <= 7.0) || (i > 0 && !(c.heading[i] > c.heading[i - 1])))
            return "heading " + std::to_string(i) + ": " + number(c.heading[i]) +
                   " rad; directions have to ascend, within two turns";
    const auto sized = [&](const char* name, std::size_t has) {
        return has == 0 || has == table
                   ? std::string()
                   : std::string(name) + ": " + std::to_string(has) + " entries; " +
                         std::to_string(table) + " belong to " + std::to_string(c.heading.size()) +
                         " directions of " + std::to_string(n) + " frequencies";
    };
    for (const std::string& fault :
         {sized("excitation", c.excitation.size()), sized("scattering", c.scattering.size()),
          sized("motion", c.motion.size()), sized("drift", c.drift.size())})
        if (!fault.empty()) return fault;
    return {};
}

std::string finite_fault(const WaveCoefficients& c) {
    const auto bad = [](const Matrix6& m) {
        return !m.allFinite() || !(m.cwiseAbs().maxCoeff() < 1e30);
    };
    for (std::size_t i = 0; i < c.added_mass.size(); ++i) {
        const std::string at = " at " + number(c.frequency[i]) + " rad/s";
        if (bad(c.added_mass[i])) return "added_mass" + at + ": a number is not finite";
        if (bad(c.damping[i])) return "damping" + at + ": a number is not finite";
    }
    if (bad(c.infinite) || bad(c.zero) || bad(c.stiffness))
        return "A(inf), A(0) or the stiffness: a number is not finite";
    if (!(c.reference.cwiseAbs().maxCoeff() <= 1e6)) return "reference: beyond 1e6 m";
    for (const auto* table : {&c.excitation, &c.scattering, &c.motion})
        for (std::size_t i = 0; i < table->size(); ++i)
            if (!(std::abs((*table)[i]) < 1e30))
                return "force of waves, direction " + std::to_string(i / 6 / c.frequency.size()) +
                       ", frequency " + std::to_string(i / 6 % c.frequency.size()) +
                       ": a number is not finite";
    for (const double d : c.drift)
        if (!(std::abs(d) < 1e30)) return "drift: a number is not finite";
    return {};
}

/// Return the largest damping of each motion over all frequencies, as a diagonal matrix.
Matrix6 largest_diagonal(const std::vector<Matrix6>& all) {
    Matrix6 out = Matrix6::Zero();
    for (const Matrix6& m : all)
        for (int i = 0; i < 6; ++i) out(i, i) = std::max(out(i, i), std::abs(m(i, i)));
    return out;
}

/// Check that the added masses A(0) and A(∞) are not exchanged in a file: A(0) − A(∞) must equal ∫
/// t K dt. @return the fault; "" if there is none.
std::string swapped_fault(const WaveCoefficients& c) {
    if (!c.has_infinite || !c.has_zero || c.frequency.size() < 4) return {};
    const Matrix6 reported = infinite_added_mass(c);
    double as_is = 0.0, swapped = 0.0, separation = 0.0;
    for (int i = 0; i < 6; ++i) {
        const double size = std::max(std::abs(c.infinite(i, i)), std::abs(c.zero(i, i)));
        if (!(size > 0.0)) continue;
        as_is += std::abs(reported(i, i) - c.infinite(i, i)) / size;
        swapped += std::abs(reported(i, i) - c.zero(i, i)) / size;
        separation += std::abs(c.zero(i, i) - c.infinite(i, i)) / size;
    }
    if (separation < 0.05 || swapped >= 0.5 * as_is) return {};
    return "A(inf) and A(0) are swapped: according to A(w) and B(w), A(inf) is nearer to the given "
           "A(0), for example in heave " +
           number(reported(2, 2)) + " kg where A(inf) is " + number(c.infinite(2, 2)) +
           " and A(0) " + number(c.zero(2, 2));
}

}  // namespace

std::string coefficients_fault(const WaveCoefficients& c) {
    if (std::string fault = sizes_fault(c); !fault.empty()) return fault;
    if (std::string fault = finite_fault(c); !fault.empty()) return fault;
    const Matrix6 size = largest_diagonal(c.damping);
    for (std::size_t i = 0; i < c.damping.size(); ++i)
        if (const double low = lowest_scaled(c.damping[i], size); low < kMinRelativeDamping)
            return "damping at " + number(c.frequency[i]) +
                   " rad/s is not positive semi-definite: scaled to ones, its lowest eigenvalue "
                   "is " +
                   number(low) +
                   (i > 0
                        ? "; give \"negative_damping\": \"truncate\" (damping from there on falls "
                          "as w^-3 from that of " +
                              number(c.frequency[i - 1]) + " rad/s) or \"fit\""
                        : "; give \"negative_damping\": \"fit\"") +
                   " (the nearest positive semi-definite matrices)";
    if (c.has_infinite)
        if (const double low = lowest_scaled(c.infinite, c.infinite); low < -1e-3)
            return "A(inf) is not positive semi-definite: scaled to ones, its lowest eigenvalue "
                   "is " +
                   number(low);
    return swapped_fault(c);
}

WaveCoefficients repaired_damping(const WaveCoefficients& c, NegativeDamping how) {
    WaveCoefficients out = c;
    if (how == NegativeDamping::refuse) return out;
    const Matrix6 size = largest_diagonal(c.damping);
    for (std::size_t i = 0; i < c.damping.size() && i < c.frequency.size(); ++i) {
        if (!c.damping[i].allFinite() || !(lowest_scaled(c.damping[i], size) < kMinRelativeDamping))
            continue;
        if (how == NegativeDamping::fit) {
            out.damping[i] = without_negative_of(c.damping[i], size);
            continue;
        }
        if (i == 0)
            throw DefError("damping at " + number(c.frequency[i]) +
                           " rad/s, the first frequency, is not positive semi-definite, and no "
                           "lower frequency exists from which it could be truncated; give "
                           "\"negative_damping\": \"fit\"");
        for (std::size_t k = i; k < c.damping.size(); ++k) {
            const double ratio = c.frequency[i - 1] / c.frequency[k];
            out.damping[k] = ratio * ratio * ratio * c.damping[i - 1];
        }
        break;
    }
    return out;
}

MemoryEnd memory_end(const WaveCoefficients& c, double memory, double limit) {
    MemoryEnd out;
    out.enough = memory;
    if (c.damping.empty() || !(memory > 0.0)) return out;
    const marine::DampingNodes nodes = marine::damping_nodes(c);
    const marine::Vec6 scale = marine::memory_scale(marine::retardation_of(nodes, 0.0));
    // Cosines within 0.8 % of their extremes.
    const double step = std::min(0.04 * 2.0 * std::numbers::pi / c.frequency.back(), 0.02 * memory);
    const auto largest = [&](double t) {
        const Matrix6 k = marine::retardation_of(nodes, t);
        double most = 0.0;
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                most = std::max(most, std::abs(k(i, j)) / (scale[i] * scale[j]));
        return most;
    };
    for (double t = 0.8 * memory; t <= memory * (1.0 + 1e-12); t += step)
        out.ratio = std::max(out.ratio, largest(t));
    if (out.ratio <= limit) return out;
    out.enough = std::numeric_limits<double>::quiet_NaN();
    double last = 0.8 * memory;  // end of the samples that exceed the limit
    for (double t = last; t <= 20.0 * memory; t += step) {
        if (largest(t) > 0.98 * limit) last = t + step;
        if (t > last / 0.8) {
            out.enough = last / 0.8;
            break;
        }
    }
    return out;
}

Matrix6 retardation(const WaveCoefficients& c, double t) {
    return marine::retardation_of(marine::damping_nodes(c), t);
}

Matrix6 infinite_added_mass(const WaveCoefficients& c) {
    // (1/ω) ∫ K sin ωt dt = (2/π) PV∫ B(σ)/(ω² − σ²) dσ …, B linear between nodes: Simpson's rule
    // of K to where it has ended is as good, and needs no principal value.
    const marine::DampingNodes nodes = marine::damping_nodes(c);
    Matrix6 sum = Matrix6::Zero();
    if (c.frequency.empty()) return sum;
    const double end = 30.0 * 2.0 * std::numbers::pi / (c.frequency.back() + c.frequency.front());
    const double step = 0.25 / nodes.frequency.back();
    const int n = 2 * std::clamp(static_cast<int>(0.5 * end / step), 50, 4000);
    const double dt = end / n;
    std::vector<Matrix6> k;
    for (int i = 0; i <= n; ++i)
        k.push_back(marine::retardation_of(nodes, i * dt) * marine::memory_window(i * dt, end));
    for (std::size_t f = 0; f < c.frequency.size(); ++f) {
        Matrix6 part = Matrix6::Zero();
        for (int i = 0; i <= n; ++i) {
            const double w = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            part +=
                w * dt / 3.0 * std::sin(c.frequency[f] * i * dt) * k[static_cast<std::size_t>(i)];
        }
        sum += c.added_mass[f] + part / c.frequency[f];
    }
    sum /= static_cast<double>(c.frequency.size());
    return 0.5 * (sum + sum.transpose());
}

}  // namespace hawser
