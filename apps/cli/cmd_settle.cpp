// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "failure.h"
#include "outputs.h"
#include "progress.h"
#include "scene_options.h"
#include "settle_world.h"
#include "signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace hawser::cli {

namespace {

constexpr const char* kSettleFooter = R"(Examples:
  hawser settle scenes/anchor_lines.json -o scenes/anchor_lines.settled.json

Simulates the scene with strong added damping until all bodies rest. Writes their poses as a state
file, which a scene names under "state". The sea has its mean current and wind without waves and
gusts. Winches hold: by their motors at zero speed if they are driven, else by their brakes.

Exit codes (1: no file is written):
    0    at rest
    1    wrong option, scene or file
    2    a step failed, or not at rest within --max-time
    130  interrupted (Ctrl-C))";

struct SettleOptions {
    SceneOptions scene;
    std::string output;
    double max_time = 2000.0;
    double tolerance = 1e-5;
    bool quiet = false;
};

struct Motion {
    double fastest = 0.0;  ///< Largest speed of a centre of mass, or of a rotation times the
                           ///< body's radius of gyration [m/s] …
    BodyId where{};        ///< … and its body.
};

Motion measure_motion(const World& world) {
    Motion out;
    for (const BodyId id : world.bodies()) {
        if (!moves(world, id)) continue;
        const BodyDef& def = world.body_def(id);
        const Twist v = world.velocity(id);
        double speed = v.linear.norm();
        if (def.kind == BodyKind::rigid) {
            const Vec3 local = world.pose(id).orientation.conjugate() * v.angular;
            speed = std::max(speed,
                             std::sqrt(std::max(0.0, local.dot(def.inertia * local)) / def.mass));
        }
        if (speed > out.fastest) out = {speed, id};
    }
    return out;
}

/// Settles the scene with large drag first, which brings lines to rest. The drag then decreases in
/// stages, because it also delays slow motion. A mode of frequency ω under drag of stop time T
/// creeps at the rate ω² T.
class RestSearch {
  public:
    RestSearch(scene::Scene& scene, const SettleOptions& options)
        : scene_(scene), options_(options) {}

    int run() {
        const double h = scene_.world.settings().step;
        const auto steps =
            static_cast<std::int64_t>(std::min(std::ceil(options_.max_time / h), 0x1p53));
        catch_signals();
        Progress progress(steps, h, !options_.quiet);
        World still = still_world(scene_.world);
        for (double stop_time : {0.1, 0.3, 1.0, 4.0, 15.0}) {
            const bool last = stop_time == 15.0;
            World world = with_drag(still, stop_time);
            const int code =
                run_stage(world, last ? HUGE_VAL : 20.0 + 4.0 * stop_time, last, steps, progress);
            for (const BodyId id : scene_.world.bodies()) {
                if (!moves(scene_.world, id) || !world.alive(id)) continue;
                still.set_pose(id, world.pose(id));
                scene_.world.set_pose(id, world.pose(id));
            }
            if (code != kOk || settled_) {
                progress.close();
                return code;
            }
        }
        return kFailed;  // Unreachable: the last stage has no end of its own.
    }

    [[nodiscard]] double time() const {
        return static_cast<double>(step_) * scene_.world.settings().step;
    }
    [[nodiscard]] const Motion& motion() const noexcept { return motion_; }
    [[nodiscard]] std::string name(BodyId body) const {
        return record::body_label(scene_.world, body);
    }

  private:
    // Required time of slow motion [s]. A single slow moment may be the turning point of an
    // oscillation.
    static constexpr double kQuietTime = 20.0;

    int run_stage(World& world, double duration, bool last, std::int64_t steps,
                  Progress& progress) {
        const double h = world.settings().step;
        const CancelledBySignal cancelled(world);
        double quiet = 0.0;
        while (world.time() < duration && quiet < kQuietTime) {
            if (stop_requested()) return kInterrupted;
            if (step_ >= steps) {
                progress.close();
                fmt::print(stderr,
                           "hawser: not settled after {:.6g} s: {} still moves at {:.3g} "
                           "m/s\n",
                           time(), name(motion_.where), motion_.fastest);
                return kFailed;
            }
            if (const Status status = world.step(); status != Status::ok) {
                if (status == Status::cancelled) return kInterrupted;
                progress.close();
                fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}\n", time(),
                           failure(world));
                return kFailed;
            }
            if (const std::string other = unsaved_difference(world); !other.empty()) {
                progress.close();
                fmt::print(stderr, "hawser: not settled: at {:.6g} s {}\n", time(), other);
                return kFailed;
            }
            motion_ = measure_motion(world);
            quiet = motion_.fastest < options_.tolerance ? quiet + h : 0.0;
            progress.update(++step_, fmt::format("fastest {:.2e} m/s ({})", motion_.fastest,
                                                 name(motion_.where)));
        }
        settled_ = last && quiet >= kQuietTime;
        return kOk;
    }

    /// Describe changes of the world that a state file cannot store: broken elements, and nodes
    /// added or removed at a drum or by refinement. @return the description; empty: none.
    [[nodiscard]] std::string unsaved_difference(const World& world) const {
        if (const EventExtremes part = world.events().extremes(EventKind::line_break);
            part.count > 0)
            return "the element " + record::interaction_label(world, part.first.interaction) +
                   " broke on the way; start nearer to rest, or give it a larger breaking load";
        const auto now = world.bodies(), stored = scene_.world.bodies();
        if (std::equal(now.begin(), now.end(), stored.begin(), stored.end())) return {};
        std::string where;
        for (const BodyId id : stored)
            if (where.empty() && !world.alive(id)) where = "the node " + name(id) + " went";
        for (const BodyId id : now)
            if (where.empty() && !scene_.world.alive(id))
                where = "the node " + record::body_label(world, id) + " came";
        return where +
               ": a state file holds the bodies of the scene alone; leave out resolutions "
               "of its wires, or let its winches hold more";
    }

    scene::Scene& scene_;
    const SettleOptions& options_;
    Motion motion_;
    std::int64_t step_ = 0;
    bool settled_ = false;
};

int settle(const SettleOptions& options) {
    scene::Scene scene = options.scene.load();
    World& world = scene.world;
    const std::filesystem::path output =
        options.output.empty()
            ? std::filesystem::path(options.scene.file).replace_extension(".settled.json")
            : std::filesystem::path(options.output);
    // The scene's own state file may be written: settling starts from the last state of rest.
    std::vector<NamedFile> inputs;
    for (const std::filesystem::path& file : scene.files)
        if (file != scene.state_file) inputs.push_back({"a file of the scene", file.string()});
    check_outputs(inputs, {{"--output", output.string()}});
    std::vector<Pose> start;
    for (const BodyId id : world.bodies()) start.push_back(world.pose(id));
    RestSearch settler(scene, options);
    const int code = settler.run();
    for (const BodyId id : world.bodies())
        if (moves(world, id)) world.set_velocity(id, {});
    double moved = 0.0;
    BodyId where{};
    std::size_t next = 0;
    for (const BodyId id : world.bodies()) {
        const double d = (world.pose(id).position - start[next++].position).norm();
        if (d > moved) {
            moved = d;
            where = id;
        }
    }
    write_output(output.string(), scene::state_text(scene), "the state");
    fmt::print(
        "{}: {} after {:.6g} s; {} still moves at {:.3g} m/s; {} moved most, by {:.4g} m\n"
        "wrote {}\n",
        scene.name, code == kOk ? "settled" : "not settled", settler.time(),
        settler.name(settler.motion().where), settler.motion().fastest, settler.name(where), moved,
        output.string());
    return code;
}

}  // namespace

void add_settle(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<SettleOptions>();
    CLI::App* command = app.add_subcommand("settle", "Compute the pose of a scene at rest");
    command->footer(kSettleFooter);
    options->scene.add_to(*command);
    command->add_option("-o,--output", options->output,
                        "State file; by default SCENE with the ending .settled.json");
    command->add_option("--max-time", options->max_time, "Longest simulated time [s]")
        ->check(positive())
        ->capture_default_str();
    command->add_option("--tolerance", options->tolerance, "Largest speed of a body at rest [m/s]")
        ->check(positive())
        ->capture_default_str();
    command->add_flag("--quiet", options->quiet, "No progress");
    command->callback([&chosen, options] { chosen = [options] { return settle(*options); }; });
}

}  // namespace hawser::cli
