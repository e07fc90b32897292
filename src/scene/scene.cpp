// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.h"

#include "scene/description.h"

#include <algorithm>
#include <utility>

namespace hawser::scene {
namespace {

constexpr int kMaxThreads = 256;

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t hash_text(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hash;
}

/// Hand the flat lists to a new world. What it refuses is reported at its place in the file.
World build(const Description& description, const Options& options, const Place& settings_place) {
    WorldDef settings = description.settings;
    settings.threads = options.threads;
    settings.budget = options.budget;
    settings.budget_work = options.budget_work;
    const bool grouped = std::any_of(description.bodies.begin(), description.bodies.end(),
                                     [](const BodyDef& body) { return !body.group.empty(); });
    if (settings.coupling != Coupling::exact) {
        settings.parts = description.parts.value_or(grouped ? 0 : Description::kParts);
    }
    const Place* at = &settings_place;
    try {
        World world(settings);
        for (std::size_t i = 0; i < description.bodies.size(); ++i) {
            at = &description.body_place(i);
            world.add_body(description.bodies[i]);
        }
        for (std::size_t i = 0; i < description.interactions.size(); ++i) {
            at = &description.interaction_place(i);
            world.add_interaction(description.interactions[i]);
        }
        for (const MaterialDef& material : description.materials) {
            world.add_material(material);
        }
        for (const MaterialPairDef& pair : description.material_pairs) {
            world.add_material_pair(pair);
        }
        for (std::size_t i = 0; i < description.shapes.size(); ++i) {
            at = &description.shape_place(i);
            world.add_shape(description.shapes[i]);
        }
        for (std::size_t i = 0; i < description.inputs.size(); ++i) {
            at = &description.input_place(i);
            world.add_input(description.inputs[i]);
        }
        return world;
    } catch (const DefError& error) {
        refuse(*at, error.what());
    }
}

void read_plot(Scene& scene, const Description& description, const Document& document) {
    const auto plot = document.root.find("plot");
    if (plot == document.root.end()) {
        return;
    }
    const Place place = document.place / "plot";
    const auto read = [&](const char* key, std::vector<std::string>& names, const auto& exists,
                          const char* what, const auto& known) {
        const auto list = plot->find(key);
        for (std::size_t i = 0; list != plot->end() && i < list->size(); ++i) {
            names.push_back((*list)[i].template get<std::string>());
            if (!exists(names.back())) {
                refuse(place / key / i, std::string("there is no ") + what + " " +
                                            in_quotes(names.back()) +
                                            suggestion(names.back(), known()));
            }
        }
    };
    read(
        "tensions", scene.plot_tensions,
        [&](const std::string& name) { return description.has_cable(name); }, "cable",
        [&] {
            std::vector<std::string> known;
            for (const Cable& cable : description.cables) {
                known.push_back(cable.name);
            }
            return known;
        });
    read(
        "motions", scene.plot_motions,
        [&](const std::string& name) { return description.find_body(name).valid(); }, "body",
        [&] {
            std::vector<std::string> known;
            for (const BodyDef& body : description.bodies) {
                known.push_back(body.name);
            }
            return known;
        });
    if (const auto box = plot->find("view_box"); box != plot->end()) {
        for (std::size_t i = 0; i < 6; i += 3) {
            scene.plot_view_box.emplace_back((*box)[i].get<double>(), (*box)[i + 1].get<double>(),
                                             (*box)[i + 2].get<double>());
        }
        if (!(scene.plot_view_box[0].array() < scene.plot_view_box[1].array()).all()) {
            refuse(place / "view_box", "the lower corner must lie below the upper one");
        }
    }
}

void check_options(const Options& options, const Place& place) {
    if (options.scale < 1 || options.scale > kMaxCopies) {
        refuse(place, "the scale must be between 1 and " + std::to_string(kMaxCopies) + ", found " +
                          std::to_string(options.scale));
    }
    if (options.threads < 1 || options.threads > kMaxThreads) {
        refuse(place, "the number of threads must be between 1 and " + std::to_string(kMaxThreads));
    }
}

Scene make_scene(Json root, const std::filesystem::path& file, const Options& options) {
    const Place place{file.string(), ""};
    check_options(options, place);
    const Document document = make_document(std::move(root), file, options);
    Description description;
    expand(description, document);
    const bool moves =
        std::any_of(description.bodies.begin(), description.bodies.end(), [](const BodyDef& body) {
            return body.kind != BodyKind::fixed && body.kind != BodyKind::kinematic;
        });
    if (!moves) {
        refuse(place, "the scene has no body that moves");
    }
    std::string text = document.root.dump(1) + "\n";
    const std::uint64_t hash = hash_text(text);
    Scene scene{.name = document.root["name"].get<std::string>(),
                .description = text_or(document.root, "description", ""),
                .path = file.string(),
                .files = document.files,
                .state_file = document.state_file,
                .text = std::move(text),
                .hash = hash,
                .duration = description.duration,
                .world = build(description, options, document.place / "settings"),
                .cables = {},
                .plot_tensions = {},
                .plot_motions = {},
                .plot_view_box = {}};
    read_plot(scene, description, document);
    scene.cables = std::move(description.cables);
    return scene;
}

}  // namespace

Scene load_file(const std::filesystem::path& file, const Options& options) {
    Scene scene = make_scene(read_json_file(file), file, options);
    scene.files.push_back(file);
    return scene;
}

Scene load_text(std::string_view text, const std::string& name_for_messages,
                const Options& options) {
    return make_scene(parse_json(text, name_for_messages), name_for_messages, options);
}

}  // namespace hawser::scene
