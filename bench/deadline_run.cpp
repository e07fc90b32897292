// SPDX-License-Identifier: Apache-2.0
#include <hawser/scene.h>

#include "deadline_run.h"

#include "deadline_load.h"
#include "record/control.h"
#include "report/summary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser::bench {
namespace {

/// A run of the scene. @param repeat  Degradations to impose; null: those of the budget.
class DeadlineRunner {
  public:
    DeadlineRunner(const DeadlineOptions& options, double budget_ms, const DeadlineRun* repeat)
        : o_(options),
          scene_(load(options, budget_ms)),
          cargo_(scene_.world, options.stacks),
          repeat_(repeat) {
        std::vector<std::string> names;
        for (std::int32_t i = 0; i < scene_.world.input_count(); ++i)
            names.push_back(scene_.world.input_def({i}).name);
        if (!options.control.empty()) control_ = record::read_control(options.control, names);
    }

    DeadlineRun run() {
        for (int i = 0; i < kDeadlinePhases * o_.steps; ++i) add_sample(i);
        out_.hash = scene_.world.state().hash();
        out_.step = scene_.world.settings().step;
        return std::move(out_);
    }

  private:
    static scene::Scene load(const DeadlineOptions& o, double budget_ms) {
        scene::Options options;
        options.threads = o.threads;
        options.budget = 1e-3 * budget_ms;
        return scene::load_file(o.scene, options);
    }

    void add_sample(int i) {
        World& w = scene_.world;
        for (; next_ < control_.size() && control_[next_].time <= w.time() + 1e-9; ++next_)
            w.set_input({control_[next_].input}, control_[next_].value);
        if (i == o_.steps) cargo_.lower_deck(w);
        if (i == 2 * o_.steps) {
            for (const BodyId b : cargo_.boxes()) out_.at_end_of_load.push_back(w.pose(b).position);
            cargo_.remove_boxes(w);
        }
        cargo_.move_deck(w);
        if (repeat_)
            w.solver().degrade_next_step(repeat_->degradations[static_cast<std::size_t>(i)]);
        if (w.step() != Status::ok)
            throw std::runtime_error(
                fmt::format("step {} failed: {}", i, to_string(w.stats().status)));
        note(i);
    }

    void note(int i) {
        const World& w = scene_.world;
        const StepStats& s = w.stats();
        PhaseFigures& f = out_.phase[static_cast<std::size_t>(i / o_.steps)];
        out_.degradations.push_back(s.degradation);
        if (i >= kUncountedSteps) {
            f.cpu.push_back(1e3 * s.solver_cpu_seconds);
            f.wall.push_back(1e3 * s.step_seconds);
            f.map.push_back(s.natural_map);
            out_.log.after_step(s);
            f.degraded += s.degradation.any() ? 1 : 0;
            if (f.cpu.back() > o_.budget_ms)
                ++(s.plans + s.repairs > analyses_ ? out_.late_with_analysis
                   : s.newton_iterations <= 1      ? out_.late_with_one_iteration
                                                   : out_.late_with_more_iterations);
        }
        analyses_ = s.plans + s.repairs;
        f.contacts = std::max(f.contacts, s.contacts);
        f.momentum = std::max(f.momentum, s.momentum_residual);
        f.violation = std::max(f.violation, s.violation_max);
        f.penetration = std::max(f.penetration, cargo_.penetration(w));
        f.speed = std::max(f.speed, cargo_.speed(w));
        const Energy now = w.energy();
        // Boxes moved by hand change the energy without an account.
        if (i % o_.steps > 1) {
            f.drift += std::abs(report::energy_drift(before_, now));
            f.exchanged += std::abs(now.kinetic - before_.kinetic) +
                           std::abs(now.gravity + now.elastic - before_.gravity - before_.elastic);
        }
        before_ = now;
        exact_row_ = s.degradation.any() ? 0 : exact_row_ + 1;
        const int after = i - 2 * o_.steps + 1;
        if (after > 0 && out_.exact_after < 0 && exact_row_ >= std::min(kExactRow, after))
            if (after >= kExactRow) out_.exact_after = std::max(0, after - exact_row_);
    }

    const DeadlineOptions& o_;
    scene::Scene scene_;
    DeckCargo cargo_;
    const DeadlineRun* repeat_;
    std::vector<record::ControlChange> control_;
    std::size_t next_ = 0;
    std::int64_t analyses_ = 0;
    Energy before_;
    int exact_row_ = 0;
    DeadlineRun out_;
};

}  // namespace

DeadlineRun run_deadline(const DeadlineOptions& options, double budget_ms,
                         const DeadlineRun* repeat) {
    return DeadlineRunner(options, budget_ms, repeat).run();
}

}  // namespace hawser::bench
