// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "dp_capability_table.h"
#include "draw/png.h"
#include "draw/spy.h"
#include "hydrostatics.h"
#include "inspect_parts.h"
#include "scene_options.h"
#include "signal_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

namespace hawser::cli {

namespace {

constexpr const char* kInspectFooter = R"(Examples:
  hawser inspect scenes/anchor_lines.json
  hawser inspect scenes/anchor_lines.json --form saddle -o pictures   # spy.svg and spy.png
  hawser inspect bench/scenes/frozen/anchor_contact.json --parts 4 --steps 60      # where it would be cut
  hawser inspect scenes/floating_box.json --hydrostatics              # of its hulls
  hawser inspect scenes/dp_ship.json --dp-capability -o dp.svg        # DNV-ST-0111 Level 1

Exit codes: 0 done, 1 wrong option, scene or file, 2 a step failed.)";

struct InspectOptions {
    SceneOptions scene;
    std::string folder;
    int steps = 1;
    bool hydrostatics = false, capability = false;
    DpOptions dp;
};

void print_islands(const SystemView& view) {
    std::map<std::int32_t, std::int64_t> size;
    for (const std::int32_t island : view.body_island)
        if (island >= 0) ++size[island];
    std::vector<std::int64_t> sizes;
    for (const auto& [island, bodies] : size) sizes.push_back(bodies);
    std::sort(sizes.rbegin(), sizes.rend());
    fmt::print("  islands          {}", sizes.size());
    if (!sizes.empty()) {
        sizes.resize(std::min<std::size_t>(sizes.size(), 8));
        fmt::print(", bodies in the largest: {}", fmt::join(sizes, ", "));
    }
    fmt::print("\n");
}

void print_fronts(const SystemView& view) {
    const std::size_t n = view.front_parent.size();
    std::vector<int> depth(n, 1);
    int deepest = 0;
    std::int64_t roots = 0, pivots = 0;
    std::int32_t widest = 0, tallest = 0;
    // Parents come after their children, so a walk from the end finds them first.
    for (std::size_t i = n; i-- > 0;) {
        const std::int32_t parent = view.front_parent[i];
        if (parent < 0)
            ++roots;
        else
            depth[i] = depth[static_cast<std::size_t>(parent)] + 1;
        deepest = std::max(deepest, depth[i]);
        pivots += view.front_pivots[i];
        widest = std::max(widest, view.front_pivots[i]);
        tallest = std::max(tallest, view.front_pivots[i] + view.front_update[i]);
    }
    if (n == 0) return;
    fmt::print(
        "  fronts           {}, {} trees, {} levels; {:.1f} pivots on average, at most {}; "
        "largest front {}\n",
        n, roots, deepest, static_cast<double>(pivots) / static_cast<double>(n), widest, tallest);
}

void print_system(const World& world, const SystemView& view) {
    const StepStats& stats = world.stats();
    std::int64_t bodies = 0, kept = 0, scalars = 0;
    for (const SystemNode& node : view.nodes) {
        (node.body.valid() ? bodies : kept) += 1;
        scalars += node.size;
    }
    fmt::print("  system           {} bodies that move, {} interactions, {} equations\n",
               stats.bodies, stats.interactions, stats.equations);
    print_islands(view);
    fmt::print("  factored matrix  {} scalars: {} bodies, {} kept interactions ({} condensed)\n",
               scalars, bodies, kept, stats.interactions - kept);
    fmt::print("  nonzeros         matrix {} (lower triangle), factor {}: fill {:.3g}x\n",
               view.matrix_nnz, view.factor_nnz,
               view.matrix_nnz > 0
                   ? static_cast<double>(view.factor_nnz) / static_cast<double>(view.matrix_nnz)
                   : 0.0);
    print_fronts(view);
    fmt::print(
        "  factorisation    {:.4g} Mflop, {:.4g} Mflop on the critical path: at most "
        "{:.3g}x by parallel subtrees\n",
        1e-6 * static_cast<double>(view.flops), 1e-6 * static_cast<double>(view.critical_flops),
        view.critical_flops > 0
            ? static_cast<double>(view.flops) / static_cast<double>(view.critical_flops)
            : 1.0);
    fmt::print("  memory           {:.3g} MB in state and solver\n",
               1e-6 * static_cast<double>(world.solver().memory_bytes()));
}

int inspect(const InspectOptions& options) {
    if (options.capability)
        return print_dp_capability(options.scene, options.dp, options.folder) ? kOk : kUsageError;
    scene::Scene scene = options.scene.load();
    World& world = scene.world;
    if (options.hydrostatics) return print_hydrostatics(world) ? kOk : kUsageError;
    for (int k = 0; k < options.steps; ++k)
        if (const Status status = world.step(); status != Status::ok) {
            fmt::print(stderr, "hawser: step {} failed: {}\n", k + 1, to_string(status));
            return kFailed;
        }
    const SystemView view = world.solver().matrix();
    fmt::print("{} (hash {:016x})\n", scene.name, scene.hash);
    fmt::print("{}", signal_lines(world));
    print_system(world, view);
    print_orders(view);
    print_groups(world);
    print_parts(world, options.scene.parts.value_or(kDefaultParts));
    if (options.folder.empty()) return kOk;
    const std::string parameters = fmt::format(
        "{} nodes, {} scalars of the lower triangle, {} of the factor, {:.4g} Mflop  ·  scene hash "
        "{:016x}  ·  {}  ·  Hawser {}",
        view.nodes.size(), view.matrix_nnz, view.factor_nnz, 1e-6 * static_cast<double>(view.flops),
        scene.hash, instruction_set(), version());
    const draw::Drawing drawing =
        draw::plot_spy(view, draw::factor_blocks(view),
                       scene.name + ": nonzero entries of matrix and factor", parameters);
    for (const auto& file :
         draw::write_pictures(drawing, std::filesystem::path(options.folder) / "spy"))
        fmt::print("wrote {}\n", file.string());
    return kOk;
}

}  // namespace

void add_inspect(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command = app.add_subcommand("inspect", "Show the system of equations of a scene");
    command->footer(kInspectFooter);
    options->scene.add_to(*command);
    command->add_option("-o,--output", options->folder,
                        "Folder for spy plots; SVG file of the polar plot");
    command->add_option("--steps", options->steps, "Number of steps before the output")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_flag("--hydrostatics", options->hydrostatics,
                      "Print displacement, KB, BM, GM and the GZ curve of the hulls instead");
    command->add_flag("--dp-capability", options->capability,
                      "Print the DP capability of the vessels (DNV-ST-0111 Level 1) instead; SCENE "
                      "may be the data file of one ship");
    command
        ->add_option("--heading-step", options->dp.step_deg,
                     "Step of the headings of --dp-capability, a divisor of 30 [deg]")
        ->check(CLI::Range(0.1, 30.0))
        ->capture_default_str();
    command->add_flag("--numbers", options->dp.numbers,
                      "With --dp-capability: the utilisation at each Beaufort number");
    command->callback([&chosen, options] { chosen = [options] { return inspect(*options); }; });
}

}  // namespace hawser::cli
