// SPDX-License-Identifier: Apache-2.0
#include "contact/iterate.h"

#include "base/index.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "nonsmooth/cone.h"

#include <algorithm>
#include <cmath>

namespace hawser::contact {
namespace {

using assembly::Contacts;
using nonsmooth::Cone;
using nonsmooth::Resistance;

/// True if the difference of a law from the law in the matrix leaves at most a hundredth of the
/// defect after the iteration. A unit of impulse changes u by at most W + Σ, and u_n by at most Σ_n
/// if the contact is closed.
bool is_close(const Cone& c, const nonsmooth::Law& law) noexcept {
    constexpr double kClose = 0.01;
    double normal = 0.0, tangential = 0.0;
    for (int i = 0; i < 3; ++i) {
        normal = std::max(normal, std::fabs(law.s[3 * i] - c.s[3 * i]));
        for (int j = 1; j < 3; ++j)
            tangential = std::max(tangential, std::fabs(law.s[3 * i + j] - c.s[3 * i + j]));
    }
    return normal * c.sigma_n <= kClose && tangential * (c.mobility + c.sigma_t) <= kClose;
}

/// Keep the slope S of the law in the matrix, and shift its offset so that the impulse at the
/// iterate is that of another law.
void keep_law_slope(Cone& c, const nonsmooth::Law& law) noexcept {
    for (int i = 0; i < 3; ++i) {
        c.p[i] = law.p[i];
        for (int j = 0; j < 3; ++j) c.p[i] += (c.s[3 * i + j] - law.s[3 * i + j]) * c.u[j];
    }
}

/// Write the laws of resistances, and the blocks of contacts that are marked as changed.
void adopt_resistance_laws(context::Model& model, const context::Newton& newton,
                           runtime::Pool& pool) noexcept {
    Contacts& contacts = model.system.contacts;
    assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        nonsmooth::Resistance& a = resistances.laws[k];
        const nonsmooth::ResistanceLaw& law = newton.turns[k];
        const bool same =
            std::equal(law.s, law.s + 9, a.s) && std::equal(law.column, law.column + 3, a.column);
        if (!same) contacts.changed[at(resistances.rows[k].contact)] = 1;
        std::copy_n(law.s, 9, a.s);
        std::copy_n(law.column, 3, a.column);
        std::copy_n(law.p, 3, a.p);
    }
    contacts.mark_blocks();
    context::over(pool, static_cast<std::int32_t>(contacts.blocks.size()),
                  [&](std::int32_t a, std::int32_t b) { contacts.write_blocks(a, b); });
}

}  // namespace

void adopt_laws(context::Model& model, const context::Newton& newton, runtime::Pool& pool,
                bool first) noexcept {
    Contacts& contacts = model.system.contacts;
    for (std::size_t k = 0; k < contacts.count(); ++k) {
        Cone& c = contacts.cones[k];
        const nonsmooth::Law& law = newton.laws[k];
        contacts.changed[k] = first || !std::equal(law.s, law.s + 9, c.s) ? 1 : 0;
        std::copy_n(law.s, 9, c.s);
        std::copy_n(law.p, 3, c.p);
    }
    adopt_resistance_laws(model, newton, pool);
}

void adopt_changed_laws(context::Model& model, const context::Newton& newton,
                        runtime::Pool& pool) noexcept {
    Contacts& contacts = model.system.contacts;
    for (std::size_t k = 0; k < contacts.count(); ++k) {
        Cone& c = contacts.cones[k];
        const nonsmooth::Law& law = newton.laws[k];
        contacts.changed[k] = is_close(c, law) ? 0 : 1;
        if (contacts.changed[k] == 0) {
            keep_law_slope(c, law);
            continue;
        }
        std::copy_n(law.s, 9, c.s);
        std::copy_n(law.p, 3, c.p);
    }
    adopt_resistance_laws(model, newton, pool);
}

void save_iterate(context::Model& model, context::Newton& newton) noexcept {
    const assembly::View v = context::row_view(model);
    std::copy_n(v.v_new, v.dof_count, newton.v.begin());
    std::copy_n(v.lambda, model.interactions.row_count, newton.lambda.begin());
    const base::Array<Cone>& cones = model.system.contacts.cones;
    for (std::size_t k = 0; k < cones.size(); ++k) {
        std::copy_n(cones[k].u, 3, &newton.contact[6 * k]);
        std::copy_n(cones[k].lambda, 3, &newton.contact[6 * k + 3]);
    }
    const base::Array<Resistance>& turns = model.system.contacts.resistances.laws;
    for (std::size_t k = 0; k < turns.size(); ++k) {
        double* to = &newton.contact[6 * (cones.size() + k)];
        std::copy_n(turns[k].lambda, 3, std::copy_n(turns[k].u, 3, to));
    }
}

void recall_contacts(context::Model& model, const context::Newton& newton) noexcept {
    const double* from = newton.contact.data();
    const auto recall = [&](auto& row) {
        std::copy_n(from, 3, row.u);
        std::copy_n(from + 3, 3, row.lambda);
        from += 6;
    };
    for (Cone& c : model.system.contacts.cones) recall(c);
    for (Resistance& a : model.system.contacts.resistances.laws) recall(a);
}

void return_to_fraction(context::Model& model, const context::Newton& newton, double t) noexcept {
    const assembly::View v = context::row_view(model);
    auto between = [&](const std::vector<double>& from, double* to, std::int32_t n) {
        for (std::int32_t i = 0; i < n; ++i) to[i] = from[at(i)] + t * (to[i] - from[at(i)]);
    };
    between(newton.v, v.v_new, v.dof_count);
    between(newton.lambda, v.lambda, model.interactions.row_count);
    base::Array<Cone>& cones = model.system.contacts.cones;
    for (std::size_t k = 0; k < cones.size(); ++k) {
        Cone& c = cones[k];
        const double* from = &newton.contact[6 * k];
        for (int i = 0; i < 3; ++i) {
            c.u[i] = from[i] + t * (c.u[i] - from[i]);
            c.lambda[i] = from[3 + i] + t * (c.lambda[i] - from[3 + i]);
        }
        for (int i = 0; i < 3; ++i)
            c.p[i] = c.lambda[i] + c.s[3 * i] * c.u[0] + c.s[3 * i + 1] * c.u[1] +
                     c.s[3 * i + 2] * c.u[2];
    }
    assembly::Resistances& resistances = model.system.contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        Resistance& a = resistances.laws[k];
        const double* from = &newton.contact[6 * (cones.size() + k)];
        for (int i = 0; i < 3; ++i) {
            a.u[i] = from[i] + t * (a.u[i] - from[i]);
            a.lambda[i] = from[3 + i] + t * (a.lambda[i] - from[3 + i]);
        }
        nonsmooth::set_law_offset(a, cones[at(resistances.rows[k].contact)].u[0]);
    }
}

namespace {

/// Return the contribution of resistances to contacts_merit().
double resistance_merit(const context::Model& model, const context::Newton& newton,
                        double t) noexcept {
    const Contacts& contacts = model.system.contacts;
    const assembly::Resistances& resistances = contacts.resistances;
    double sum = 0.0;
    for (std::size_t k = 0; k < resistances.count(); ++k) {
        const Resistance& a = resistances.laws[k];
        const std::size_t contact = at(resistances.rows[k].contact);
        const Cone& c = contacts.cones[contact];
        const double* normal = &newton.contact[6 * contact];
        const double* before = &newton.contact[6 * (contacts.count() + k)];
        double u[3], lambda[3], e[3];
        for (int i = 0; i < 3; ++i) {
            u[i] = before[i] + t * (a.u[i] - before[i]);
            lambda[i] = before[3 + i] + t * (a.lambda[i] - before[3 + i]);
        }
        nonsmooth::residual(a, c, normal[0] + t * (c.u[0] - normal[0]),
                            normal[3] + t * (c.lambda[0] - normal[3]), u, lambda, e);
        sum += (a.mobility + a.sigma) * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    }
    return sum;
}

}  // namespace

double contacts_merit(const context::Model& model, const context::Newton& newton,
                      double t) noexcept {
    double sum = resistance_merit(model, newton, t);
    const base::Array<Cone>& cones = model.system.contacts.cones;
    for (std::size_t k = 0; k < cones.size(); ++k) {
        const Cone& c = cones[k];
        const double* before = &newton.contact[6 * k];
        double u[3], lambda[3], e[3];
        for (int i = 0; i < 3; ++i) {
            u[i] = before[i] + t * (c.u[i] - before[i]);
            lambda[i] = before[3 + i] + t * (c.lambda[i] - before[3 + i]);
        }
        nonsmooth::residual(c, u, lambda, e);
        sum += (c.mobility + c.sigma_n) * e[0] * e[0] +
               (c.mobility + c.sigma_t) * (e[1] * e[1] + e[2] * e[2]);
    }
    return sum;
}

namespace {

/// Return the larger of two values; NaN if one of them is NaN.
double nan_or_more(double a, double b) noexcept { return b <= a || a != a ? a : b; }

}  // namespace

double largest_residual(const context::Model& model, context::SolveWork& solve,
                        runtime::Pool& pool) noexcept {
    const Contacts& contacts = model.system.contacts;
    auto some = [&](std::int32_t begin, std::int32_t end) {
        double largest = 0.0;
        for (std::size_t k = at(begin); k < at(end); ++k)
            largest = nan_or_more(largest,
                                  nonsmooth::natural_map(contacts.cones[k], model.contact_floor));
        return largest;
    };
    double largest = context::merged_over(solve, pool, static_cast<std::int32_t>(contacts.count()),
                                          some, nan_or_more);
    const assembly::Resistances& resistances = contacts.resistances;
    for (std::size_t k = 0; k < resistances.count(); ++k)
        largest = nan_or_more(
            largest, nonsmooth::natural_map(resistances.laws[k],
                                            contacts.cones[at(resistances.rows[k].contact)],
                                            model.contact_floor));
    return largest;
}

}  // namespace hawser::contact
