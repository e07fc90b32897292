// SPDX-License-Identifier: Apache-2.0
#include "commands.h"
#include "report/start/check.h"
#include "scene_options.h"
#include "signal_list.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <memory>
#include <new>

namespace hawser::cli {

namespace {

using Report = nlohmann::ordered_json;

constexpr const char* kCheckFooter = R"(Examples:
  hawser check scenes/*.json
  hawser check scene.json --step 0.1 --json

Reads each scene completely and lists every mistake in it: file, place in the document, what was
expected. Then looks at its start: joints that contradict or repeat each other, shapes inside each
other, gaps, lines beyond their breaking load, masses and inertias that fit no body, motors against
what holds, wires and joints that the step does not resolve. Contradictions and bodies that lie more
than half in each other are errors, all else warnings. Exit codes: 0 all scenes are good, with
warnings or without, 1 at least one is not.)";

struct CheckOptions {
    SceneOptions scene;
    std::vector<std::string> files;
    bool json = false, signals = false;
};

struct Checked {
    std::vector<scene::SceneError> mistakes;
    std::optional<scene::Scene> scene;  ///< None where there are mistakes.
    report::start::Findings start;

    [[nodiscard]] bool good() const { return scene && start.errors() == 0; }
};

Checked examine(const CheckOptions& options, const std::string& file) {
    SceneOptions one = options.scene;
    one.file = file;
    Checked out;
    out.scene = one.load(out.mistakes);
    if (out.scene)
        out.start = report::start::check_start(record::info_of(*out.scene), out.scene->world);
    return out;
}

std::string counted(std::size_t count, const char* what) {
    return count == 0 ? "" : fmt::format(", {} {}{}", count, what, count == 1 ? "" : "s");
}

void print_lines(const std::string& file, const Checked& checked, bool signals) {
    for (const scene::SceneError& mistake : checked.mistakes)
        fmt::print(stderr, "{}\n", mistake.what());
    if (!checked.scene) {
        if (checked.mistakes.size() > 1)
            fmt::print(stderr, "{}: {} mistakes\n", file, checked.mistakes.size());
        return;
    }
    const scene::Scene& scene = *checked.scene;
    fmt::print(stderr, "{}", report::start::to_text(checked.start, file + ": "));
    fmt::print(
        "{}: {}{}{}: {} bodies, {} interactions, {} cables, {} inputs, {} outputs, hash {:016x}\n",
        file, checked.good() ? "ok" : "impossible", counted(checked.start.errors(), "error"),
        counted(checked.start.warnings(), "warning"), scene.world.bodies().size(),
        scene.world.interactions().size(), scene.cables.size(), scene.world.inputs().size(),
        scene.world.output_ids().size(), scene.hash);
    if (signals) fmt::print("{}", signal_lines(scene.world));
}

Report report_of(const std::string& file, const Checked& checked) {
    Report mistakes = Report::array(), findings = Report::array();
    for (const scene::SceneError& m : checked.mistakes)
        mistakes.push_back({{"file", m.file}, {"path", m.path}, {"message", m.message}});
    for (const report::start::Finding& f : checked.start.list)
        findings.push_back({{"severity", f.error ? "error" : "warning"},
                            {"kind", to_string(f.kind)},
                            {"about", f.about},
                            {"value", f.value},
                            {"text", f.text}});
    Report report{{"file", file}, {"good", checked.good()}, {"mistakes", std::move(mistakes)}};
    if (checked.scene) {
        report["errors"] = checked.start.errors();
        report["warnings"] = checked.start.warnings();
        report["findings"] = std::move(findings);
        report.update(signal_report(checked.scene->world));
        report["hash"] = fmt::format("{:016x}", checked.scene->hash);
    }
    return report;
}

int check(const CheckOptions& options) {
    int code = kOk;
    Report reports = Report::array();
    for (const std::string& file : options.files) {
        Checked checked;
        try {
            checked = examine(options, file);
        } catch (const std::bad_alloc&) {
            checked.mistakes.emplace_back(file, "", "out of memory");
        } catch (const std::exception& e) {
            checked.mistakes.emplace_back(file, "", e.what());
        }
        if (!checked.good()) code = kUsageError;
        if (options.json)
            reports.push_back(report_of(file, checked));
        else
            print_lines(file, checked, options.signals);
    }
    if (options.json)
        fmt::print("{}\n", reports.dump(2, ' ', false, Report::error_handler_t::replace));
    return code;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand("check", "Say whether scenes are good");
    command->footer(kCheckFooter);
    command->add_option("SCENE", options->files, "Scene files (JSON)")->required();
    options->scene.add_changes_to(*command);
    command->add_flag("--signals", options->signals, "List inputs and outputs with their units");
    command->add_flag("--json", options->json, "Write what was found as JSON to standard output");
    command->callback([&chosen, options] { chosen = [options] { return check(*options); }; });
}

}  // namespace hawser::cli
