// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "run_session.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <memory>
#include <tuple>

namespace hawser::cli {

namespace {

constexpr const char* kRunFooter = R"(Examples:
  hawser run scenes/pendulum.json --duration 5
  hawser run scenes/anchor_lines.json --duration 60 --record run.hwr --summary run.json
  hawser run scene.json --set settings.step=0.005 --set bodies.rig.mass=2e7 --csv run.csv
  hawser run scene.json --control levers.csv --realtime
  hawser run scene.json --control levers.csv --control operations.json
  hawser run scene.json --duration 5 --threads 2 --trace run.json --trace run.svg
  hawser run scenes/anchor_contact.json --budget 5 --record run.hwr --summary run.json
  hawser run scene.json --save-at 10 ten.hws; hawser run scene.json --restore ten.hws

A CONTROL file has the line "time,<input>,<input>,…" and below it times and values, which hold
until the next line. Exit codes: 0 done, 1 wrong option, scene or file, or a report that could not
be printed, 2 a step failed, 130 interrupted; what there was until then is written in every case.)";

void add_outputs(CLI::App& command, RunOptions& options) {
    command.add_option("--record", options.record, "Write a recording (for replay and plot)");
    command
        .add_option("--record-every", options.stride,
                    "Steps from one frame of --record and --csv to the next; by default 1, or "
                    "more where the recording would exceed 128 MB")
        ->check(CLI::Range(1, 1000000));
    command.add_option("--csv", options.csv, "Write tensions and motions over time");
    command.add_option("--summary", options.summary, "Write the figures of the run as JSON");
    options.trace.add_to(command);
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<RunOptions>();
    auto save_at = std::make_shared<std::tuple<double, std::string>>();
    CLI::App* command = app.add_subcommand("run", "Simulate a scene");
    command->footer(kRunFooter);
    options->scene.add_to(*command);
    command
        ->add_option("--duration", options->duration,
                     "Time at which the run ends [s] instead of the scene's; counted from the "
                     "scene's start, also after --restore")
        ->check(not_negative());
    command->add_flag("--realtime", options->realtime,
                      "Keep pace with the wall clock and report late frames");
    command->add_flag("--rt", options->rt,
                      "Ask for real-time scheduling and processors of its own");
    options->scene.add_control_to(*command);
    add_outputs(*command, *options);
    CLI::Option* save = command->add_option("--save-at", *save_at,
                                            "TIME [s] and FILE: save the state at that time");
    save->type_name("TIME FILE");
    command->add_option("--restore", options->restore, "Continue from a saved state");
    command
        ->add_option("--budget", options->scene.budget_ms,
                     "CPU time of the solver's slowest thread in a step [ms]: the solve for "
                     "contacts ends when another iteration would exceed it; with --coupling "
                     "deadline groups then couple compliantly where one does not fit")
        ->check(positive());
    command
        ->add_option("--budget-work", options->scene.budget_mflop,
                     "The same as work [Mflop], which makes no difference between machines")
        ->check(positive());
    command->add_flag("--verify", options->verify,
                      "Check contacts, momentum and bounds of every step by separate code, and "
                      "fail if they disagree");
    command->add_flag("--unchecked", options->unchecked,
                      "Run a scene even if `hawser check` rejects its start");
    command->add_flag("--quiet", options->quiet, "No progress and no report");
    command->callback([&chosen, options, save_at, save] {
        if (save->count() > 0) std::tie(options->save_time, options->save_file) = *save_at;
        chosen = [options] {
            if (options->rt)
                fmt::print(stderr, "--rt: {}\n", request_realtime(options->scene.threads));
            return RunSession(*options).run();
        };
    });
}

}  // namespace hawser::cli
