// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "view_run.h"

#include <memory>

namespace hawser::cli {

namespace {

constexpr const char* kViewFooter = R"(Examples:
  hawser view scenes/anchor_contact.json
  hawser view scenes/anchor_contact.json --record run.hwr --budget 5
  hawser view run.hwr                            # play a recording
  hawser view exercises/tow_out.json --record run.hwr --report report.html
  hawser view scene.json --listen 0.0.0.0        # for other machines of a trusted network
  hawser view scene.json --restore ten.hws --threads 2 --rt

Prints one address for each role: instructor, watcher, and each station of an exercise. The holder
of an address has its role. Ctrl-C ends the run, closes the recording and writes the report.

Exit codes: 0 ended, 1 wrong option, scene or file, or the port is in use.)";

}  // namespace

void add_view(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command = app.add_subcommand(
        "view", "Serve a running scene or exercise, or a recording, to browsers");
    command->footer(kViewFooter);
    options->scene.add_to(*command);
    command->get_option("SCENE")->description("Scene or exercise (JSON), or a recording (.hwr)");
    command->add_option("--port", options->port, "TCP port; 0: any free port")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command
        ->add_option("--listen", options->listen,
                     "Address; the default accepts connections from this machine only")
        ->capture_default_str();
    command->add_option("--clients", options->clients, "Largest number of clients at a time")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command->add_option("--record", options->record, "Write a recording (for replay and plot)");
    command->add_option("--record-every", options->stride, "Steps between frames of --record")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    options->scene.add_control_to(*command);
    command->add_option("--restore", options->restore, "Continue from a saved state");
    command->add_option("--report", options->report,
                        "Report for the debriefing, written at the end of an exercise (HTML)");
    command->add_option("--summary", options->summary,
                        "Score, written at the end of an exercise (JSON)");
    command
        ->add_option("--budget", options->scene.budget_ms,
                     "Limit of the solver's CPU time in a step [ms], as in `run`")
        ->check(positive());
    command
        ->add_option("--budget-work", options->scene.budget_mflop,
                     "Limit of --budget as work [Mflop], equal on all machines")
        ->check(positive());
    command->add_flag("--rt", options->rt,
                      "Request real-time scheduling and pin each thread to a processor");
    CLI::Option* start_at_once =
        command->add_flag("--go", options->start_at_once,
                          "Start at once; default: the instructor starts in the page");
    command->add_flag("--paused", options->paused, "Wait for a client, also with a recording")
        ->excludes(start_at_once);
    command->add_flag("--open", options->open, "Open the instructor's page in a browser");
    command->callback([&chosen, options] { chosen = [options] { return view(*options); }; });
}

}  // namespace hawser::cli
