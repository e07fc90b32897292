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
  hawser run scene.json --control inputs.csv --realtime
  hawser run scene.json --control inputs.csv --control operations.json
  hawser run scene.json --duration 5 --threads 2 --trace run.json --trace run.svg
  hawser run scenes/anchor_contact.json --budget 5 --record run.hwr --summary run.json
  hawser run scene.json --save-at 10 ten.hws; hawser run scene.json --restore ten.hws

The first line of a CONTROL file is "time,<input>,<input>,…". The lines below have a time [s] and
values, which hold until the next line.

Exit codes (files contain the run up to its end in each case):
    0    finished
    1    wrong option, scene or file, or the report could not be printed
    2    a step failed
    130  interrupted (Ctrl-C))";

void add_outputs(CLI::App& command, RunOptions& options) {
    command.add_option("--record", options.record, "Write a recording (for replay and plot)");
    command
        .add_option("--record-every", options.stride,
                    "Steps between frames of --record and --csv; default: 1, or more if the "
                    "recording would exceed 128 MB")
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
                     "End time [s], counted from the start of the scene, also after --restore; "
                     "default: that of the scene")
        ->check(not_negative());
    command->add_flag("--realtime", options->realtime,
                      "Keep pace with the wall clock and report late frames");
    command->add_flag("--rt", options->rt,
                      "Request real-time scheduling and pin each thread to a processor");
    options->scene.add_control_to(*command);
    add_outputs(*command, *options);
    CLI::Option* save =
        command->add_option("--save-at", *save_at, "Save the state at TIME [s] to FILE");
    save->type_name("TIME FILE");
    command->add_option("--restore", options->restore, "Continue from a saved state");
    command
        ->add_option("--budget", options->scene.budget_ms,
                     "Limit of the CPU time of the solver's slowest thread in a step [ms]: contact "
                     "iterations stop before they exceed it; with --coupling deadline, groups "
                     "couple compliantly if the exact step would exceed it")
        ->check(positive());
    command
        ->add_option("--budget-work", options->scene.budget_mflop,
                     "Limit of --budget as work [Mflop], equal on all machines")
        ->check(positive());
    command->add_flag("--verify", options->verify,
                      "Check contacts, momentum and bounds of each step by separate code; a "
                      "deviation ends the run as failed");
    command->add_flag("--unchecked", options->unchecked,
                      "Run a scene whose start `hawser check` rejects");
    command->add_flag("--quiet", options->quiet, "No progress and no report");
    command->add_flag("--verbose", options->verbose,
                      "Report figures of the solver as well: matrix, factorisations, times of "
                      "stages, residuals");
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
