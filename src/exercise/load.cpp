// SPDX-License-Identifier: Apache-2.0
/// Load an exercise and its scene from a file.
#include <hawser/hawser.h>

#include "exercise/format.h"
#include "exercise/reader.h"
#include "scene/schema.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <utility>

namespace hawser::exercise {
namespace {

using scene::Json;
using scene::SourceLocation;

/// Document of the scene with the additions of the exercise.
struct Merged {
    Json root;
    std::string file;
    std::size_t inputs = 0, outputs = 0;  ///< Number of entries of the scene itself.
    bool timeline = false;                ///< True if the timeline is that of the exercise.
};

std::size_t append(Json& root, const char* key, const Json& from) {
    Json& list = root[key];
    if (!list.is_array()) list = Json::array();
    const std::size_t own = list.size();
    for (const Json& one : from) list.push_back(one);
    return own;
}

Merged merge(const Json& exercise, const SourceLocation& location) {
    const std::filesystem::path folder = std::filesystem::path(location.file).parent_path();
    const auto root = folder.empty() ? std::filesystem::path("..") : folder / "..";
    Merged out;
    const std::filesystem::path file = scene::resolve_inside(
        root, folder, exercise["scene"].get<std::string>(), location / "scene");
    out.file = file.string();
    out.root = scene::read_json_file(file, {});
    if (!out.root.is_object()) scene::throw_error({out.file, ""}, "expected a scene, an object");
    const Json none = Json::array();
    out.inputs = append(out.root, "inputs", exercise.value("inputs", none));
    out.outputs = append(out.root, "outputs", exercise.value("outputs", none));
    out.timeline = exercise.contains("timeline");
    if (out.timeline) out.root["timeline"] = exercise["timeline"];
    return out;
}

/// Convert the position of an error: a mistake in an addition of the exercise is reported in the
/// exercise's file.
scene::SceneError in_exercise(const scene::SceneError& error, const Merged& merged,
                              const std::string& file) {
    const auto entry = [&](const std::string& key, std::size_t own) -> std::optional<std::string> {
        const std::string front = "/" + key + "/";
        if (!error.path.starts_with(front)) return std::nullopt;
        const std::size_t digits = error.path.find_first_not_of("0123456789", front.size());
        const std::string number = error.path.substr(front.size(), digits - front.size());
        if (number.empty() || number.size() > 9 || std::stoul(number) < own) return std::nullopt;
        return front + std::to_string(std::stoul(number) - own) +
               (digits == std::string::npos ? "" : error.path.substr(digits));
    };
    for (const auto& [key, own] : {std::pair(std::string("inputs"), merged.inputs),
                                   std::pair(std::string("outputs"), merged.outputs)})
        if (const auto path = entry(key, own)) return {file, *path, error.message};
    if (merged.timeline && error.path.starts_with("/timeline/"))
        return {file, error.path, error.message};
    return error;
}

scene::Scene load_scene(const Merged& merged, const scene::Options& options,
                        const std::string& file) {
    try {
        return scene::load_text(merged.root.dump(), merged.file, options);
    } catch (const scene::SceneError& error) {
        throw in_exercise(error, merged, file);
    }
}

Loaded load(const Json& root, std::string text, const std::string& file, scene::Options options) {
    const SourceLocation location{file, ""};
    if (!root.is_object() || !root.contains("exercise"))
        scene::check_document_kind(root, file, "an exercise");
    scene::check_shape(root, *exercise_shape(), location);
    Loaded out{read_exercise(root, location), scene::Scene()};
    out.exercise.text = std::move(text);
    const auto changes = root.value("set", std::vector<std::string>());
    options.set.insert(options.set.begin(), changes.begin(), changes.end());
    Merged merged = merge(root, location);
    out.scene = load_scene(merged, options, file);
    // Load the scene again if a fault needs an input that the scene lacks.
    if (const Json more = missing_inputs(out.exercise, out.scene.world); !more.empty()) {
        (void)append(merged.root, "inputs", more);
        out.scene = load_scene(merged, options, file);
    }
    check_names(out.exercise, out.scene, location);
    // Settings of a timeline pass through faults, so the run applies them. The session applies the
    // other operations.
    for (const scene::Operation& operation : out.scene.timeline)
        if (operation.kind == scene::OperationKind::set) out.exercise.levers.push_back(operation);
    std::erase_if(out.scene.timeline, [](const scene::Operation& operation) {
        return operation.kind == scene::OperationKind::set;
    });
    return out;
}

}  // namespace

Loaded load_file(const std::filesystem::path& file, const scene::Options& options) {
    const Json root = scene::read_json_file(file, {}, nullptr, "an exercise");
    return load(root, root.dump(), file.string(), options);
}

Loaded load_text(std::string_view text, const std::string& name, const scene::Options& options) {
    return load(scene::parse_json(text, name, {}), std::string(text), name, options);
}

void start_at(Exercise& exercise, double time) {
    for (Fault& fault : exercise.faults)
        if (fault.at && *fault.at < time) fault.at.reset();
    for (Goal& goal : exercise.goals) goal.after.clear();
}

bool is_exercise(const std::filesystem::path& file) noexcept {
    try {
        const Json root = scene::read_json_file(file, {});
        return root.is_object() && root.contains("exercise");
    } catch (const std::exception&) {
        return false;
    }
}

std::string schema_text() {
    return scene::schema_of(*exercise_shape(), "Hawser exercise, version 1",
                            "src/exercise/format.cpp");
}

}  // namespace hawser::exercise
