// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "draw/figures/index.h"
#include "draw/figures/panel.h"
#include "draw/png.h"
#include "figure_panels.h"
#include "figure_timelines.h"
#include "outputs.h"
#include "record/host.h"
#include "scene_options.h"

#include <fmt/format.h>
#include <hawser/experimental/splits.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace hawser::cli {

namespace {

constexpr const char* kFiguresFooter = R"(Examples:
  hawser figures -o out                              # of bench/scenes/frozen/anchor_lines.json
  hawser figures bench/scenes/frozen/anchor_contact.json -o out --at 2

Writes each panel of the two figures of the paper as .svg and .png with its data as .json, and each
figure on one page.

Exit codes: 0 written, 1 wrong option, scene or file, 2 a step failed.)";

constexpr const char* kDefaultScene = "bench/scenes/frozen/anchor_lines.json";

struct FiguresOptions {
    SceneOptions scene;
    std::string folder = ".";
    double at = 1.0;
    int samples = 21;
    int simulated = 4;
    double max_gflop = 20.0;
};

/// Return the path of the default scene. Search the current folder, all folders above the program
/// (if built) and their share/hawser (if installed).
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

/// Return the data that all panels store as their origin: scene, state, command and machine.
nlohmann::ordered_json panel_origin(const scene::Scene& scene, const FiguresOptions& options) {
    return {{"scene", scene.name},
            {"scene_file", scene.path},
            {"scene_hash", fmt::format("{:016x}", scene.hash)},
            {"time", scene.world.time()},
            {"state_hash", fmt::format("{:016x}", scene.world.state().hash())},
            {"command", command_line()},
            {"instruction_set", instruction_set()},
            {"processor", record::processor_model()},
            {"processors", record::processor_count()},
            {"threads", options.scene.threads},
            {"version", version()}};
}

/// Step until `at`. @return the status of the last step.
Status run_to(World& world, double at) {
    Status status = Status::ok;
    // Stop half a step early, because time is a sum of steps.
    do status = world.step();
    while (status == Status::ok && world.time() < at - 0.5 * world.settings().step);
    return status;
}

class Writer {
  public:
    Writer(const FiguresOptions& options, const scene::Scene& scene)
        : folder_(options.folder), origin_(panel_origin(scene, options)) {
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
        write_output(file.string(), data.dump() + '\n', "the data of a figure");
        fmt::print("wrote {}\n", file.string());
    }

    void page(const std::string& name, const std::string& title,
              const std::vector<std::vector<const draw::Drawing*>>& rows) {
        pictures(draw::make_page(title, parameters_, rows), name);
    }

  private:
    void pictures(const draw::Drawing& drawing, const std::string& name) {
        for (const auto& file : draw::write_pictures(drawing, folder_ / name))
            fmt::print("wrote {}\n", file.string());
    }

    std::filesystem::path folder_;
    nlohmann::ordered_json origin_;
    std::string parameters_;
};

/// Partitions of a state: for approximate couplings and for the exact solution.
struct Parts {
    PartitionView cuts, separators;
};

Parts partition(const World& world, int parts) {
    return {world.splits().partition({.use = PartitionUse::cuts, .parts = parts}),
            world.splits().partition({.use = PartitionUse::separators, .parts = parts})};
}

void mark_parts(draw::InteractionGraph& graph, const Parts& parts) {
    for (draw::GraphNode& n : graph.nodes) {
        n.part = std::max(-1, parts.cuts.part_of_body[draw::at(n.body.index)]);
        n.separator = std::binary_search(parts.separators.separator.begin(),
                                         parts.separators.separator.end(), n.body);
    }
    for (draw::GraphEdge& e : graph.edges)
        e.cut =
            std::any_of(parts.cuts.cuts.begin(), parts.cuts.cuts.end(),
                        [&](const CutInteraction& c) { return c.interaction == e.interaction; });
}

nlohmann::ordered_json partition_data(const Parts& parts) {
    nlohmann::ordered_json cuts = nlohmann::ordered_json::array();
    for (const CutInteraction& c : parts.cuts.cuts)
        cuts.push_back({{"interaction", c.interaction.index},
                        {"force", c.force},
                        {"net_force", c.net_force},
                        {"relative_velocity", c.relative_velocity},
                        {"violation", c.violation},
                        {"weight", c.weight}});
    return {{"parts", parts.cuts.parts},
            {"part_cost", parts.cuts.part_cost},
            {"imbalance", parts.cuts.imbalance},
            {"island_cost", parts.cuts.island_cost},
            {"cuts", std::move(cuts)},
            {"separator_scalars", parts.separators.separator_scalars},
            {"separator_part_cost", parts.separators.part_cost}};
}

void figure1(Writer& writer, const World& world, const Parts& parts, const OrderedMatrix& whole,
             const OrderedMatrix& split) {
    draw::InteractionGraph graph = draw::interaction_graph(world);
    std::vector<Panel> panels;
    panels.push_back(matrix_panel("fig1_matrix", "System matrix", whole));
    panels.push_back(matrix_panel("fig1_split_matrix",
                                  fmt::format("Split matrix, {} parts", parts.cuts.parts), split));
    panels.push_back(graph_panel(
        "fig1_graph", "Interaction graph",
        {fmt::format("{} bodies, {} interactions", graph.nodes.size(), graph.edges.size())}, graph,
        false));
    mark_parts(graph, parts);
    panels.push_back(graph_panel(
        "fig1_cut_graph", "Cut graph",
        {fmt::format("{} parts, {} interactions cut, largest part {:.2f} x the mean",
                     parts.cuts.parts, parts.cuts.cuts.size(), parts.cuts.imbalance),
         fmt::format("the exact solution needs no cuts: {} bodies ({} scalars) as separators",
                     parts.separators.separator.size(), parts.separators.separator_scalars)},
        graph, true));
    panels.back().data.update(partition_data(parts));
    for (Panel& p : panels) writer.panel("1", p);
    writer.page(
        "fig1", "Fig. 1: system matrix, split matrix, interaction graph, cut graph",
        {{&panels[0].drawing, &panels[1].drawing}, {&panels[2].drawing, &panels[3].drawing}});
}

void figure2(Writer& writer, const std::vector<OrderedMatrix>& full,
             const std::vector<OrderedMatrix>& split,
             const std::vector<draw::NamedTimeline>& timelines) {
    static constexpr const char* kOrderNames[] = {"natural order", "AMD",
                                                  "METIS nested dissection"};
    static constexpr const char* kOrderFileNames[] = {"natural", "amd", "metis"};
    std::vector<Panel> panels;
    for (std::size_t k = 0; k < full.size(); ++k)
        panels.push_back(fill_panel(fmt::format("fig2_full_{}", kOrderFileNames[k]),
                                    fmt::format("Full: {}", kOrderNames[k]), full[k]));
    for (std::size_t k = 0; k < split.size(); ++k)
        panels.push_back(fill_panel(fmt::format("fig2_split_{}", kOrderFileNames[k]),
                                    fmt::format("Split: {}", kOrderNames[k]), split[k]));
    panels.push_back(timeline_panel("fig2_timelines", "Thread timelines", timelines));
    for (Panel& p : panels) writer.panel("2", p);
    writer.page("fig2", "Fig. 2: fill of the factor, full and split, and timelines of threads",
                {{&panels[0].drawing, &panels[1].drawing, &panels[2].drawing},
                 {&panels[3].drawing, &panels[4].drawing, &panels[5].drawing},
                 {&panels[6].drawing}});
}

int figures(FiguresOptions options) {
    if (options.scene.file.empty()) options.scene.file = default_scene();
    SceneOptions saddle = options.scene;
    if (!saddle.form) saddle.form = "saddle";
    scene::Scene scene = saddle.load();
    if (const Status status = run_to(scene.world, options.at); status != Status::ok) {
        fmt::print(stderr, "hawser: the step at {:.4g} s failed: {}\n", scene.world.time(),
                   to_string(status));
        return kFailed;
    }
    Writer writer(options, scene);
    const Parts parts = partition(scene.world, options.scene.parts.value_or(kDefaultParts));
    draw::BlockGraph whole =
        draw::block_graph_of_world(scene.world.solver().matrix(), parts.cuts.part_of_body);
    const draw::BlockGraph pieces = draw::split_graph(whole, parts.cuts.parts);
    whole.part.assign(whole.part.size(), -1);  // pictures of the whole show no parts
    std::vector<OrderedMatrix> full, split;
    std::vector<OrderedMatrix*> all;
    for (const Ordering o : {Ordering::natural, Ordering::amd, Ordering::metis}) {
        full.push_back(order_matrix(whole, 0, o));
        split.push_back(order_matrix(pieces, parts.cuts.parts, o));
    }
    for (auto* list : {&full, &split})
        for (OrderedMatrix& m : *list) all.push_back(&m);
    for (const OrderedMatrix* m : all) {
        const double gflop = 1e-9 * static_cast<double>(m->counts.flops);
        if (gflop > 1.0 && gflop <= options.max_gflop)
            fmt::print(stderr, "factoring a matrix in an order that takes {:.3g} Gflop …\n", gflop);
    }
    time_matrices(all, options.samples, 1e9 * options.max_gflop);
    figure1(writer, scene.world, parts, full[0], split[0]);
    figure2(writer, full, split,
            run_timelines(options.scene, {.at = options.at,
                                          .threads = options.scene.threads,
                                          .simulated = options.simulated,
                                          .parts = options.scene.parts.value_or(kDefaultParts)}));
    return kOk;
}

}  // namespace

void add_figures(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<FiguresOptions>();
    CLI::App* command =
        app.add_subcommand("figures", "Draw the figures of the paper from a run of a scene");
    command->footer(kFiguresFooter);
    options->scene.threads = std::clamp(record::processor_count(), 1, 4);
    options->scene.add_to(*command, false);
    command->add_option("-o,--output", options->folder, "Folder for the figures")
        ->capture_default_str();
    command->add_option("--at", options->at, "Time of the drawn step [s]")
        ->check(not_negative())
        ->capture_default_str();
    command
        ->add_option("--simulated", options->simulated,
                     "Number of simulated threads in the timelines")
        ->check(CLI::Range(1, kMostThreads))
        ->capture_default_str();
    command
        ->add_option("--most-gflop", options->max_gflop,
                     "Work [Gflop] above which an elimination order is drawn but not timed")
        ->check(not_negative())
        ->capture_default_str();
    command
        ->add_option("--samples", options->samples,
                     "Largest number of timed factorisations of each matrix")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->callback([&chosen, options] { chosen = [options] { return figures(*options); }; });
}

}  // namespace hawser::cli
