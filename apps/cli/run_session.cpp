// SPDX-License-Identifier: Apache-2.0
#include "run_session.h"

#include "commands.h"
#include "failure.h"
#include "outputs.h"
#include "progress.h"
#include "record/snapshot_file.h"
#include "report/host.h"
#include "report/start/check.h"
#include "signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hawser::cli {

namespace {

// A recording made without --record-every stays below this.
constexpr double kRecordingBytes = 128e6;

// Times are multiples of the step up to rounding.
constexpr double kTimeSlack = 1e-6;  // [steps]

// Times are doubles: beyond this a step is lost in rounding.
constexpr double kMostRunSteps = 0x1p53;

}  // namespace

RunSession::RunSession(const RunOptions& options)
    : options_(options), scene_(options.scene.load()), info_(info_of(scene_)) {
    World& world = scene_.world;
    check_files();
    world.prepare();
    // A restored state is no start: what touches presses, and lines carry what they carry.
    if (options.restore.empty())
        check_start();
    else
        record::restore_snapshot(options.restore, info_, world);
    choose_times();
    framed_ = world.step_count();
    if (!options.control.empty())
        control_ = record::read_control(options.control, input_names(world));
    choose_stride();
    if (!options.record.empty()) {
        const WorldDef& settings = world.settings();
        recording_ = std::make_unique<record::RecordingWriter>(
            options.record, info_, world,
            record::RecordingSettings{.step = settings.step,
                                      .form = settings.form,
                                      .threads = settings.threads,
                                      .stride = stride_,
                                      .instruction_set = instruction_set(),
                                      .version = version(),
                                      .processor = report::processor_model()});
        written_.push_back(options.record);
    }
    if (!options.csv.empty()) {
        csv_ = std::make_unique<record::CsvWriter>(options.csv, info_, world);
        if (world.step_count() > 0)  // Before the first step no tension is known.
            csv_->add_row(world);
        written_.push_back(options.csv);
    }
    options.trace.start(world);
    collector_ = std::make_unique<report::SummaryCollector>(info_, world);
    const std::vector<CutView> cuts = world.cuts();
    const bool may_split = !cuts.empty() && (world.settings().budget > 0.0 ||
                                             world.settings().coupling != Coupling::deadline);
    if (may_split && options.verify)
        throw std::runtime_error(
            "--verify checks momentum, which a split does not keep; use "
            "--coupling exact");
    if (std::any_of(cuts.begin(), cuts.end(),
                    [](const CutView& c) { return c.coupling != Coupling::deadline; })) {
        coupling_ = std::make_unique<verify::CouplingObserver>(world);
    }
    if (options.verify) verifier_ = std::make_unique<verify::Verifier>(world);
}

void RunSession::check_files() const {
    std::vector<NamedFile> inputs{{"the control file", options_.control},
                                  {"the saved state", options_.restore}};
    for (const std::filesystem::path& file : scene_.files)
        inputs.push_back({"a file of the scene", file.string()});
    std::vector<NamedFile> outputs{{"--record", options_.record},
                                   {"--csv", options_.csv},
                                   {"--summary", options_.summary},
                                   {"--save-at", options_.save_file}};
    for (const std::string& file : options_.trace.files) outputs.push_back({"--trace", file});
    check_outputs(inputs, outputs);
}

void RunSession::choose_times() {
    const World& world = scene_.world;
    const double h = world.settings().step;
    end_time_ = options_.duration.value_or(scene_.duration);
    const double count = std::ceil((end_time_ - world.time()) / h - kTimeSlack);
    if (!(end_time_ / h <= kMostRunSteps))
        throw std::runtime_error(fmt::format(
            "the end at {:.6g} s cannot be reached with a step of {:.6g} s: at most {:.6g} s; give "
            "another --duration",
            end_time_, h, kMostRunSteps * h));
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

void RunSession::check_start() {
    if (options_.unchecked) return;
    const auto findings = report::start::check_start(info_, scene_.world);
    if (!options_.quiet || findings.errors() > 0)
        fmt::print(stderr, "{}", report::start::to_text(findings, scene_.path + ": "));
    if (findings.errors() > 0)
        throw std::runtime_error(fmt::format(
            "{}: this start is impossible; --unchecked runs it nevertheless", scene_.path));
    for (const report::start::Finding& finding : findings.list) warnings_.push_back(finding.text);
}

void RunSession::choose_stride() {
    stride_ = options_.stride;
    if (stride_ > 0) return;
    const double all = static_cast<double>(record::frame_bytes(scene_.world, info_)) *
                       static_cast<double>(steps_ + 1);
    stride_ = static_cast<std::int32_t>(std::clamp(std::ceil(all / kRecordingBytes), 1.0, 1e6));
}

int RunSession::run() {
    World& world = scene_.world;
    catch_signals();
    const CancelledBySignal cancelled(world);
    if (!options_.quiet)
        fmt::print(stderr, "{}: {} bodies, {} interactions, {} steps of {:.6g} ms\n", info_.name,
                   world.body_count(), world.interaction_count(), steps_,
                   1e3 * world.settings().step);
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Progress progress(steps_, world.settings().step, !options_.quiet);
    if (options_.realtime) pacer_ = std::make_unique<Pacer>(world.settings().step);
    record::Ending ending = record::Ending::finished;
    save_if_due();
    while (done_ < steps_) {
        if (stop_requested()) {
            ending = record::Ending::interrupted;
            break;
        }
        apply_inputs();
        if (verifier_) verifier_->before_step(world);
        if (coupling_) coupling_->before_step(world);
        const Status status = world.step();
        if (status == Status::cancelled) {
            ending = record::Ending::interrupted;
            break;
        }
        ++done_;
        if (status != Status::ok) {
            ending = record::Ending::failed;
            break;
        }
        after_step();
        if (coupling_) coupling_->after_step(world);
        if (verifier_) wrong_ = verifier_->after_step(world);
        if (!wrong_.empty()) {
            ending = record::Ending::failed;
            break;
        }
        progress.at(done_);
        if (pacer_) pacer_->wait();
    }
    progress.close();
    return finish(ending, std::chrono::duration<double>(Clock::now() - start).count());
}

void RunSession::apply_inputs() {
    World& world = scene_.world;
    const double now = world.time() + kTimeSlack * world.settings().step;
    std::vector<record::RecordedInput> changes;
    for (; next_control_ < control_.size() && control_[next_control_].time <= now;
         ++next_control_) {
        const record::ControlChange& change = control_[next_control_];
        world.set_input({change.input}, change.value);
        changes.push_back({world.step_count(), change.input, change.value});
    }
    if (recording_) recording_->add_inputs(changes);
}

void RunSession::after_step() {
    World& world = scene_.world;
    const std::vector<Event> events = world.take_events();
    collector_->after_step(world, events);
    if (recording_) {
        if (const StepStats& stats = world.stats(); stats.degradation.any())
            recording_->add_cut(
                {stats.step - 1, stats.degradation, stats.degraded_by, stats.foreseen_seconds});
        for (const Event& event : events) recording_->add_event(world, event);
    }
    if (done_ % stride_ == 0 || done_ == steps_) add_frame();
    save_if_due();
}

void RunSession::add_frame() {
    const World& world = scene_.world;
    if (recording_) recording_->add_frame(world);
    if (csv_) csv_->add_row(world);
    framed_ = world.step_count();
}

void RunSession::save_if_due() {
    const World& world = scene_.world;
    if (!options_.save_time || saved_ ||
        world.time() < *options_.save_time - kTimeSlack * world.settings().step)
        return;
    record::save_snapshot(options_.save_file, info_, world);
    saved_ = true;
    written_.push_back(options_.save_file);
}

int RunSession::finish(record::Ending ending, double wall_seconds) {
    const World& world = scene_.world;
    report::Summary summary = collector_->result(world);
    // The last state is judged here: no step after it does.
    const bool wrong = summary.verdict.verdict.grade == Grade::wrong &&
                       world.settings().on_diverged == OnDiverged::stop;
    if (wrong && ending == record::Ending::finished) ending = record::Ending::failed;
    summary.wall_seconds = wall_seconds;
    summary.warnings = warnings_;
    if (pacer_) {
        summary.missed_frames = pacer_->missed();
        summary.lateness_max = pacer_->lateness_max();
    }
    if (coupling_) summary.coupling = coupling_->result(world);
    if (verifier_) summary.verified = verifier_->result();
    if (ending == record::Ending::interrupted) summary.outcome = "interrupted";
    if (ending == record::Ending::failed) summary.outcome = "failed";
    // Where it ended early the last step need not be one of a frame.
    if (world.step_count() > framed_) add_frame();
    if (recording_) recording_->finish(world, ending);
    if (csv_) csv_->finish();
    if (!options_.summary.empty()) {
        write_output(options_.summary, report::to_json(summary), "the summary");
        written_.push_back(options_.summary);
    }
    const std::string timeline = options_.trace.finish(world, info_.name);
    written_.insert(written_.end(), options_.trace.files.begin(), options_.trace.files.end());
    if (!options_.quiet) {
        fmt::print("{}{}", report::to_text(summary), timeline);
        if (!written_.empty()) fmt::print("  wrote        {}\n", fmt::join(written_, ", "));
        std::fflush(stdout);
    }
    if (!wrong_.empty()) {
        fmt::print(stderr, "hawser: --verify: the step to {:.6g} s is wrong: {}\n", world.time(),
                   wrong_);
        return kFailed;
    }
    if (wrong) {
        fmt::print(stderr, "hawser: failed at {:.6g} s (diverged): {}\n", world.time(),
                   summary.verdict.said);
        return kFailed;
    }
    if (ending == record::Ending::failed) {
        fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}; the state before it stays\n",
                   world.time(), failure(summary.last));
        return kFailed;
    }
    return ending == record::Ending::interrupted ? kInterrupted : kOk;
}

}  // namespace hawser::cli
