// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "scene_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <new>

namespace hawser::cli {

namespace {

constexpr const char* kCheckFooter = R"(Examples:
  hawser check scenes/*.json

Reads each scene completely, builds its world and says what is wrong with it: file, place in the
document, what was expected. Exit codes: 0 all scenes are good, 1 at least one is not.)";

int check(const std::vector<std::string>& files) {
    int code = kOk;
    for (const std::string& file : files) {
        try {
            SceneOptions options;
            options.file = file;
            const scene::Scene scene = options.load();
            fmt::print("{}: ok: {} bodies, {} interactions, {} cables, {} inputs, hash {:016x}\n",
                       file, scene.world.body_count(), scene.world.interaction_count(),
                       scene.cables.size(), scene.world.input_count(), scene.hash);
        } catch (const std::bad_alloc&) {
            fmt::print(stderr, "{}: out of memory\n", file);
            code = kUsageError;
        } catch (const std::exception& e) {
            fmt::print(stderr, "{}\n", e.what());
            code = kUsageError;
        }
    }
    return code;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
    auto files = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand("check", "Say whether scenes are good");
    command->footer(kCheckFooter);
    command->add_option("SCENE", *files, "Scene files (JSON)")->required();
    command->callback([&chosen, files] { chosen = [files] { return check(*files); }; });
}

}  // namespace hawser::cli
