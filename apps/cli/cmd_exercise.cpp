// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>
#include "commands.h"
#include "debrief/debrief.h"
#include "failure.h"
#include "outputs.h"
#include "progress.h"
#include "record/control.h"
#include "report/summary.h"
#include "signals.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hawser::cli {

namespace {

constexpr const char* kExerciseFooter = R"(Examples:
  hawser exercise exercises/tow_out.json --control exercises/tow_out.control.csv
  hawser exercise exercises/tow_out.json --control inputs.csv --record run.hwr --report report.html
  hawser exercise exercises/tow_out.json --replay run.hwr     # the same score from the recording

The first line of a CONTROL file is "time,<input>,…" with inputs of stations. A column fault.NAME
starts the fault NAME at a value other than 0 and ends it at 0.

Exit codes:
    0    passed
    1    wrong option or file
    2    a step failed
    3    the replay differs
    4    not passed
    130  interrupted (Ctrl-C))";

constexpr int kNotPassed = 4;

struct ExerciseOptions {
    std::string file, control, record, report, summary, replay, restore, csv;
    std::vector<std::pair<double, std::string>> saves;  ///< Times [s] and files of saved states.
    std::int32_t stride = 1;
    int threads = 1;
    bool quiet = false, verify = false;
};

/// Inputs and faults over time. Each is set by a role with permission.
class Controls {
  public:
    Controls(const std::string& file, const exercise::Exercise& exercise) {
        for (const exercise::Station& station : exercise.stations)
            for (const std::string& input : station.inputs) {
                names_.push_back(input);
                roles_.push_back(station.name);
            }
        control_count_ = names_.size();
        for (const exercise::Fault& fault : exercise.faults)
            names_.push_back("fault." + fault.name);
        if (!file.empty()) changes_ = record::read_control(file, names_);
    }
    void apply_controls(double now, exercise::Run& run) {
        for (; next_ < changes_.size() && changes_[next_].time <= now; ++next_) {
            const auto k = static_cast<std::size_t>(changes_[next_].input);
            const double value = changes_[next_].value;
            if (k < control_count_) {
                run.set_input(roles_[k], names_[k], value);
                continue;
            }
            const std::string fault = names_[k].substr(std::string("fault.").size());
            if (value != 0.0)
                run.trigger(exercise::kInstructor, fault);
            else if (run.active(fault))
                run.clear(exercise::kInstructor, fault);
        }
    }

  private:
    std::vector<std::string> names_, roles_;
    std::vector<record::ControlChange> changes_;
    std::size_t control_count_ = 0, next_ = 0;
};

std::string clock(double time) {
    const auto tenths = static_cast<std::int64_t>(std::llround(10.0 * time));
    return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

void print(const exercise::Result& r) {
    for (const exercise::Entry& e : r.entries)
        fmt::print("  {:>8}  {:<9}  {}{}{}\n", clock(e.time), exercise::to_string(e.kind), e.name,
                   e.by.empty() ? "" : " (by " + e.by + ")",
                   e.points == 0.0 ? "" : fmt::format("  {:+.6g}", e.points));
    for (const exercise::Tally& t : r.penalties)
        if (t.seconds > 0.0 && t.points != 0.0)
            fmt::print("  penalty {}: {:.1f} s, {:+.6g}\n", t.name, t.seconds, t.points);
    fmt::print("{}: {}, {:.6g} of {:.6g} points ({:.6g} needed), {} at {}\n", r.exercise,
               exercise::to_string(r.outcome), r.points, r.possible, r.pass, r.end, clock(r.time));
}

int report_result(const ExerciseOptions& options, const exercise::Exercise& exercise,
                  const exercise::Result& result, const exercise::Curves& curves,
                  const std::string& recording) {
    if (!options.summary.empty())
        write_output(options.summary, exercise::to_json(result), "the summary");
    if (!options.report.empty()) {
        std::optional<record::Recording> run;
        if (!recording.empty()) run = record::Recording::open(recording);
        write_output(options.report,
                     debrief::to_html(exercise, result, curves, run ? &*run : nullptr),
                     "the report");
    }
    if (!options.quiet) print(result);
    return result.outcome == exercise::Outcome::passed ? kOk : kNotPassed;
}

int rescore(const ExerciseOptions& options) {
    const record::Recording recording = record::Recording::open(options.replay);
    const exercise::Rescored rescored = exercise::rescore(recording, options.threads);
    const exercise::Loaded own = exercise::load_file(options.file);
    if (own.exercise.name != rescored.exercise.name)
        throw record::RecordingError(
            fmt::format("{}: a recording of the exercise \"{}\", not of \"{}\"", options.replay,
                        rescored.exercise.name, own.exercise.name));
    if (own.exercise.text != rescored.exercise.text)
        fmt::print(stderr,
                   "{}: recorded with another version of the exercise; its score is by "
                   "that one\n",
                   options.replay);
    const int code =
        report_result(options, rescored.exercise, rescored.result, rescored.curves, options.replay);
    if (rescored.same) return code;
    fmt::print(stderr, "hawser: {}: {}\n", options.replay, rescored.difference);
    return kMismatch;
}

void check_files(const ExerciseOptions& options, const scene::Scene& scene) {
    std::vector<NamedFile> inputs{{"the exercise", options.file},
                                  {"the control file", options.control},
                                  {"the saved state", options.restore}};
    for (const std::filesystem::path& file : scene.files)
        inputs.push_back({"a file of the scene", file.string()});
    std::vector<NamedFile> outputs{{"--record", options.record},
                                   {"--report", options.report},
                                   {"--csv", options.csv},
                                   {"--summary", options.summary}};
    for (const auto& [time, file] : options.saves) outputs.push_back({"--save-at", file});
    check_outputs(inputs, outputs);
}

/// Save each state whose time has been reached, unless it has been saved.
void save_due(const std::vector<std::pair<double, std::string>>& saves, double now,
              std::vector<bool>& saved, const Session& session) {
    for (std::size_t i = 0; i < saves.size(); ++i)
        if (!saved[i] && saves[i].first <= now) {
            session.save(saves[i].second);
            saved[i] = true;
        }
}

/// Print the reason of a failed step or of a rejection by --verify, and end the exercise as failed.
/// @return the exit code.
int fail(exercise::Run& run, const Session& session) {
    if (!session.objection().empty()) {
        fmt::print(stderr, "hawser: --verify: the step to {:.6g} s is wrong: {}\n", session.time(),
                   session.objection());
        run.end("--verify refuses a step: " + session.objection(), true);
        return kFailed;
    }
    const std::string why = failure(session.world());
    fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}\n", session.time(), why);
    run.end("a step failed: " + why, true);
    return kFailed;
}

/// Run the exercise. @return kOk if it ended by itself, else the exit code of the failure.
int run_exercise(exercise::Run& run, Session& session, Controls& controls, Progress& progress,
                 const ExerciseOptions& options) {
    constexpr double kSlack = 1e-6;  // Times are multiples of the step up to rounding.
    catch_signals();
    const CancelledBySignal cancelled(session.world());
    std::vector<bool> saved(options.saves.size());
    while (!run.ended()) {
        if (stop_requested()) break;
        const double now = session.time() + kSlack * session.world().settings().step;
        save_due(options.saves, now, saved, session);
        controls.apply_controls(now, run);
        if (const Status status = run.step(); status == Status::cancelled) {
            break;
        } else if (status != Status::ok) {
            progress.close();
            return fail(run, session);
        }
        progress.update(session.world().step_count());
    }
    if (run.ended()) return kOk;
    run.end("interrupted", true);
    return kInterrupted;
}

int run_command(const ExerciseOptions& options) {
    if (!options.replay.empty()) return rescore(options);
    scene::Options scene_options;
    scene_options.threads = options.threads;
    exercise::Loaded loaded = exercise::load_file(options.file, scene_options);
    check_files(options, loaded.scene);
    Controls controls(options.control, loaded.exercise);
    TemporaryFile temporary;
    const std::string recording = recording_for(options.record, options.report, temporary);
    std::optional<verify::Verifier> verifier;
    if (options.verify) {
        loaded.scene.world.prepare();
        verifier.emplace(loaded.scene.world);
    }
    Session session(std::move(loaded.scene), {.restore = options.restore,
                                              .record = recording,
                                              .csv = options.csv,
                                              .every = options.stride});
    if (!options.restore.empty()) exercise::start_at(loaded.exercise, session.time());
    for (const std::string& difference : session.differences())
        if (!options.quiet) fmt::print(stderr, "{}: differs in {}\n", options.restore, difference);
    if (verifier) session.observe(*verifier);
    exercise::Run run(loaded.exercise, session);
    const double h = session.world().settings().step;
    Progress progress(std::llround(loaded.exercise.duration / h), h, !options.quiet);
    const int end = run_exercise(run, session, controls, progress, options);
    progress.close();
    (void)session.finish(end == kInterrupted);
    if (verifier && !options.quiet)
        fmt::print("{}", report::to_text(verifier->result(), report::Detail::user));
    const int code = report_result(options, loaded.exercise, run.result(), run.curves(), recording);
    return end == kOk ? code : end;
}

}  // namespace

void add_exercise(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ExerciseOptions>();
    CLI::App* command =
        app.add_subcommand("exercise", "Run an exercise without a page and print its score");
    command->footer(kExerciseFooter);
    command->add_option("EXERCISE", options->file, "Exercise file (JSON)")->required();
    CLI::Option* control = command->add_option("--control", options->control,
                                               "Input values and faults over time (CSV)");
    CLI::Option* record = command->add_option("--record", options->record,
                                              "Write a recording (for --replay, replay, plot)");
    command->add_option("--record-every", options->stride, "Steps between frames of the recording")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--csv", options->csv, "Write a table of tensions, motions and outputs");
    command->add_option("--restore", options->restore,
                        "Start from a saved state; goals do not wait for earlier goals");
    command->add_option("--save-at", options->saves, "Save the state at TIME [s] to FILE")
        ->allow_extra_args(false);
    command->add_option("--report", options->report, "Write a report for the debriefing (HTML)");
    command->add_option("--summary", options->summary, "Write the score as JSON");
    command
        ->add_option("--replay", options->replay,
                     "Score a recording of this exercise; repeats its motion")
        ->excludes(control)
        ->excludes(record);
    command
        ->add_option("--threads", options->threads, "Worker threads; results do not depend on it")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    command
        ->add_flag("--verify", options->verify,
                   "Check contacts, momentum and bounds of each step by separate code; a deviation "
                   "ends the run as failed")
        ->excludes("--replay");
    command->add_flag("--quiet", options->quiet, "No progress and no score on the terminal");
    command->callback([&chosen, options] { chosen = [options] { return run_command(*options); }; });
}

}  // namespace hawser::cli
