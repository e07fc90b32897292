// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "figure_panels.h"
#include "observe/figures/panel.h"
#include "observe/host.h"
#include "observe/png.h"
#include "scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace hawser::cli {

namespace {

constexpr const char* kFiguresFooter = R"(Examples:
  hawser figures -o out                              # of scenes/anchor_lines.json
  hawser figures scenes/anchor_contact.json -o out --at 2

Writes each panel of the two figures of the paper as .svg and .png with its data as .json, and each
figure on one page. Exit codes: 0 written, 1 wrong option, scene or file, 2 a step failed.)";

constexpr const char* kDefaultScene = "scenes/anchor_lines.json";

struct FiguresOptions {
    SceneOptions scene;
    std::string folder = ".";
    double at = 1.0;
    int samples = 21;
};

/// The scene of the figures, seen from here or from where the program stands: in a folder above it
/// (built) or in share/hawser beside it (installed).
std::string default_scene() {
    std::vector<std::filesystem::path> places{"."};
    std::error_code error;
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error);
    while (!error && folder.has_relative_path()) {
        folder = folder.parent_path();
        places.push_back(folder / "share" / "hawser");
        places.push_back(folder);
    }
    for (const auto& place : places)
        if (std::filesystem::exists(place / kDefaultScene, error))
            return (place / kDefaultScene).lexically_normal().string();
    throw std::runtime_error(
        fmt::format("{} is neither here nor near the program; name a scene: hawser figures SCENE "
                    "-o FOLDER",
                    kDefaultScene));
}

/// Everything that all panels have in common.
nlohmann::ordered_json origin_of(const scene::Scene& scene, const FiguresOptions& options) {
    return {{"scene", scene.name},
            {"scene_file", scene.path},
            {"scene_hash", fmt::format("{:016x}", scene.hash)},
            {"time", scene.world.time()},
            {"state_hash", fmt::format("{:016x}", scene.world.state_hash())},
            {"command", command_line()},
            {"instruction_set", instruction_set()},
            {"processor", observe::processor_model()},
            {"processors", observe::processor_count()},
            {"threads", options.scene.threads},
            {"version", version()}};
}

/// Step until `at`. @return the status of the last step.
Status run_to(World& world, double at) {
    Status status = Status::ok;
    // Half a step early: time is a sum of steps.
    do status = world.step();
    while (status == Status::ok && world.time() < at - 0.5 * world.settings().step);
    return status;
}

class Writer {
  public:
    Writer(const FiguresOptions& options, const scene::Scene& scene)
        : folder_(options.folder), origin_(origin_of(scene, options)) {
        parameters_ = fmt::format(
            "{} at {:.4g} s  ·  scene hash {:016x}  ·  {}  ·  {}  ·  Hawser {}", scene.name,
            scene.world.time(), scene.hash, command_line(), instruction_set(), version());
    }

    void panel(const std::string& figure, Panel& panel) {
        panel.drawing.description += (panel.drawing.description.empty() ? "" : "; ") + parameters_;
        pictures(panel.drawing, panel.name);
        nlohmann::ordered_json data{
            {"figure", figure}, {"panel", panel.name}, {"title", panel.drawing.title}};
        data.update(origin_);
        data.update(panel.data);
        const std::filesystem::path file = folder_ / (panel.name + ".json");
        std::ofstream out(file);
        out << data.dump() << '\n';
        if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
        fmt::print("wrote {}\n", file.string());
    }

    void page(const std::string& name, const std::string& title,
              const std::vector<std::vector<const observe::Drawing*>>& rows) {
        pictures(observe::make_page(title, parameters_, rows), name);
    }

  private:
    void pictures(const observe::Drawing& drawing, const std::string& name) {
        for (const auto& file : observe::write_pictures(drawing, folder_ / name))
            fmt::print("wrote {}\n", file.string());
    }

    std::filesystem::path folder_;
    nlohmann::ordered_json origin_;
    std::string parameters_;
};

int figures(FiguresOptions options) {
    if (options.scene.file.empty()) options.scene.file = default_scene();
    if (!options.scene.form) options.scene.form = "saddle";
    scene::Scene scene = options.scene.load();
    if (const Status status = run_to(scene.world, options.at); status != Status::ok) {
        fmt::print(stderr, "hawser: the step at {:.4g} s failed: {}\n", scene.world.time(),
                   to_string(status));
        return kFailed;
    }
    Writer writer(options, scene);
    const observe::BlockGraph whole = observe::graph_of(scene.world.inspect());
    std::vector<OrderedMatrix> full;
    for (const Ordering o : {Ordering::natural, Ordering::amd, Ordering::metis})
        full.push_back(order_matrix(whole, 0, o));
    time_matrices({&full[0], &full[1], &full[2]}, options.samples);

    const observe::InteractionGraph graph = observe::interaction_graph(scene.world);
    Panel matrix = matrix_panel("fig1_matrix", "System matrix", full[0]);
    Panel interactions = graph_panel(
        "fig1_graph", "Interaction graph",
        {fmt::format("{} bodies, {} interactions", graph.nodes.size(), graph.edges.size())}, graph,
        false);
    writer.panel("1", matrix);
    writer.panel("1", interactions);
    writer.page("fig1", "Fig. 1: system and interaction graph",
                {{&matrix.drawing, &interactions.drawing}});

    std::vector<Panel> spies;
    static constexpr const char* kTitles[] = {"Full, natural order",
                                              "Full, approximate minimum degree (AMD)",
                                              "Full, nested dissection (METIS)"};
    static constexpr const char* kNames[] = {"fig2_full_natural", "fig2_full_amd",
                                             "fig2_full_metis"};
    for (std::size_t k = 0; k < full.size(); ++k)
        spies.push_back(fill_panel(kNames[k], kTitles[k], full[k]));
    for (Panel& p : spies) writer.panel("2", p);
    writer.page("fig2", "Fig. 2: fill of the factor",
                {{&spies[0].drawing, &spies[1].drawing, &spies[2].drawing}});
    return kOk;
}

}  // namespace

void add_figures(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<FiguresOptions>();
    CLI::App* command =
        app.add_subcommand("figures", "Draw the figures of the paper from a run of a scene");
    command->footer(kFiguresFooter);
    options->scene.add_to(*command, false);
    command->add_option("-o,--output", options->folder, "Folder for the figures")
        ->capture_default_str();
    command->add_option("--at", options->at, "Time of the step that is drawn [s]")
        ->check(not_negative())
        ->capture_default_str();
    command
        ->add_option("--samples", options->samples,
                     "Factorisations timed of each matrix, fewer where one takes long")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->callback([&chosen, options] { chosen = [options] { return figures(*options); }; });
}

}  // namespace hawser::cli
