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

Prints one address for each role: instructor and watcher, of an exercise also each station. Whoever
has it has the role. Ctrl-C ends it, with the recording closed and the report written.
Exit codes: 0 ended, 1 wrong option, scene or file, or a port that is taken.)";

}  // namespace

void add_view(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command = app.add_subcommand(
        "view", "Show a scene or an exercise while it runs, or a recording, to browsers");
    command->footer(kViewFooter);
    options->scene.add_to(*command);
    command->get_option("SCENE")->description("Scene or exercise (JSON), or a recording (.hwr)");
    command->add_option("--port", options->port, "Port to listen at; 0: any that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command
        ->add_option("--listen", options->listen,
                     "Address to listen at; by default this machine alone can connect")
        ->capture_default_str();
    command->add_option("--clients", options->clients, "Clients at a time")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command->add_option("--record", options->record, "Write a recording (for replay and plot)");
    command
        ->add_option("--record-every", options->stride,
                     "Steps from one frame of --record to the "
                     "next")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    options->scene.add_control_to(*command);
    command->add_option("--restore", options->restore, "Continue from a saved state");
    command->add_option("--report", options->report,
                        "Of an exercise: write a report for the debriefing at the end (HTML)");
    command->add_option("--summary", options->summary,
                        "Of an exercise: write the score at the end (JSON)");
    command
        ->add_option("--budget", options->scene.budget_ms,
                     "CPU time of the solver's slowest thread in a step [ms], as of `run`")
        ->check(positive());
    command
        ->add_option("--budget-work", options->scene.budget_mflop,
                     "The same as work [Mflop], which makes no difference between machines")
        ->check(positive());
    command->add_flag("--rt", options->rt,
                      "Ask for real-time scheduling and processors of its own");
    CLI::Option* go = command->add_flag(
        "--go", options->go, "Begin at once; otherwise the instructor starts in the page");
    command->add_flag("--paused", options->paused, "Wait for a client with a recording, too")
        ->excludes(go);
    command->add_flag("--open", options->open, "Open the instructor's page in a browser");
    command->callback([&chosen, options] { chosen = [options] { return view(*options); }; });
}

}  // namespace hawser::cli
