// SPDX-License-Identifier: Apache-2.0
#include <hawser/scene.h>

#include <hawser/repeater.h>
#include "commands.h"
#include "failure.h"
#include "progress.h"
#include "record/recorded_scene.h"
#include "signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

namespace hawser::cli {

namespace {

constexpr const char* kReplayFooter = R"(Examples:
  hawser replay run.hwr
  HAWSER_ISA=avx2 hawser replay run.hwr     # recorded on a machine without avx512

Builds the scene from the text in the recording and restores its start state. Applies the recorded
inputs, and compares the state hash of each recorded frame and of the end.

Exit codes:
    0    equal
    1    unreadable, or incomplete (equal up to its end)
    2    a step failed
    3    different
    130  interrupted (Ctrl-C))";

struct ReplayOptions {
    std::string file;
    int threads = 1;
    bool quiet = false;
};

// True if the recording has the instruction set of this program. With another one every hash
// differs, because the state hash includes its name.
bool same_instruction_set(const record::Recording& recording) {
    if (recording.settings.instruction_set == instruction_set()) return true;
    fmt::print(stderr,
               "{}: recorded with the instruction set {}, this program uses {}; results of "
               "different sets differ in the last digits. Set HAWSER_ISA={} if this processor "
               "has it\n",
               recording.file, recording.settings.instruction_set, instruction_set(),
               recording.settings.instruction_set);
    return false;
}

void describe_difference(const record::Recording& recording, const record::Frame& frame,
                         const World& world) {
    fmt::print("first difference at step {}, {:.6g} s: recorded hash {:016x}, replayed {:016x}\n",
               frame.step, frame.time, frame.hash, world.state().motion_hash());
    double worst = 0.0;
    std::string where;
    for (std::size_t i = 0; i < frame.poses.size(); ++i) {
        const Pose pose = world.pose({static_cast<std::int32_t>(i)});
        const double distance = (pose.position - frame.poses[i].position).norm();
        // Frames contain distances from the start in single precision; smaller differences are
        // rounding.
        const double moved = (pose.position - recording.bodies[i].start.position).norm();
        if (distance > 2e-7 * moved + 1e-12 && distance > worst) {
            worst = distance;
            where = recording.bodies[i].name;
        }
    }
    if (worst > 0.0)
        fmt::print("largest distance of a body from its recorded position: {:.3g} m ({})\n", worst,
                   where);
    else
        fmt::print("no body is off by more than the recording's single precision\n");
}

class Replay {
  public:
    Replay(const record::Recording& recording, World& world)
        : recording_(recording), world_(world), repeater_(recording) {}

    int run(bool quiet) {
        const auto frames = recording_.frame_count();
        const bool ended = recording_.ending != record::Ending::unknown;
        const std::int64_t last = ended        ? recording_.end_step
                                  : frames > 0 ? recording_.frame_head(frames - 1).step
                                               : recording_.start_step;
        catch_signals();
        const CancelledBySignal cancelled(world_);
        Progress progress(steps_to(last), recording_.settings.step, !quiet);
        for (std::size_t i = 0; i < frames; ++i) {
            const record::Frame head = recording_.frame_head(i);
            if (const int code = advance(head.step, recording_.take_of(i), progress); code != kOk)
                return code;
            if (world_.state().motion_hash() != head.hash) {
                progress.close();
                describe_difference(recording_, recording_.frame(i), world_);
                return kMismatch;
            }
        }
        if (const int code = ended ? finish_replay(last, progress) : kOk; code != kOk) return code;
        progress.close();
        if (ended && world_.state().motion_hash() != recording_.end_hash) {
            fmt::print(
                "difference at the end, step {}, {:.6g} s: recorded hash {:016x}, replayed "
                "{:016x}\n",
                last, world_.time(), recording_.end_hash, world_.state().motion_hash());
            return kMismatch;
        }
        fmt::print("{}: same state hash at all {} frames{}, {} steps, last {:016x}\n",
                   recording_.file, frames, ended ? " and at the end" : "", replayed_steps_,
                   world_.state().motion_hash());
        return report_end();
    }

  private:
    /// Return the number of steps that a replay makes, over all branches of the recording.
    [[nodiscard]] std::int64_t steps_to(std::int64_t last) const {
        std::int64_t steps = 0, begun = recording_.start_step;
        for (const record::RecordedTake& take : recording_.takes) {
            steps += take.from - begun;
            begun = take.to;
        }
        return steps + last - begun;
    }

    /// Step to the end of the recorded run, and apply the changes recorded after the last step.
    int finish_replay(std::int64_t last, Progress& progress) {
        const int code = advance(last, recording_.takes.size(), progress);
        if (code == kOk) repeater_.before_step(world_);
        return code;
    }

    /// Report the end of the recorded run, unless it finished. @return kUsageError if the recording
    /// is incomplete: the missing part was not repeated.
    int report_end() const {
        if (recording_.ending == record::Ending::interrupted)
            fmt::print("the recorded run was interrupted at {:.6g} s\n", world_.time());
        if (recording_.ending == record::Ending::failed)
            fmt::print("the recorded run failed in the step from {:.6g} s\n", world_.time());
        if (recording_.damage.empty()) return kOk;
        fmt::print(stderr,
                   "hawser: {}: the recording is not complete: {}; only the part before it, up to "
                   "{:.6g} s, was repeated\n",
                   recording_.file, recording_.damage, world_.time());
        return kUsageError;
    }

    int advance(std::int64_t to, std::size_t take, Progress& progress) {
        while (world_.step_count() < to || repeater_.take() < take) {
            if (stop_requested()) return kInterrupted;
            repeater_.before_step(world_);
            // A branch may begin with a frame, before its first step.
            if (world_.step_count() == to && repeater_.take() == take) break;
            ++replayed_steps_;
            if (const Status status = world_.step(); status != Status::ok) {
                if (status == Status::cancelled) return kInterrupted;
                progress.close();
                fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}\n", world_.time(),
                           failure(world_));
                return kFailed;
            }
            progress.update(replayed_steps_);
        }
        return kOk;
    }

    const record::Recording& recording_;
    World& world_;
    record::Repeater repeater_;
    std::int64_t replayed_steps_ = 0;
};

int replay(const ReplayOptions& options) {
    const record::Recording recording = record::Recording::open(options.file);
    if (!same_instruction_set(recording)) return kMismatch;
    scene::Scene scene = record::recorded_scene(recording, options.threads);
    World& world = scene.world;
    if (world.state().motion_hash() != recording.start_hash) {
        fmt::print("difference at the start: recorded hash {:016x}, restored {:016x}\n",
                   recording.start_hash, world.state().motion_hash());
        return kMismatch;
    }
    return Replay(recording, world).run(options.quiet);
}

}  // namespace

void add_replay(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command =
        app.add_subcommand("replay", "Repeat a recorded run and compare it bit by bit");
    command->footer(kReplayFooter);
    command->add_option("RECORDING", options->file, "File written by hawser run --record")
        ->required();
    command->add_option("--threads", options->threads, "Worker threads")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    command->add_flag("--quiet", options->quiet, "No progress");
    command->callback([&chosen, options] { chosen = [options] { return replay(*options); }; });
}

}  // namespace hawser::cli
