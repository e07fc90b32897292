// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>

#include "commands.h"
#include "report/start/cable_starts.h"
#include "report/start/check.h"
#include "report/start/parts.h"
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

Reports all mistakes of a scene with file, position in the document and expected value. Then checks
the start:
- inconsistent or redundant joints, overlapping shapes, gaps
- lines above their breaking load, implausible masses and inertias
- motors against fixed coordinates
- wires and joints that the step does not resolve
- inconsistent numbers of the sea
Inconsistent joints, and bodies that overlap by more than half, are errors; other findings are
warnings. For a single scene, or with --cables, prints the start tension of each cable. Checks an
exercise together with its scene.

Exit codes: 0 no error (warnings permitted), 1 at least one error.)";

/// Largest number of cables of a scene that are listed line by line.
constexpr std::size_t kMaxCables = 40;

struct CheckOptions {
    SceneOptions scene;
    std::vector<std::string> files;
    bool json = false, signals = false, cables = false;

    /// True if cables and operations are listed. With many scenes such a list would hide the
    /// mistakes.
    [[nodiscard]] bool lists_details() const { return files.size() == 1; }
    [[nodiscard]] bool prints_cables() const { return json || cables || lists_details(); }
};

struct Checked {
    std::vector<scene::SceneError> mistakes;
    std::optional<scene::Scene> scene;  ///< Empty if there are mistakes.
    report::start::Findings start;
    std::vector<report::start::CableStart> cables;

    [[nodiscard]] bool is_good() const { return scene && start.errors() == 0; }
};

/// Read an exercise, check its scene, and find points that no run can award.
void read_exercise(const SceneOptions& options, Checked& out) {
    try {
        exercise::Loaded loaded = exercise::load_file(options.file, options.options());
        report::start::check_points(loaded.exercise, out.start);
        report::start::check_task(loaded.exercise, out.start);
        report::start::check_controls(loaded.exercise, loaded.scene, out.start);
        out.scene = std::move(loaded.scene);
    } catch (const scene::SceneError& error) {
        out.mistakes.push_back(error);
    }
}

Checked check_file(const CheckOptions& options, const std::string& file) {
    SceneOptions one = options.scene;
    one.file = file;
    Checked out;
    if (exercise::is_exercise(file))
        read_exercise(one, out);
    else
        out.scene = one.load(out.mistakes);
    if (!out.scene) return out;
    const record::SceneInfo info = record::make_scene_info(*out.scene);
    report::start::Findings found = report::start::check_start(info, out.scene->world);
    for (report::start::Finding& f : found.list) out.start.list.push_back(std::move(f));
    out.start.sort();
    if (options.prints_cables()) out.cables = report::start::cable_starts(info, out.scene->world);
    return out;
}

std::string with_count(std::size_t count, const char* what) {
    return count == 0 ? "" : fmt::format(", {} {}{}", count, what, count == 1 ? "" : "s");
}

void print_lines(const std::string& file, const Checked& checked, const CheckOptions& options) {
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
        file, checked.is_good() ? "ok" : "impossible", with_count(checked.start.errors(), "error"),
        with_count(checked.start.warnings(), "warning"), scene.world.bodies().size(),
        scene.world.interactions().size(), scene.cables.size(), scene.world.inputs().size(),
        scene.world.output_ids().size(), scene.hash);
    fmt::print("{}", report::start::to_text(checked.cables, kMaxCables));
    if (options.lists_details())
        for (const scene::Operation& operation : scene.timeline)
            fmt::print("  at {:.6g} s: {}\n", operation.at, to_string(operation));
    if (options.signals) fmt::print("{}", signal_lines(scene.world));
}

Report cable_report(const std::vector<report::start::CableStart>& cables) {
    Report out = Report::array();
    for (const auto& c : cables) {
        Report one{{"name", c.name}};
        if (c.known) {
            one["tension_first"] = c.first;
            one["tension_last"] = c.last;
            one["tension_largest"] = c.largest;
            one["largest_in"] = c.where;
        }
        if (c.laid_from == c.laid_from) one["laid"] = {c.laid_from, c.laid_to};
        out.push_back(std::move(one));
    }
    return out;
}

Report make_report(const std::string& file, const Checked& checked) {
    Report mistakes = Report::array(), findings = Report::array();
    for (const scene::SceneError& m : checked.mistakes)
        mistakes.push_back({{"file", m.file}, {"path", m.path}, {"message", m.message}});
    for (const report::start::Finding& f : checked.start.list)
        findings.push_back({{"severity", f.error ? "error" : "warning"},
                            {"kind", to_string(f.kind)},
                            {"about", f.about},
                            {"value", f.value},
                            {"text", f.text}});
    Report report{{"file", file}, {"good", checked.is_good()}, {"mistakes", std::move(mistakes)}};
    if (checked.scene) {
        report["errors"] = checked.start.errors();
        report["warnings"] = checked.start.warnings();
        report["findings"] = std::move(findings);
        report["cables"] = cable_report(checked.cables);
        Report timeline = Report::array();
        for (const scene::Operation& operation : checked.scene->timeline)
            timeline.push_back({{"at", operation.at}, {"text", to_string(operation)}});
        if (!timeline.empty()) report["timeline"] = std::move(timeline);
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
            checked = check_file(options, file);
        } catch (const std::bad_alloc&) {
            checked.mistakes.emplace_back(file, "", "out of memory");
        } catch (const std::exception& e) {
            checked.mistakes.emplace_back(file, "", e.what());
        }
        if (!checked.is_good()) code = kUsageError;
        if (options.json)
            reports.push_back(make_report(file, checked));
        else
            print_lines(file, checked, options);
    }
    if (options.json)
        fmt::print("{}\n", reports.dump(2, ' ', false, Report::error_handler_t::replace));
    return code;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command = app.add_subcommand("check", "Check scenes for mistakes");
    command->footer(kCheckFooter);
    command->add_option("SCENE", options->files, "Scene files (JSON)")->required();
    options->scene.add_changes_to(*command);
    command->add_flag("--signals", options->signals, "List inputs and outputs with their units");
    command->add_flag("--cables", options->cables,
                      "Print the tension at the start of each cable, also for several scenes");
    command->add_flag("--json", options->json, "Write the findings as JSON to standard output");
    command->callback([&chosen, options] { chosen = [options] { return check(*options); }; });
}

}  // namespace hawser::cli
