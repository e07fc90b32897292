// SPDX-License-Identifier: Apache-2.0
#include "view_run.h"

#include <hawser/exercise.h>
#include <hawser/recording.h>
#include "commands.h"
#include "debrief/debrief.h"
#include "live/debriefing.h"
#include "live/driver.h"
#include "live/page_files.h"
#include "live/player.h"
#include "live/server.h"
#include "outputs.h"
#include "realtime.h"
#include "signals.h"

#include <fmt/format.h>
#include <spawn.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

extern char** environ;

namespace hawser::cli {

namespace {

/// True if the file begins with the signature of a recording (docs/recording.md).
bool is_recording(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string head(8, '\0');
    return in.read(head.data(), 8) && head == "HAWSERRC";
}

/// Open an address in the browser of the desktop. Without a desktop, the user opens the printed
/// address.
void open_browser(const std::string& address) {
    std::string program = "xdg-open", argument = address;
    char* const argv[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, argv, environ) != 0)
        fmt::print(stderr, "--open: there is no xdg-open; open the address by hand\n");
}

live::ServerOptions server_options(const ViewOptions& options, std::vector<live::Role> roles,
                                   bool recording) {
    live::ServerOptions out;
    out.address = options.listen;
    out.port = static_cast<std::uint16_t>(options.port);
    out.clients = options.clients;
    out.roles = std::move(roles);
    out.recording = recording;
    out.log = [](const std::string& line) { fmt::print(stderr, "hawser view: {}\n", line); };
    return out;
}

void print_addresses(const live::Server& server, const live::ServerOptions& options) {
    if (!live::has_page())
        fmt::print(stderr,
                   "hawser view: this program was built without its page, because node was "
                   "missing. Browsers show a note instead. Build the page in the folder of the "
                   "sources: make view\n");
    for (const live::Role& role : options.roles)
        fmt::print("{:<12} {}\n", role.name, server.address_of(role));
    if (options.address != "127.0.0.1" && options.address != "::1")
        fmt::print(
            "anyone on this network with such an address has its role; the connection is not "
            "encrypted\n");
    fmt::print("Ctrl-C ends it\n");
    std::fflush(stdout);
}

Session open_session(const ViewOptions& options) {
    scene::Scene scene = options.scene.load();
    std::vector<NamedFile> inputs{{"the control file", options.scene.control()},
                                  {"the saved state", options.restore}};
    for (const std::filesystem::path& file : scene.files)
        inputs.push_back({"a file of the scene", file.string()});
    check_outputs(inputs, {{"--record", options.record}});
    return Session(std::move(scene), {.restore = options.restore,
                                      .control = options.scene.control(),
                                      .record = options.record,
                                      .every = options.stride});
}

/// Step a session for clients until a signal, and close it. @param then  Writes the final outputs.
/// It runs before connections are closed, so that clients cannot prevent it.
void serve(const ViewOptions& options, Session& session, const live::DriverOptions& how,
           std::vector<live::Role> roles, const std::function<void()>& then) {
    live::Hub hub;
    live::Driver driver(session, hub, how);
    const live::ServerOptions to_serve = server_options(options, std::move(roles), false);
    live::Server server(hub, to_serve);
    catch_signals();  // before the addresses: a reader of these may end the program at once
    print_addresses(server, to_serve);
    if (options.open) open_browser(server.address_of(to_serve.roles.front()));
    // The server's thread already runs and therefore does not inherit this request.
    if (options.rt) fmt::print(stderr, "--rt: {}\n", request_realtime(options.scene.threads));
    const CancelledBySignal cancelled(session.world());
    driver.run([] { return stop_requested(); });
    if (how.run != nullptr) how.run->end("interrupted", true);
    session.finish();
    fmt::print("{:.6g} s in {} steps{}\n", session.time(), session.world().step_count(),
               options.record.empty() ? "" : ", recorded in " + options.record);
    then();
}

int view_scene(const ViewOptions& options) {
    if (!options.report.empty() || !options.summary.empty())
        throw std::runtime_error(
            options.scene.file +
            ": a scene has no score: --report and --summary are for exercises");
    Session session = open_session(options);
    serve(options, session, {.recording = options.record, .paused = !options.start_at_once},
          {live::instructor(), live::watcher()}, [] {});
    return kOk;
}

void check_exercise_files(const ViewOptions& options, const scene::Scene& scene) {
    if (!options.restore.empty() || !options.scene.controls.empty())
        throw std::runtime_error(options.scene.file +
                                 ": an exercise begins at its start and is driven by its stations: "
                                 "--restore and --control are for scenes");
    std::vector<NamedFile> inputs{{"the exercise", options.scene.file}};
    for (const std::filesystem::path& file : scene.files)
        inputs.push_back({"a file of the scene", file.string()});
    check_outputs(inputs, {{"--record", options.record},
                           {"--report", options.report},
                           {"--summary", options.summary}});
}

/// Write the score, the summary and the report of an exercise after its end.
void close_exercise(const ViewOptions& options, const std::string& recording,
                    const exercise::Exercise& exercise, const exercise::Run& run) {
    const exercise::Result& result = run.result();
    fmt::print("{}: {}, {:.6g} of {:.6g} points, {}\n", result.exercise,
               exercise::to_string(result.outcome), result.points, result.possible, result.end);
    if (!options.summary.empty())
        write_output(options.summary, exercise::to_json(result), "the summary");
    if (options.report.empty()) return;
    const record::Recording whole = record::Recording::open(recording);
    write_output(options.report, debrief::to_html(exercise, result, run.curves(), &whole),
                 "the report");
}

int view_exercise(const ViewOptions& options) {
    exercise::Loaded loaded = exercise::load_file(options.scene.file, options.scene.options());
    check_exercise_files(options, loaded.scene);
    std::vector<live::Role> roles = live::roles_of(loaded.exercise);
    TemporaryFile temporary;
    const std::string recording = recording_for(options.record, options.report, temporary);
    Session session(std::move(loaded.scene), {.record = recording, .every = options.stride});
    exercise::Run run(loaded.exercise, session);
    serve(options, session,
          {.recording = options.record,
           .paused = !options.start_at_once,
           .exercise = &loaded.exercise,
           .run = &run,
           .report =
               [&](const std::string& people) {
                   return debrief::to_html(loaded.exercise, run.result(), run.curves(), nullptr,
                                           people);
               }},
          std::move(roles), [&] { close_exercise(options, recording, loaded.exercise, run); });
    return kOk;
}

/// Compute the score of a recorded exercise. @return an empty debriefing for a recording of a
/// scene.
/// @param score  Kept by the caller while the debriefing is used.
live::Debriefing make_debriefing(const record::Recording& recording, int threads,
                                 std::optional<exercise::Rescored>& score) {
    if (!exercise::is_recorded(recording)) return {};
    fmt::print("computing the score of the recording\n");
    std::fflush(stdout);
    try {
        score = exercise::rescore(recording, threads);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: shown without its score: {}\n", recording.file, error.what());
        return {};
    }
    if (!score->same)
        fmt::print(stderr, "{}: the score may differ: {}\n", recording.file, score->difference);
    const exercise::Result& r = score->result;
    fmt::print("{}: {}, {:.6g} of {:.6g} points\n", r.exercise, exercise::to_string(r.outcome),
               r.points, r.possible);
    return {.text = live::debriefing_json(score->exercise, r, score->curves, score->requests)
                        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
            .report = [&recording, &score](const std::string& people) {
                return debrief::to_html(score->exercise, score->result, score->curves, &recording,
                                        people);
            }};
}

int view_recording(const ViewOptions& options) {
    if (!options.record.empty() || !options.restore.empty() || !options.scene.controls.empty())
        throw std::runtime_error(
            options.scene.file +
            ": a recording cannot be changed: --record, --restore and --control are for scenes");
    if (!options.report.empty() || !options.summary.empty())
        throw std::runtime_error(
            options.scene.file +
            ": the score of a recording is that of `hawser exercise --replay`, "
            "which also writes --report and --summary");
    const record::Recording recording = record::Recording::open(options.scene.file);
    if (!recording.damage.empty())
        fmt::print(stderr, "{}: not complete: {}\n", recording.file, recording.damage);
    std::optional<exercise::Rescored> score;
    live::Hub hub;
    live::Player player(recording, hub, make_debriefing(recording, options.scene.threads, score));
    if (!player.fault().empty())
        fmt::print(stderr, "{}: shown without its shapes: {}\n", recording.file, player.fault());
    const live::ServerOptions to_serve =
        server_options(options, {live::instructor(), live::watcher()}, true);
    live::Server server(hub, to_serve);
    catch_signals();
    print_addresses(server, to_serve);
    if (options.open) open_browser(server.address_of(to_serve.roles.front()));
    player.run([] { return stop_requested(); });
    return kOk;
}

}  // namespace

int view(const ViewOptions& options) {
    if (is_recording(options.scene.file)) return view_recording(options);
    return exercise::is_exercise(options.scene.file) ? view_exercise(options) : view_scene(options);
}

}  // namespace hawser::cli
