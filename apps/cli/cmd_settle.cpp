// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "progress.h"
#include "scene_options.h"
#include "signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace hawser::cli {

namespace {

constexpr const char* kFooter = R"(Examples:
  hawser settle scenes/anchor_lines.json -o scenes/anchor_lines.settled.json

Integrates the scene with strong added damping until nothing moves, and writes the place of
every body as a state file, which a scene names under "state". Exit codes: 0 settled, 1 wrong
option, scene or file, 2 a step failed or nothing settled within --max-time (the state reached is
written all the same), 130 interrupted (likewise).)";

struct SettleOptions {
    SceneOptions scene;
    std::string output;
    double max_time = 2000.0;
    double tolerance = 1e-5;
    bool quiet = false;
};

bool moves(const World& world, BodyId body) {
    const BodyKind kind = world.body_def(body).kind;
    return kind == BodyKind::rigid || kind == BodyKind::lump || kind == BodyKind::scalar;
}

struct Motion {
    double kinetic = 0.0;  ///< Σ m v²/2 + ω·I ω/2 [J].
    double fastest = 0.0;  ///< Largest speed of a centre of mass [m/s] …
    BodyId where{};
    double spin = 0.0;  ///< … and of a rotation, times the body's radius of gyration [m/s].
};

Motion motion_of(const World& world) {
    Motion out;
    for (std::int32_t i = 0; i < world.body_count(); ++i) {
        if (!moves(world, {i})) continue;
        const BodyDef& def = world.body_def({i});
        const Twist v = world.velocity({i});
        double speed = v.linear.norm();
        out.kinetic += 0.5 * def.mass * v.linear.squaredNorm();
        if (def.kind == BodyKind::rigid) {
            const Vec3 local = world.pose({i}).orientation.conjugate() * v.angular;
            const double rotational = local.dot(def.inertia * local);
            out.kinetic += 0.5 * rotational;
            speed = std::max(speed, std::sqrt(std::max(0.0, rotational) / def.mass));
        }
        if (speed > out.fastest) {
            out.fastest = speed;
            out.where = {i};
        }
    }
    return out;
}

void scale_velocities(World& world, double factor) {
    for (std::int32_t i = 0; i < world.body_count(); ++i) {
        if (!moves(world, {i})) continue;
        Twist v = world.velocity({i});
        v.linear *= factor;
        v.angular *= factor;
        world.set_velocity({i}, v);
    }
}

/// Kinetic damping (Cundall, "Explicit finite-difference methods in geomechanics", 1976):
/// undamped motion is stopped whenever its kinetic energy peaks, which is where the potential
/// energy is lowest along the path. At first speeds are limited besides, so that a scene
/// far from rest does not throw its bodies about.
class Settler {
  public:
    Settler(scene::Scene& scene, const SettleOptions& options)
        : scene_(scene), world_(scene.world), options_(options) {}

    int run() {
        const double h = world_.settings().step;
        const auto steps = static_cast<std::int64_t>(std::ceil(options_.max_time / h));
        catch_signals();
        Progress progress(steps, h, !options_.quiet);
        for (std::int64_t step = 1; step <= steps; ++step) {
            if (stop_requested()) return kInterrupted;
            if (const Status status = world_.step(); status != Status::ok) {
                progress.close();
                fmt::print(stderr, "hawser: the step from {:.6g} s failed: {}\n", world_.time(),
                           to_string(status));
                return kFailed;
            }
            damp(h);
            progress.at(step, fmt::format("fastest {:.2e} m/s ({}), stopped {} times",
                                          last_peak_.fastest, name(last_peak_.where), stops_));
            if (quiet_peaks_ >= kQuietPeaks) {
                progress.close();
                return kOk;
            }
        }
        progress.close();
        fmt::print(stderr, "hawser: not settled after {:.6g} s: {} still moves at {:.3g} m/s\n",
                   options_.max_time, name(last_peak_.where), last_peak_.fastest);
        return kFailed;
    }

    [[nodiscard]] const Motion& last_peak() const noexcept { return last_peak_; }
    [[nodiscard]] std::int64_t stops() const noexcept { return stops_; }
    [[nodiscard]] std::string name(BodyId body) const { return observe::body_label(world_, body); }

  private:
    // Peaks below the tolerance before the scene counts as settled: one alone may be a node
    // of slow motion.
    static constexpr int kQuietPeaks = 5;
    // A slow drift has no peak for long; it counts as quiet after this many slow steps.
    static constexpr int kQuietSteps = 1200;
    // Speed limit in the first seconds [m/s], growing to no limit.
    static constexpr double kFirstLimit = 0.05, kRampTime = 20.0;

    void damp(double h) {
        const Motion now = motion_of(world_);
        const bool peak = now.kinetic < before_.kinetic;
        slow_steps_ = now.fastest < options_.tolerance ? slow_steps_ + 1 : 0;
        if (peak || slow_steps_ >= kQuietSteps) {
            last_peak_ = before_;
            quiet_peaks_ = before_.fastest < options_.tolerance ? quiet_peaks_ + 1 : 0;
            if (slow_steps_ >= kQuietSteps) quiet_peaks_ = kQuietPeaks;
            scale_velocities(world_, 0.0);
            before_ = {};
            ++stops_;
            return;
        }
        before_ = now;
        const double age = world_.time() / kRampTime;
        const double limit = age < 1.0 ? kFirstLimit * std::pow(100.0, age) : HUGE_VAL;
        if (now.fastest > limit) {
            scale_velocities(world_, limit / now.fastest);
            before_.kinetic *= (limit / now.fastest) * (limit / now.fastest);
        }
        (void)h;
    }

    scene::Scene& scene_;
    World& world_;
    const SettleOptions& options_;
    Motion before_, last_peak_;
    int quiet_peaks_ = 0, slow_steps_ = 0;
    std::int64_t stops_ = 0;
};

int settle(const SettleOptions& options) {
    scene::Scene scene = options.scene.load();
    World& world = scene.world;
    std::vector<Pose> start;
    for (std::int32_t i = 0; i < world.body_count(); ++i) start.push_back(world.pose({i}));
    Settler settler(scene, options);
    const int code = settler.run();
    scale_velocities(world, 0.0);
    double moved = 0.0;
    BodyId where{};
    for (std::int32_t i = 0; i < world.body_count(); ++i) {
        const double d =
            (world.pose({i}).position - start[static_cast<std::size_t>(i)].position).norm();
        if (d > moved) {
            moved = d;
            where = {i};
        }
    }
    std::filesystem::path output = options.output;
    if (output.empty())
        output = std::filesystem::path(options.scene.file).replace_extension(".settled.json");
    std::ofstream out(output, std::ios::binary);
    out << scene::state_text(scene);
    out.close();
    if (!out) throw std::runtime_error(fmt::format("{}: cannot write the state", output.string()));
    fmt::print(
        "{}: {} after {:.6g} s, stopped {} times; last peak {:.3g} m/s at {}; {} moved "
        "most, by {:.4g} m\nwrote {}\n",
        scene.name, code == kOk ? "settled" : "not settled", world.time(), settler.stops(),
        settler.last_peak().fastest, settler.name(settler.last_peak().where), settler.name(where),
        moved, output.string());
    return code;
}

}  // namespace

void add_settle(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<SettleOptions>();
    CLI::App* command = app.add_subcommand("settle", "Find the pose in which a scene rests");
    command->footer(kFooter);
    options->scene.add_to(*command);
    command->add_option("-o,--output", options->output,
                        "State file; by default SCENE with the ending .settled.json");
    command->add_option("--max-time", options->max_time, "Give up after this simulated time [s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command
        ->add_option("--tolerance", options->tolerance,
                     "Settled when no body is faster than this [m/s]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_flag("--quiet", options->quiet, "No progress");
    command->callback([&chosen, options] { chosen = [options] { return settle(*options); }; });
}

}  // namespace hawser::cli
