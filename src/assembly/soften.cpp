// SPDX-License-Identifier: Apache-2.0
/// Minimum compliance of a cut. Two bodies are coupled by a row with Σ, Υ and recall R, and each
/// extrapolates the velocity of the other from the last step. They are stable if and only if
/// ```
///     A (1 + Υ (2 − R)) ≤ 2,   A = Σ over sides W/(W + Σ),   W = G M⁻¹ Gᵀ of the bodies of the
///     side
/// ```
/// (docs/theory/splits.md). Rows at the same body act together: W is multiplied by the number of
/// rows that are stiff compared with the body. A body with other interactions has a larger
/// effective mass, which adds a margin.
#include "assembly/mobility.h"
#include "assembly/system.h"
#include "base/index.h"

#include <hawser/row_constants.h>

#include <algorithm>

namespace hawser::assembly {
namespace {

constexpr double kBoundaryFraction = 0.9;  ///< Fraction of the stability boundary.
constexpr double kMinStiffRatio = 0.05;    ///< Minimum W/(W + Σ) of a row that counts.

double amplification(const std::vector<double>& w, double sigma) {
    double sum = 0.0;
    for (const double each : w) sum += each / (each + sigma);
    return sum;
}

/// Return the smallest Σ with an amplification A ≤ `most`. A decreases with Σ.
double min_sigma(const std::vector<double>& w, double sigma, double most) {
    if (amplification(w, sigma) <= most) return 0.0;
    double high = std::max(sigma, *std::max_element(w.begin(), w.end()));
    while (amplification(w, high) > most) high *= 2.0;
    double low = sigma;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (amplification(w, middle) > most ? low : high) = middle;
    }
    return high;
}

}  // namespace

void System::soften_sides(const model::Bodies& bodies, model::Interactions& in, double h) {
    if (sides.empty()) return;
    auto sigma_of = [&](std::size_t row) {
        return row_sigma(in.epsilon[row], in.upsilon[row], h) + model::kTinySigma;
    };
    std::vector<std::int32_t>& stiff = cursor_;
    stiff.assign(at(bodies.count()), 0);
    auto each_body = [&](const Sides& s, auto&& f) {
        for (std::int32_t id = s.first; id < s.first + s.count; ++id)
            for (int b = 0; b < in.bodies[at(id)]; ++b) {
                const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
                if (dof_[at(body)] > 0) f(id, body);
            }
    };
    for (const Sides& s : sides)
        each_body(s, [&](std::int32_t id, std::int32_t body) {
            for (int r = 0; r < in.rows[at(id)]; ++r) {
                const double w = mobility(bodies, in, id, r);
                if (w > kMinStiffRatio * (w + sigma_of(at(in.row_begin[at(id)] + r))))
                    ++stiff[at(body)];
            }
        });
    std::vector<double>& w = side_mobility_;
    for (const Sides& s : sides) {
        std::int32_t together = 1;
        each_body(s, [&](std::int32_t, std::int32_t body) {
            together = std::max(together, stiff[at(body)]);
        });
        for (int r = 0; r < in.rows[at(s.first)]; ++r) {
            w.clear();
            for (std::int32_t id = s.first; id < s.first + s.count; ++id)
                w.push_back(together * mobility(bodies, in, id, r));
            const auto first = at(in.row_begin[at(s.first)] + r);
            const double most =
                kBoundaryFraction * 2.0 / (1.0 + in.upsilon[first] * (2.0 - in.recall[first]));
            const double least = s.soften ? min_sigma(w, sigma_of(first), most) : 0.0;
            for (std::int32_t id = s.first; id < s.first + s.count; ++id)
                in.min_sigma[at(in.row_begin[at(id)] + r)] = least;
        }
    }
}

}  // namespace hawser::assembly
