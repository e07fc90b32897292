// SPDX-License-Identifier: Apache-2.0
#include "linear/edits.h"

#include "factor/repair.h"
#include "linear/form.h"
#include "linear/timing.h"
#include "paper_matrix/paper_matrix.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace hawser::bench {
namespace {

double now() { return 1e6 * thread_seconds(); }  // µs

template <class F>
double time_of(F f) {
    const double from = now();
    f();
    return now() - from;
}

double mean(const std::vector<double>& v) {
    double sum = 0.0;
    for (const double d : v) sum += d;
    return v.empty() ? 0.0 : sum / static_cast<double>(v.size());
}

void print_sequence(CableForm cables, bool condensed, int count, int steps, int scale) {
    PaperOptions options;
    options.form = cables;
    options.scale = scale;
    PaperScene scene(options);
    const factor::Pattern first = make_form(scene.system(), condensed).pattern;
    factor::Analysis repaired, updated, planned;
    for (factor::Analysis* a : {&repaired, &updated, &planned}) a->plan(first);
    const auto flops = static_cast<double>(repaired.symbolic().flops);
    std::vector<double> repair, update, plan, columns, same;
    std::string growth;
    int replans = 0;
    for (int step = 0; step < steps; ++step) {
        scene.change_contacts(count, step);
        const factor::Pattern p = make_form(scene.system(), condensed).pattern;
        factor::RepairReport r;
        repair.push_back(time_of([&] { r = repaired.repair(p); }));
        columns.push_back(static_cast<double>(r.columns) / p.nodes());
        same.push_back(static_cast<double>(r.same) /
                       static_cast<double>(repaired.symbolic().fronts.size()));
        update.push_back(time_of([&] { r = updated.update(p); }));
        replans += r.replanned ? 1 : 0;
        plan.push_back(time_of([&] { planned.plan(p); }));
        if ((step + 1) % std::max(steps / 4, 1) == 0)
            growth += fmt::format(" {:5.2f} {:4.2f}",
                                  static_cast<double>(repaired.symbolic().flops) / flops,
                                  static_cast<double>(planned.symbolic().flops) / flops);
    }
    fmt::print("{:<7} {:<9} {:>5} {:8.0f} {:8.0f} {:8.0f} {:6.2f} {:7} {:7.1f}% {:5.1f}% {}\n",
               cables == CableForm::lumped ? "lumped" : "rigid", condensed ? "condensed" : "saddle",
               count, median(repair), mean(update), median(plan), median(plan) / median(repair),
               replans, 100.0 * mean(columns), 100.0 * mean(same), growth);
}

}  // namespace

void print_edits(int steps, int scale) {
    fmt::print(
        "scale {}, {} steps; us; columns computed again; fronts that stay the same; flops over "
        "those "
        "at the start,\neach after a quarter of the steps: repaired only, planned anew\n",
        scale, steps);
    fmt::print("{:<7} {:<9} {:>5} {:>8} {:>8} {:>8} {:>6} {:>7} {:>8} {:>6}  growth\n", "cables",
               "form", "edits", "repair", "update", "plan", "ratio", "replans", "columns", "same");
    for (const CableForm cables : {CableForm::lumped, CableForm::rigid})
        for (const bool condensed : {false, true})
            for (const int count : {10, 50, 200})
                print_sequence(cables, condensed, count, steps, scale);
}

}  // namespace hawser::bench
