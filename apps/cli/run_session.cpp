// SPDX-License-Identifier: Apache-2.0
#include "run_session.h"

#include "commands.h"
#include "failure.h"
#include "outputs.h"
#include "progress.h"
#include "record/recording_writer.h"
#include "report/start/check.h"
#include "signals.h"

#include <hawser/experimental/splits.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace hawser::cli {

namespace {

// A recording made without --record-every stays below this.
constexpr double kRecordingBytes = 128e6;

// Times are multiples of the step up to rounding.
constexpr double kTimeSlack = 1e-6;  // Slack of times [steps]

// Times are doubles: beyond this a step is lost in rounding.
constexpr double kMaxRunSteps = 0x1p53;

}  // namespace

RunSession::RunSession(const RunOptions& options)
    : options_(options), session_(open()), info_(record::make_scene_info(session_.scene())) {
    for (const std::string& difference : session_.differences())
        if (!options_.quiet)
            fmt::print(stderr, "{}: differs in {}\n", options_.restore, difference);
    choose_times();
    open_outputs();
    add_observers();
}

Session RunSession::open() {
    scene::Scene scene = options_.scene.load();
    check_files(scene);
    scene.world.prepare();
    // Check only a start: in a restored state contacts press and lines are under load.
    if (options_.restore.empty()) check_start(scene);
    if (options_.verify) verifier_ = std::make_unique<verify::Verifier>(scene.world);
    return Session(std::move(scene),
                   {.restore = options_.restore, .control = options_.scene.control()});
}

void RunSession::check_files(const scene::Scene& scene) const {
    std::vector<NamedFile> inputs{{"the control file", options_.scene.control()},
                                  {"the saved state", options_.restore}};
    for (const std::filesystem::path& file : scene.files)
        inputs.push_back({"a file of the scene", file.string()});
    std::vector<NamedFile> outputs{{"--record", options_.record},
                                   {"--csv", options_.csv},
                                   {"--summary", options_.summary},
                                   {"--save-at", options_.save_file}};
    for (const std::string& file : options_.trace.files) outputs.push_back({"--trace", file});
    check_outputs(inputs, outputs);
}

void RunSession::check_start(const scene::Scene& scene) {
    if (options_.unchecked) return;
    const auto findings = report::start::check_start(record::make_scene_info(scene), scene.world);
    if (!options_.quiet || findings.errors() > 0)
        fmt::print(stderr, "{}", report::start::to_text(findings, scene.path + ": "));
    if (findings.errors() > 0)
        throw std::runtime_error(fmt::format(
            "{}: this start is impossible; --unchecked runs it nevertheless", scene.path));
    for (const report::start::Finding& finding : findings.list) warnings_.push_back(finding.text);
}

void RunSession::choose_times() {
    const World& world = session_.world();
    const double h = world.settings().step;
    end_time_ = options_.duration.value_or(session_.scene().duration);
    const double count = std::ceil((end_time_ - world.time()) / h - kTimeSlack);
    if (!(end_time_ / h <= kMaxRunSteps))
        throw std::runtime_error(fmt::format(
            "the end at {:.6g} s cannot be reached with a step of {:.6g} s: at most {:.6g} s; give "
            "another --duration",
            end_time_, h, kMaxRunSteps * h));
    if (count <= 0.0 && !options_.restore.empty())
        throw std::runtime_error(
            fmt::format("{}: the snapshot is at {:.6g} s and the run ends at {:.6g} s; give a "
                        "later end with --duration",
                        options_.restore, world.time(), end_time_));
    steps_ = static_cast<std::int64_t>(std::max(0.0, count));
    if (options_.save_time &&
        !(*options_.save_time <= end_time_ + 0.5 * h && *options_.save_time >= world.time()))
        throw std::runtime_error(
            fmt::format("--save-at {:.6g}: not between the start {:.6g} s "
                        "and the end {:.6g} s of the run",
                        *options_.save_time, world.time(), end_time_));
}

std::int32_t RunSession::stride() const {
    if (options_.stride > 0) return options_.stride;
    const World& world = session_.world();
    const auto steps = static_cast<double>(steps_ + 1);
    const double frames = static_cast<double>(record::frame_bytes(world, info_)) * steps;
    // Loads are stored in every step. Frames get at least half of the file.
    const double loads = static_cast<double>(record::sea_load_bytes(world)) * steps;
    const double left = std::max(kRecordingBytes - loads, 0.5 * kRecordingBytes);
    return static_cast<std::int32_t>(std::clamp(std::ceil(frames / left), 1.0, 1e6));
}

void RunSession::open_outputs() {
    if (!options_.record.empty()) {
        session_.record(options_.record, stride());
        written_.push_back(options_.record);
    }
    if (!options_.csv.empty()) {
        session_.write_csv(options_.csv, stride());
        written_.push_back(options_.csv);
    }
    options_.trace.start(session_.world());
}

void RunSession::add_observers() {
    const World& world = session_.world();
    collector_ = std::make_unique<report::SummaryCollector>(info_, world);
    session_.observe(*collector_);
    const std::vector<CutView> cuts = world.splits().cuts();
    if (std::any_of(cuts.begin(), cuts.end(),
                    [](const CutView& c) { return c.coupling != Coupling::deadline; })) {
        coupling_ = std::make_unique<verify::CouplingObserver>(world);
        session_.observe(*coupling_);
    }
    if (options_.verify) {
        verifier_->begin_at(world);
        session_.observe(*verifier_);
    } else if (!options_.realtime && options_.scene.budget_ms == 0.0) {
        sampled_ = std::make_unique<verify::SampledVerifier>(world, world.step_count() + steps_);
        session_.observe(*sampled_);
    }
}

int RunSession::run() {
    const World& world = session_.world();
    catch_signals();
    const CancelledBySignal cancelled(session_.world());
    if (!options_.quiet)
        fmt::print(stderr, "{}: {} bodies, {} interactions, {} steps of {:.6g} ms\n", info_.name,
                   world.body_count(), world.interaction_count(), steps_,
                   1e3 * world.settings().step);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const std::int64_t first = world.step_count();
    Progress progress(steps_, world.settings().step, !options_.quiet);
    if (options_.realtime) pacer_ = std::make_unique<Pacer>(world.settings().step);
    bool interrupted = false;
    save_if_due();
    while (world.step_count() - first < steps_) {
        interrupted = stop_requested();
        if (interrupted) break;
        const Status status = run_step(progress);
        save_if_due();
        if (status != Status::ok) break;
        progress.update(world.step_count() - first);
        if (pacer_) pacer_->wait();
    }
    progress.close();
    return finish(interrupted, std::chrono::duration<double>(Clock::now() - start).count());
}

/// Perform a step. An operation of the timeline that fails ends the run, with all files complete.
Status RunSession::run_step(Progress& progress) {
    try {
        const Status status = session_.step();
        if (status != Status::ok) return status;
        collector_->add_step_cpu(session_.step_cpu_seconds());
        for (const scene::Operation& operation : session_.operations())
            collector_->add_operation(operation.at, to_string(operation));
        return status;
    } catch (const DefError&) {
        progress.close();
        (void)session_.finish();
        throw;
    }
}

void RunSession::save_if_due() {
    const World& world = session_.world();
    if (!options_.save_time || saved_ ||
        world.time() < *options_.save_time - kTimeSlack * world.settings().step)
        return;
    session_.save(options_.save_file);
    saved_ = true;
    written_.push_back(options_.save_file);
}

int RunSession::finish(bool interrupted, double wall_seconds) {
    const World& world = session_.world();
    report::Summary summary = collector_->result(world);
    // Check the verdict on the last state here, because no step follows.
    const bool has_failed = summary.verdict.verdict.grade == Grade::wrong &&
                            world.settings().on_diverged == OnDiverged::stop;
    summary.wall_seconds = wall_seconds;
    summary.warnings = warnings_;
    if (pacer_) {
        summary.missed_frames = pacer_->frames_missed();
        summary.lateness_max = pacer_->lateness_max();
    }
    if (coupling_) summary.coupling = coupling_->result(world);
    if (verifier_) summary.verified = verifier_->result();
    summary.objection = session_.objection();
    const record::Ending ending = session_.finish(interrupted);
    if (ending == record::Ending::interrupted) summary.outcome = "interrupted";
    if (ending == record::Ending::failed) summary.outcome = "failed";
    if (!options_.summary.empty()) {
        write_output(options_.summary, report::to_json(summary), "the summary");
        written_.push_back(options_.summary);
    }
    const std::string timeline = options_.trace.finish(world, info_.name);
    written_.insert(written_.end(), options_.trace.files.begin(), options_.trace.files.end());
    if (!options_.quiet) {
        fmt::print("{}{}",
                   report::to_text(
                       summary, options_.verbose ? report::Detail::solver : report::Detail::user),
                   timeline);
        if (!written_.empty()) fmt::print("  wrote        {}\n", fmt::join(written_, ", "));
        std::fflush(stdout);
    }
    if (!session_.objection().empty()) {
        fmt::print(stderr, "hawser: {}the step to {:.6g} s is wrong: {}\n",
                   verifier_ ? "--verify: " : "", world.time(), session_.objection());
        return kFailed;
    }
    if (has_failed) {
        fmt::print(stderr, "hawser: failed at {:.6g} s (diverged): {}\n", world.time(),
                   summary.verdict.description);
        return kFailed;
    }
    if (ending == record::Ending::failed) {
        fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}; the state before it stays\n",
                   world.time(), failure(world));
        return kFailed;
    }
    return ending == record::Ending::interrupted ? kInterrupted : kOk;
}

}  // namespace hawser::cli
