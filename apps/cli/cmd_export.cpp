// SPDX-License-Identifier: Apache-2.0
#include <hawser/recording.h>
#include "commands.h"
#include "export/export.h"
#include "progress.h"
#include "record/files.h"
#include "repeated_contacts.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

namespace hawser::cli {

namespace {

constexpr const char* kExportFooter = R"(Examples:
  hawser export run.hwr --to gltf                    # run.glb, plays in any glTF viewer
  hawser export run.hwr --to gltf -o run.glb --every 2 --from 10 --to-time 40
  hawser export run.hwr --to vtk -o out/run.pvd      # for ParaView: run.pvd and out/run/*.vtp
  hawser export run.hwr --to vtk --contacts          # with contact forces: repeats the run

Exit codes: 0 written, 1 unreadable recording, no frame between --from and --to-time, or a file could
not be written.)";

struct ExportOptions {
    std::string file, format, output;
    std::size_t every = 1;
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    bool contacts = false, quiet = false;
    int threads = 1;
};

exporting::Frames frames_of(const record::Recording& recording, const ExportOptions& options) {
    exporting::Frames frames =
        exporting::choose_frames(recording, options.every, options.from, options.to);
    if (!frames.empty()) return frames;
    const std::size_t n = recording.frame_count();
    const std::size_t first = exporting::first_frame(recording);
    if (first >= n) throw record::RecordingError(options.file + ": no complete frame");
    throw record::RecordingError(
        fmt::format("{}: no frame between {:.6g} and {:.6g} s; the recording is from {:.6g} to "
                    "{:.6g} s",
                    options.file, options.from, options.to, recording.frame_head(first).time,
                    recording.frame_head(n - 1).time));
}

/// Report the branches of a recording that are not in the file.
void report_branches(const record::Recording& recording) {
    if (recording.takes.empty()) return;
    fmt::print(
        stderr,
        "{}: the run went back {} {}; exporting the part after the last return, from {:.6g} s on\n",
        recording.file, recording.takes.size(), recording.takes.size() == 1 ? "time" : "times",
        recording.frame_head(exporting::first_frame(recording)).time);
}

int export_recording(const ExportOptions& options) {
    const bool gltf = options.format == "gltf";
    const record::Recording recording = record::Recording::open(options.file);
    if (!recording.damage.empty())
        fmt::print(stderr, "{}: not complete ({}); exporting its {} frames\n", options.file,
                   recording.damage, recording.frame_count());
    std::filesystem::path file = options.output;
    if (options.output.empty())
        file = std::filesystem::path(options.file)
                   .filename()
                   .replace_extension(gltf ? ".glb" : ".pvd");
    if (const char* wanted = gltf ? ".glb" : ".pvd"; file.extension() != wanted)
        throw std::runtime_error(fmt::format("{}: the output of --to {} ends in {}", file.string(),
                                             options.format, wanted));
    if (record::same_file(file, options.file))
        throw std::runtime_error(file.string() + ": would replace the recording");
    const exporting::Frames frames = frames_of(recording, options);
    report_branches(recording);
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Progress progress(static_cast<std::int64_t>(frames.size()), recording.settings.step,
                      !options.quiet);
    const auto tell = [&](std::size_t done) { progress.update(static_cast<std::int64_t>(done)); };
    if (gltf) {
        exporting::write_gltf(recording, frames, file, tell);
    } else if (options.contacts) {
        RepeatedContacts contacts(recording, options.threads);
        std::size_t next = 0;  // frames are requested in their order
        exporting::write_vtk(
            recording, frames, file,
            [&](const record::Frame& frame) -> const auto& {
                return contacts.at(frame, frames[next++]);
            },
            tell);
    } else {
        exporting::write_vtk(recording, frames, file, {}, tell);
    }
    progress.close();
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (!options.quiet)
        fmt::print("wrote {}: {} frames in {:.2f} s, {:.0f} frames/s\n", file.string(),
                   frames.size(), seconds, static_cast<double>(frames.size()) / seconds);
    return kOk;
}

}  // namespace

void add_export(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command =
        app.add_subcommand("export", "Write a recording for other programs: glTF, VTK");
    command->footer(kExportFooter);
    command->add_option("RECORDING", options->file, "File written by hawser run --record")
        ->required();
    command->add_option("--to", options->format, "gltf (animated .glb) or vtk (.pvd and .vtp)")
        ->required()
        ->check(CLI::IsMember({"gltf", "vtk"}));
    command->add_option(
        "-o,--output", options->output,
        "File; default: name of the recording with .glb or .pvd, in the current folder");
    command->add_option("--every", options->every, "Export each N-th frame")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--from", options->from, "Start time [s]")->check(finite());
    command->add_option("--to-time", options->to, "End time [s]")->check(finite());
    command->add_flag("--contacts", options->contacts,
                      "With vtk: write contact forces; repeats the run like hawser replay");
    command->add_option("--threads", options->threads, "Worker threads for --contacts")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    command->add_flag("--quiet", options->quiet, "No progress and no report");
    command->callback([&chosen, options] {
        if (options->contacts && options->format != "vtk")
            throw CLI::ValidationError("--contacts", "needs --to vtk: glTF cannot store forces");
        chosen = [options] { return export_recording(*options); };
    });
}

}  // namespace hawser::cli
