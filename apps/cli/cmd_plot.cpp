// SPDX-License-Identifier: Apache-2.0
#include <hawser/recording.h>
#include "commands.h"
#include "draw/plots.h"
#include "draw/png.h"
#include "record/series.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace hawser::cli {

namespace {

constexpr const char* kPlotFooter = R"(Examples:
  hawser plot run.hwr -o pictures
  hawser plot run.hwr -o pictures --at 12.5     # the scene at 12.5 s instead of the end

Writes tensions, wires, motions, scene and details, each as .svg and .png. Exit codes: 0 written, 1 unreadable
recording or a file that cannot be written.)";

struct PlotOptions {
    std::string file, folder = ".";
    std::optional<double> at;
};

std::size_t frame_at(const record::Recording& recording, std::optional<double> time) {
    const std::size_t n = recording.frame_count();
    if (!time) return n - 1;
    std::size_t best = 0;
    for (std::size_t i = 1; i < n; ++i)
        if (std::abs(recording.frame_head(i).time - *time) <
            std::abs(recording.frame_head(best).time - *time))
            best = i;
    return best;
}

int plot(const PlotOptions& options) {
    const record::Recording recording = record::Recording::open(options.file);
    if (recording.frame_count() == 0)
        throw record::RecordingError(options.file + ": the recording has no complete frame");
    if (!recording.damage.empty())
        fmt::print(stderr, "{}: not complete ({}); plotting its {} frames\n", options.file,
                   recording.damage, recording.frame_count());
    const record::Series series = record::collect_series(recording);
    const std::filesystem::path folder = options.folder;
    const auto write = [&](const char* name, const std::optional<draw::Drawing>& drawing,
                           const char* why_not) {
        if (!drawing) {
            fmt::print("no picture \"{}\": {}\n", name, why_not);
            return;
        }
        for (const auto& file : draw::write_pictures(*drawing, folder / name))
            fmt::print("wrote {}\n", file.string());
    };
    write("tensions", draw::plot_tensions(recording, series), "the scene has no cables");
    write("wires", draw::plot_wires(recording, series), "the scene has no cables");
    write("motions", draw::plot_motions(recording, series), "the scene has no moving bodies");
    write("scene", draw::plot_views(recording, series, frame_at(recording, options.at)),
          "nothing in the scene has a place");
    write("details", draw::plot_details(recording, frame_at(recording, options.at)),
          "no plotted body is small in the scene");
    return kOk;
}

}  // namespace

void add_plot(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<PlotOptions>();
    CLI::App* command = app.add_subcommand("plot", "Draw pictures of a recording");
    command->footer(kPlotFooter);
    command->add_option("RECORDING", options->file, "File written by hawser run --record")
        ->required();
    command->add_option("-o,--output", options->folder, "Folder for the pictures")
        ->capture_default_str();
    command->add_option("--at", options->at, "Time of the views of the scene [s]; else the end")
        ->check(finite());
    command->callback([&chosen, options] { chosen = [options] { return plot(*options); }; });
}

}  // namespace hawser::cli
