// SPDX-License-Identifier: Apache-2.0
/// Energy of loads. With the impulse of loads.h and v̄ = (v + v₊)/2, the effect of a load on a body
/// is impulse · v̄. It is work − loss − change, exact up to rounding.
///     Work   = h f·v̄ − (h²/4)(v₊ − v)ᵀK v̄.
///     Loss   = h (θ v₊ + (1 − θ) v)ᵀD v̄.
///     Change = ½ v₊ᵀA v₊ − ½ vᵀA v, in the energy of the added mass.
#include "assembly/load_matrix.h"
#include "assembly/loads.h"
#include "base/index.h"

#include <algorithm>

namespace hawser::assembly {

double LoadStore::added_between(const model::Bodies& bodies, const double* v, std::int32_t begin,
                                std::int32_t end) const noexcept {
    double sum = 0.0;
    for (std::int32_t body = begin; body < end; ++body) {
        if (!loaded(body)) continue;
        const Entry& e = entries_[at(entry_of_[at(body)])];
        const double* u = v + bodies.dof_begin[at(body)];
        sum += 0.5 * product(&data_[at(e.place + e.freedom)], e.freedom, u, u);
    }
    return sum;
}

void LoadStore::works(const model::Bodies& bodies, double h, const double* v, const double* u,
                      std::int32_t begin, std::int32_t end, Works& sum) const noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        if (!loaded(body)) continue;
        const auto e = at(entry_of_[at(body)]);
        const int n = entries_[e].freedom, size = entries_of(n);
        const double* f = &data_[at(entries_[e].place)];
        const double *a = f + n, *d = a + size, *k = d + size;
        const double *before = v + bodies.dof_begin[at(body)], *after = u + (before - v);
        double mean[6], gain[6], damping_velocity[6];
        for (int i = 0; i < n; ++i) {
            mean[i] = 0.5 * (before[i] + after[i]);
            gain[i] = after[i] - before[i];
            damping_velocity[i] = late_[e] * after[i] + (1.0 - late_[e]) * before[i];
            sum.work += h * f[i] * mean[i];
        }
        const double sprung = 0.25 * h * h * product(k, n, gain, mean);
        const double damping_work = h * product(d, n, damping_velocity, mean);
        sum.work -= sprung;
        sum.damped += damping_work;
        sum.added += 0.5 * product(a, n, after, after);
        const double* wf = water_of(e);
        if (wf == nullptr) continue;
        const double *wa = wf + n, *wd = wa + size, *wk = wd + size;
        for (int i = 0; i < n; ++i) sum.water += h * wf[i] * mean[i];
        const bool alone = wf == f;  // its terms are then those above
        sum.water -= (alone ? sprung : 0.25 * h * h * product(wk, n, gain, mean)) +
                     (alone ? damping_work : h * product(wd, n, damping_velocity, mean)) +
                     product(wa, n, gain, mean);
    }
}

template <class F>
LoadStore::Works LoadStore::sum(base::Executor& executor, F&& f) noexcept {
    over_loads(executor, static_cast<std::int32_t>(entry_of_.size()),
               [&](std::int32_t a, std::int32_t b) {
                   Works& part = part_[at(a / kLoadChunk)];
                   part = {};
                   f(a, b, part);
               });
    Works all;
    for (const Works& w : part_) {
        all.work += w.work;
        all.damped += w.damped;
        all.added += w.added;
        all.water += w.water;
    }
    return all;
}

double LoadStore::added_energy(const model::Bodies& bodies, const double* v,
                               base::Executor& executor) noexcept {
    if (!any_) return 0.0;
    const Works all = sum(executor, [&](std::int32_t a, std::int32_t b, Works& w) {
        w.added = added_between(bodies, v, a, b);
    });
    return all.added;
}

void LoadStore::count_change(const model::Bodies& bodies, base::Executor& executor) noexcept {
    if (any_ || added != 0.0) change_ = added_energy(bodies, bodies.v.data(), executor) - added;
}

void LoadStore::measure(const model::Bodies& bodies, double h, const double* v, const double* next,
                        base::Executor& executor) noexcept {
    taken_ = {};
    measured_ = any_ || added != 0.0;
    if (!any_) return;
    taken_ = sum(executor, [&](std::int32_t a, std::int32_t b, Works& w) {
        works(bodies, h, v, next, a, b, w);
    });
}

double LoadStore::gain(const model::Bodies& bodies, double h, const double* v,
                       const double* next) const noexcept {
    double sum = 0.0;
    for (std::int32_t body = 0; body < static_cast<std::int32_t>(entry_of_.size()); ++body) {
        if (!loaded(body)) continue;
        const Entry& e = entries_[at(entry_of_[at(body)])];
        const std::int32_t begin = bodies.dof_begin[at(body)];
        for (int i = 0; i < e.freedom; ++i)
            sum += h * data_[at(e.place + i)] * (next[begin + i] - v[begin + i]);
    }
    return sum;
}

double LoadStore::count() noexcept {
    if (!measured_) return 0.0;
    work += taken_.work + change_;
    water += taken_.water;
    added = taken_.added;
    change_ = 0.0;
    measured_ = false;
    return taken_.damped;
}

}  // namespace hawser::assembly
