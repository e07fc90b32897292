// SPDX-License-Identifier: Apache-2.0
/// Savings of a partial refactorisation, and the cost of keeping update matrices for it.
#include "factor/analyse.h"
#include "factor/numeric.h"
#include "factor/partial.h"
#include "index.h"
#include "linear/edits.h"
#include "linear/form.h"
#include "linear/timing.h"
#include "paper_matrix/dice.h"
#include "paper_matrix/paper_matrix.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace hawser::bench {
namespace {

double thread_us() { return 1e6 * thread_seconds(); }  // µs

/// A diagonal matrix in the pattern of the scene: times and flops depend on the pattern alone.
struct Parts {
    const BlockForm& form;
    factor::Symbolic symbolic;
    factor::Numeric numeric;
    factor::DirtyParts dirty;
    base::SerialExecutor serial;

    Parts(const BlockForm& f, bool keep)
        : form(f), symbolic(factor::analyse(f.pattern, factor::plan_elimination(f.pattern))) {
        if (keep) factor::separate_updates(symbolic);
        numeric.reserve(symbolic, 1);
        dirty.reserve(symbolic);
    }

    void fill(bool part) {
        for (std::int32_t v = 0; v < form.pattern.nodes(); ++v) {
            if (part && !dirty.refill(symbolic, v)) continue;
            const factor::BlockTarget t = symbolic.target(v, v);
            for (std::int64_t i = 0; i < form.pattern.size[at(v)]; ++i)
                numeric.values()[t.address + i * (t.step + t.ld)] = form.pattern.sign[at(v)];
        }
    }
    double all_columns() {
        numeric.clear(symbolic, serial);
        fill(false);
        const double from = thread_us();
        (void)numeric.factor(symbolic, serial);
        return thread_us() - from;
    }
    double part(const std::vector<std::int32_t>& columns) {
        dirty.find(symbolic, columns);
        numeric.clear(symbolic, dirty, serial);
        fill(true);
        const double from = thread_us();
        (void)numeric.refactor(symbolic, dirty, serial);
        return thread_us() - from;
    }
};

constexpr int kSamples = 41;

/// Return the columns that change with the values of some contacts: blocks of the bodies in
/// condensed form, of the contacts' own rows in saddle form.
std::vector<std::int32_t> columns_of(const PaperScene& scene, const Parts& parts, int count,
                                     Dice& dice) {
    std::vector<std::int32_t> columns;
    for (int k = 0; k < count; ++k) {
        const int i = dice.below(static_cast<int>(scene.contacts().size()));
        const Contact& c = scene.contacts()[at(i)];
        const BlockForm& form = parts.form;
        if (form.condensed) {
            columns.push_back(form.index[at(c.first)]);
            if (c.second >= 0) columns.push_back(form.index[at(c.second)]);
            continue;
        }
        const std::int32_t node = form.index[at(scene.contact_node(i))];
        columns.push_back(node);
        for (const std::int32_t u : form.pattern.neighbours(node))
            columns.push_back(factor::DirtyParts::column(parts.symbolic, node, u));
    }
    return columns;
}

void print_form(const PaperScene& scene, const BlockForm& form, const char* name) {
    std::vector<double> stacked, kept;
    Parts stacks(form, false), parts(form, true);
    for (int k = 0; k < kSamples; ++k) {
        stacked.push_back(stacks.all_columns());
        kept.push_back(parts.all_columns());
    }
    fmt::print("{:<17} {:7.0f} {:7.0f} {:7.2f} {:7.2f} ", name, median(stacked), median(kept),
               8e-6 * static_cast<double>(stacks.symbolic.work_size),
               8e-6 * static_cast<double>(parts.symbolic.work_size));
    Dice dice(7);
    for (const int count : {1, 10, 50, 200}) {
        std::vector<double> times;
        double flops = 0.0;
        for (int k = 0; k < kSamples; ++k) {
            times.push_back(parts.part(columns_of(scene, parts, count, dice)));
            flops += static_cast<double>(parts.dirty.flops) / kSamples;
        }
        fmt::print(" {:7.0f} {:5.1f}%", median(times),
                   100.0 * flops / static_cast<double>(parts.symbolic.flops));
    }
    fmt::print("\n");
}

}  // namespace

void print_parts(int scale) {
    fmt::print(
        "\nRefactorisation after the values of contacts changed; us, MB, share of the flops\n"
        "{:<17} {:>7} {:>7} {:>7} {:>7}  {:>14} {:>14} {:>14} {:>14}\n",
        "", "whole", "kept", "stacks", "kept", "1 contact", "10", "50", "200");
    for (const CableForm cables : {CableForm::lumped, CableForm::rigid})
        for (const bool condensed : {false, true}) {
            PaperOptions options;
            options.form = cables;
            options.scale = scale;
            const PaperScene scene(options);
            const std::string name =
                fmt::format("{} {}", cables == CableForm::lumped ? "lumped" : "rigid",
                            condensed ? "condensed" : "saddle");
            print_form(scene, make_form(scene.system(), condensed), name.c_str());
        }
}

}  // namespace hawser::bench
