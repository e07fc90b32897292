// SPDX-License-Identifier: Apache-2.0
#include <hawser/recording.h>
#include "commands.h"
#include "draw/plots.h"
#include "draw/png.h"
#include "draw/raster.h"
#include "record/files.h"
#include "record/names.h"
#include "record/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hawser::cli {

namespace {

constexpr const char* kPlotFooter = R"(Examples:
  hawser plot run.hwr -o pictures
  hawser plot run.hwr -o pictures --at 12.5               # the scene at 12.5 s instead of the end
  hawser plot run.hwr --only scene --view 3d --azimuth -40
  hawser plot run.hwr --only scene --view side --frames 100 --size 1280x720 -o film
  hawser plot run.hwr --only scene --view 3d --axes 0,-20,-10,60,20,30

Writes tensions, wires, motions, scene, space and details, each as .svg and .png.

Exit codes: 0 written, 1 unreadable recording, unknown picture, or a file could not be written.)";

constexpr const char* kPictureNames[] = {"tensions", "wires", "motions",
                                         "scene",    "space", "details"};

struct PlotOptions {
    std::string file, folder = ".", view, size;
    std::vector<std::string> only;
    std::vector<double> axes;
    std::optional<double> at;
    std::size_t frames = 0;
    draw::ViewOptions scene;

    [[nodiscard]] bool is_requested(const std::string& picture) const {
        return only.empty() || std::find(only.begin(), only.end(), picture) != only.end();
    }
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

/// Return the number of pixels per point, so that text is readable in a picture of the given size.
double pixels_per_point(const PlotOptions& options) {
    constexpr double kUsualWidth = 1280.0;  // Usual width [points]
    const int width = options.size.empty() ? 2560 : std::atoi(options.size.c_str());
    return std::clamp(width / kUsualWidth, 0.6, 4.0);
}

/// Return the options for views. @throws std::runtime_error if they are invalid.
draw::ViewOptions view_options(const PlotOptions& options) {
    draw::ViewOptions out = options.scene;
    if (options.view == "side") out.shown = draw::Shown::side;
    if (options.view == "top") out.shown = draw::Shown::top;
    if (options.view == "3d") out.shown = draw::Shown::space;
    if (!options.size.empty()) {
        int width = 0, height = 0;
        char left = 0;
        if (std::sscanf(options.size.c_str(), "%dx%d%c", &width, &height, &left) != 2 ||
            width < 320 || height < 240 || width > 8192 || height > 8192)
            throw std::runtime_error(fmt::format(
                "--size {}: expected WIDTHxHEIGHT, such as 1280x720, from 320x240 to 8192x8192",
                options.size));
        out.width = width / pixels_per_point(options);
        out.height = height / pixels_per_point(options);
    }
    if (!options.axes.empty()) {
        const Vec3 low(options.axes[0], options.axes[1], options.axes[2]),
            high(options.axes[3], options.axes[4], options.axes[5]);
        if (!low.allFinite() || !high.allFinite() || !((high - low).minCoeff() >= 0.0) ||
            !((high - low).maxCoeff() > 0.0))
            throw std::runtime_error("--axes: expected the lower corner x,y,z and the upper one");
        out.box = std::pair(low, high);
    }
    return out;
}

void check_pictures(const PlotOptions& options) {
    const std::vector<std::string> known{std::begin(kPictureNames), std::end(kPictureNames)};
    for (const std::string& name : options.only)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw std::runtime_error(
                fmt::format("--only: there is no picture \"{}\"; nearest: \"{}\"", name,
                            record::nearest_name(name, known)));
}

std::string frame_name(std::size_t i) { return fmt::format("frame_{:04}.png", i); }

/// Write pictures of the scene for a film, with equal axes: frame_0000.png and later numbers.
int plot_frames(const PlotOptions& options, const record::Recording& recording,
                const record::Series& series) {
    const std::size_t n = recording.frame_count(), count = std::min(options.frames, n);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(count == 1 ? n - 1 : i * (n - 1) / (count - 1));
    draw::ViewOptions view = view_options(options);
    if (!view.box) {
        view.box = draw::shown_box(recording, chosen);
        view.around = true;
    }
    const double pixels = options.size.empty() ? 1.5 : pixels_per_point(options);
    if (view.width <= 0.0) view.width = 1280.0, view.height = 720.0;
    std::filesystem::create_directories(options.folder);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const auto drawing = draw::plot_views(recording, series, chosen[i], view);
        if (!drawing) throw record::RecordingError(options.file + ": no object has a position");
        draw::write_png(draw::rasterise(*drawing, pixels),
                        std::filesystem::path(options.folder) / frame_name(i), *drawing);
    }
    fmt::print("wrote {} pictures {}/{} to {}\n", chosen.size(), options.folder, frame_name(0),
               frame_name(chosen.size() - 1));
    return kOk;
}

/// Check that no picture would replace the recording.
void check_names(const PlotOptions& options) {
    const std::filesystem::path folder = options.folder;
    const auto check = [&](const std::filesystem::path& file) {
        if (record::same_file(file, options.file))
            throw std::runtime_error(file.string() + ": would replace the recording");
    };
    for (std::size_t i = 0; i < options.frames; ++i) check(folder / frame_name(i));
    if (options.frames > 0) return;
    for (const char* picture : kPictureNames)
        if (options.is_requested(picture))
            for (const char* ending : {".svg", ".png"})
                check(folder / (picture + std::string(ending)));
}

int plot(const PlotOptions& options) {
    check_pictures(options);
    check_names(options);
    const draw::ViewOptions view = view_options(options);
    const record::Recording recording = record::Recording::open(options.file);
    if (recording.frame_count() == 0)
        throw record::RecordingError(options.file + ": the recording has no complete frame");
    if (!recording.damage.empty())
        fmt::print(stderr, "{}: not complete ({}); plotting its {} frames\n", options.file,
                   recording.damage, recording.frame_count());
    const record::Series series = record::collect_series(recording);
    if (options.frames > 0) return plot_frames(options, recording, series);
    const std::filesystem::path folder = options.folder;
    const std::size_t frame = frame_at(recording, options.at);
    const auto write = [&](const char* name, const auto& make, const char* why_not) {
        if (!options.is_requested(name)) return;
        const std::optional<draw::Drawing> drawing = make();
        if (!drawing) {
            fmt::print("no picture \"{}\": {}\n", name, why_not);
            return;
        }
        for (const auto& file :
             draw::write_pictures(*drawing, folder / name, pixels_per_point(options)))
            fmt::print("wrote {}\n", file.string());
    };
    write(
        "tensions", [&] { return draw::plot_tensions(recording, series); },
        "the scene has no cables");
    write(
        "wires", [&] { return draw::plot_wires(recording, series, frame); },
        "the scene has no cables");
    write(
        "motions", [&] { return draw::plot_motions(recording, series); },
        "the scene has no moving bodies");
    write(
        "scene", [&] { return draw::plot_views(recording, series, frame, view); },
        "no object of the scene has a position");
    write(
        "space", [&] { return draw::plot_space(recording, series, frame, view); },
        "no object of the scene has a position");
    write(
        "details", [&] { return draw::plot_details(recording, frame); },
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
    command
        ->add_option("--at", options->at,
                     "Time of the views, and of tensions along wires [s]; default: the end")
        ->check(finite());
    command
        ->add_option("--only", options->only,
                     "Names of pictures, separated by commas: tensions, wires, motions, scene, "
                     "space, details")
        ->delimiter(',');
    command
        ->add_option("--view", options->view,
                     "Views of `scene`: side, top or 3d; by default side and top")
        ->check(CLI::IsMember({"side", "top", "3d"}));
    command->add_option("--size", options->size,
                        "Size of the pictures of the scene, WIDTHxHEIGHT in pixels");
    command
        ->add_option("--axes", options->axes,
                     "Visible box: lower corner x,y,z and upper corner x,y,z [m]")
        ->delimiter(',')
        ->expected(6);
    command
        ->add_option("--frames", options->frames,
                     "Number of pictures from start to end with equal axes, frame_0000.png and so "
                     "on, instead of other pictures")
        ->check(CLI::Range(1, 100000));
    command
        ->add_option("--azimuth", options->scene.azimuth,
                     "Azimuth of the 3-D camera, from x towards y [deg]")
        ->check(CLI::Range(-360.0, 360.0))
        ->capture_default_str();
    command
        ->add_option("--elevation", options->scene.elevation, "Elevation of the 3-D camera [deg]")
        ->check(CLI::Range(5.0, 85.0))
        ->capture_default_str();
    command->callback([&chosen, options] { chosen = [options] { return plot(*options); }; });
}

}  // namespace hawser::cli
