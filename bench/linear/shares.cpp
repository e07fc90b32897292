// SPDX-License-Identifier: Apache-2.0
#include "linear/shares.h"

#include "linear/ours.h"
#include "linear/sweeps.h"
#include "linear/timing.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

/// Times of parts by name, in order of first use.
class Laps {
  public:
    struct Part {
        std::string name;
        std::vector<double> us;
    };
    void start() { last_ = Clock::now(); }
    void lap(const char* name) {
        const auto now = Clock::now();
        add(name, 1e6 * std::chrono::duration<double>(now - last_).count());
        last_ = Clock::now();
    }
    [[nodiscard]] double of(const char* name) const {
        for (const Part& p : parts_)
            if (p.name == name) return median(p.us);
        return 0.0;
    }

  private:
    using Clock = std::chrono::steady_clock;
    void add(const char* name, double us) {
        auto p = std::find_if(parts_.begin(), parts_.end(),
                              [&](const Part& part) { return part.name == name; });
        if (p == parts_.end()) p = parts_.insert(p, {name, {}});
        p->us.push_back(us);
    }
    Clock::time_point last_;
    std::vector<Part> parts_;
};

void work(Ours& ours, Problem& p, SweepVectors& v, Laps& laps) {
    base::SerialExecutor serial;
    const Input in = p.input(true);
    laps.start();
    invert_sigma(p.system, *in.form, p.inverse, serial);
    laps.lap("1/Sigma");
    fold_right_side(p.system, *in.form, p.inverse, v, serial);
    laps.lap("right-hand side");
    ours.refresh(in, serial);
    ours.factor_and_begin(v.folded, serial);
    laps.lap("values, factorisation, forward");
    ours.finish(v.folded, serial);
    laps.lap("backward");
    unfold_solution(p.system, *in.form, p.inverse, v, serial);
    laps.lap("multipliers");
    fold_residual(p.system, *in.form, v, serial);
    laps.lap("residual");
    ours.solve(v.folded, serial);
    laps.lap("second solution");
    add_correction(p.system, *in.form, p.inverse, v, serial);
    laps.lap("correction");
    ours.write_values();
    laps.lap("values");
}

void print_solution(const std::string& name, const Laps& laps) {
    const double values = laps.of("values");
    struct Row {
        const char* name;
        double us;
        bool common;
    };
    std::vector<Row> rows;
    for (const char* part : {"1/Sigma", "right-hand side"})
        rows.push_back({part, laps.of(part), true});
    rows.push_back({"values", values, true});
    rows.push_back(
        {"factorisation, forward", laps.of("values, factorisation, forward") - values, false});
    rows.push_back({"backward", laps.of("backward"), false});
    for (const char* part : {"multipliers", "residual"})
        rows.push_back({part, laps.of(part), true});
    rows.push_back({"second solution", laps.of("second solution"), false});
    rows.push_back({"correction", laps.of("correction"), true});
    double all = 0.0, common = 0.0;
    for (const Row& r : rows) {
        all += r.us;
        common += r.common ? r.us : 0.0;
    }
    fmt::print("\n{}, condensed: {:.1f} us\n", name, all);
    for (const Row& r : rows)
        fmt::print("  {:<24} {:9.1f} {:5.1f} %{}\n", r.name, r.us, 100.0 * r.us / all,
                   r.common ? "  *" : "");
    fmt::print("  {:<24} {:9.1f} {:5.1f} %\n", "* every solver runs it", common,
               100.0 * common / all);
}

void print_update(const PaperOptions& paper, int rounds) {
    constexpr int kChanged = 50;
    PaperScene scene(paper);
    base::SerialExecutor serial;
    Ours follows(Order::library), from_scratch(Order::library);
    Laps laps;
    for (int k = 0; k <= rounds; ++k) {
        const BlockForm form = make_form(scene.system(), true);
        Input in;
        in.form = &form;
        if (k == 0) {
            follows.analyse(in, serial);
            from_scratch.analyse(in, serial);
        } else {
            laps.start();
            follows.repair(in, serial);
            laps.lap("repair");
            follows.find_places(serial);
            laps.lap("addresses");
            from_scratch.plan(in, serial);
            laps.lap("analysis");
            from_scratch.find_places(serial);
            laps.lap("its addresses");
        }
        scene.change_contacts(kChanged, k);
    }
    const double repair = laps.of("repair") + laps.of("addresses"),
                 analysis = laps.of("analysis") + laps.of("its addresses");
    fmt::print(
        "  {} contacts changed: repair {:.1f} + addresses of all blocks {:.1f} = {:.1f} us\n"
        "  analysis anew: {:.1f} + {:.1f} = {:.1f} us, {:.2f} times that\n",
        kChanged, laps.of("repair"), laps.of("addresses"), repair, laps.of("analysis"),
        laps.of("its addresses"), analysis, analysis / repair);
}

}  // namespace

void print_fractions(const ProblemSource& source, int rounds) {
    Problem problem(source.system());
    SweepVectors vectors;
    vectors.resize(problem.system);
    base::SerialExecutor serial;
    Ours ours(Order::library);
    ours.analyse(problem.input(true), serial);
    Laps laps, warm;
    for (int k = 0; k < 3; ++k) work(ours, problem, vectors, warm);
    for (int k = 0; k < rounds; ++k) work(ours, problem, vectors, laps);
    print_solution(source.name, laps);
    if (source.paper) print_update(*source.paper, rounds);
}

}  // namespace hawser::bench
