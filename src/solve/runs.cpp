// SPDX-License-Identifier: Apache-2.0
#include "solve/runs.h"

#include "base/index.h"
#include "context/newton_data.h"
#include "context/view.h"
#include "solve/capstan_run.h"
#include "solve/impulse_range.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

using assembly::Capstan;
using assembly::CapstanEntry;
using assembly::View;

/// Places [first, last) of System::capstans, with entries from `entry` on, two each.
struct Run {
    std::size_t first, last, entry;
};

/// Call f(run) for all sequences of consecutive turning points along a line.
template <class F>
void each_run(const assembly::System& s, F&& f) noexcept {
    std::size_t entry = 0;
    for (std::size_t first = 0; first < s.capstans.size();) {
        std::size_t last = first + 1, end = entry + at(s.capstans[first].entries);
        while (s.capstans[first].entries == 2 && last < s.capstans.size() &&
               s.capstans[last].entries == 2 &&
               s.capstan_entries[end - 1].load == s.capstan_entries[end].load) {
            ++last;
            end += 2;
        }
        if (s.capstans[first].entries == 2) f(Run{first, last, entry});
        entry = end;
        first = last;
    }
}

std::int32_t side_of(const context::Model& model, const Capstan& c) noexcept {
    const auto id = at(c.friction);
    if (model.interactions.active[id] != 0.0) return 0;
    const double held = model.interactions.held[id];
    return held > 0.0 || (held == 0.0 && c.side > 0.0) ? 1 : -1;
}

/// Return gᵀ M⁻¹ g, the mobility of one body along the part g of a row. The mass of a scalar body
/// includes the terms of systems.
double mobility_of(const model::Bodies& b, const View& v, std::int32_t body, const double* jac) {
    const int dof = v.dof[body];
    if (dof == 1) return jac[0] * jac[0] / v.body_block[assembly::block_offset(v.dof_begin[body])];
    double sum = 0.0;
    for (int j = 0; j < dof && j < 3; ++j) sum += jac[j] * jac[j] / b.mass[at(body)];
    for (int i = 3; i < dof; ++i)
        for (int j = 3; j < dof; ++j)
            sum += jac[i] * b.inv_inertia[9 * at(body) + at(3 * (i - 3) + j - 3)] * jac[j];
    return sum;
}

/// Read the coefficients of a part of a run, for the slides at its ends. All other bodies at the
/// part count as independent.
void read_part(const context::Model& model, const View& v, std::int32_t id, std::int32_t slide_0,
               std::int32_t slide_1, context::RunPart& p, double* entry_0,
               double* entry_1) noexcept {
    p.id = id;
    p.row = v.row_begin[id];
    p.pulls = v.active[id] != 0.0;
    // A broken or replaced part never pulls again.
    p.one_sided =
        (v.flags[id] & model::kOneSided) != 0 && v.parted[id] == 0 && !model.wires.is_replaced(id);
    p.lambda = p.pulls ? v.lambda[p.row] : 0.0;
    double speed = 0.0, mobility = 0.0;
    const double* jac = v.jacobian + v.jac_begin[id];
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        if (body == slide_0 && entry_0 != nullptr) *entry_0 = jac[0];
        if (body == slide_1 && entry_1 != nullptr) *entry_1 = jac[0];
        if (body != slide_0 && body != slide_1) {
            for (int j = 0; j < v.dof[body]; ++j) speed += jac[j] * v.v_new[v.dof_begin[body] + j];
            mobility += mobility_of(model.bodies, v, body, jac);
        }
        jac += v.dof[body];
    }
    p.softness = mobility + v.sigma[p.row];
    p.asked = v.c[p.row] - speed + mobility * p.lambda;
}

void read_place(const context::Model& model, const context::Newton& newton, const View& v,
                const Capstan& c, const CapstanEntry* loads, context::RunPoint& p) noexcept {
    const model::Interactions& in = model.interactions;
    const auto id = at(c.friction);
    const std::int32_t row = in.row_begin[id], dof = v.dof_begin[c.body];
    p.mass = v.body_block[assembly::block_offset(dof)];
    p.free = v.a[dof] / p.mass;
    p.hold = v.c[row];
    p.sigma = v.sigma[row];
    p.low = newton.bound_time * in.low[id];
    p.high = newton.bound_time * in.high[id];
    for (int k = 0; k < 2; ++k) p.fraction[k] = loads[k].factor;
    p.side = side_of(model, c);
    p.was = static_cast<std::int32_t>(c.was);
}

void read_run(const context::Model& model, context::Newton& newton, const View& v,
              const Run& run) noexcept {
    const assembly::System& s = model.system;
    const std::size_t n = run.last - run.first;
    const CapstanEntry* entry = &s.capstan_entries[run.entry];
    for (std::size_t k = 0; k < n; ++k)
        read_place(model, newton, v, s.capstans[run.first + k], entry + 2 * k,
                   newton.run_points[k]);
    for (std::size_t i = 0; i <= n; ++i) {
        const std::int32_t id = i < n ? entry[2 * i].load : entry[2 * n - 1].load;
        const std::int32_t first = i > 0 ? s.capstans[run.first + i - 1].body : -1;
        const std::int32_t second = i < n ? s.capstans[run.first + i].body : -1;
        read_part(model, v, id, first, second, newton.run_parts[i],
                  i > 0 ? &newton.run_points[i - 1].behind : nullptr,
                  i < n ? &newton.run_points[i].before : nullptr);
        const bool ends_later = i < n;
        newton.run_parts[i].was =
            ends_later ? entry[2 * i].was_active != 0 : entry[2 * n - 1].was_active != 0;
    }
}

void adopt(context::Model& model, const context::Newton& newton, const Run& run) noexcept {
    model::Interactions& in = model.interactions;
    const std::size_t n = run.last - run.first;
    for (std::size_t i = 0; i <= n; ++i) {
        const context::RunPart& p = newton.run_parts[i];
        in.active[at(p.id)] = p.pulls ? 1.0 : 0.0;
        in.held[at(p.id)] = 0.0;
        in.lambda[at(p.row)] = p.pulls ? p.lambda : 0.0;
    }
    for (std::size_t k = 0; k < n; ++k) {
        Capstan& c = model.system.capstans[run.first + k];
        const context::RunPoint& p = newton.run_points[k];
        const auto id = at(c.friction);
        in.active[id] = p.side == 0 ? 1.0 : 0.0;
        if (p.side == 0) continue;
        c.side = p.side;
        const ImpulseRange range = impulse_range(model, newton, c.friction);
        in.held[id] = p.side > 0 ? range.high : range.low;
        in.lambda[at(in.row_begin[id])] = in.held[id];
    }
}

}  // namespace

void reserve_runs(const context::Model& model, context::Newton& newton) {
    newton.run_points.resize(model.system.capstans.size());
    newton.run_parts.resize(model.system.capstans.size() + 1);
}

void note_runs(context::Model& model) noexcept {
    for (CapstanEntry& e : model.system.capstan_entries)
        e.was_active = model.interactions.active[at(e.load)] != 0.0 ? 1 : 0;
    for (Capstan& c : model.system.capstans) c.was = side_of(model, c);
}

double largest_in_run(const context::Model& model, std::int32_t friction) noexcept {
    const assembly::System& s = model.system;
    double largest = 0.0;
    each_run(s, [&](const Run& run) {
        if (s.capstans[run.first].friction > friction ||
            s.capstans[run.last - 1].friction < friction)
            return;
        for (std::size_t k = run.entry; k < run.entry + 2 * (run.last - run.first); ++k) {
            const auto row = at(model.interactions.row_begin[at(s.capstan_entries[k].load)]);
            largest = std::max(largest, std::fabs(model.interactions.lambda[row]));
        }
    });
    return largest;
}

void settle_runs(context::Model& model, context::Newton& newton) noexcept {
    const View v = context::row_view(model);
    each_run(model.system, [&](const Run& run) {
        const std::size_t n = run.last - run.first;
        read_run(model, newton, v, run);
        if (find_statuses(n, newton.run_points.data(), newton.run_parts.data()))
            adopt(model, newton, run);
    });
}

}  // namespace hawser::solve
