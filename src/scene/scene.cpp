// SPDX-License-Identifier: Apache-2.0

#include <hawser/scene.h>

#include "base/number.h"
#include "scene/anchors.h"
#include "scene/deck.h"
#include "scene/description.h"
#include "scene/format.h"
#include "scene/plot.h"
#include "scene/sections.h"
#include "scene/timeline.h"
#include "scene/vessels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

constexpr int kMaxThreads = 256;

/// Compute FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t hash_text(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    return hash;
}

/// Adds the flat lists to a new world. Errors of the world are reported at their place in the file.
class Builder {
  public:
    explicit Builder(const Description& description) : description_(description) {}

    World build(const Options& options, const SourceLocation& settings_location) {
        std::optional<World> world;
        (void)add_or_report(settings_location, [&] { world.emplace(settings_with(options)); });
        if (!world) {
            return World();
        }
        add_bodies(*world);
        add_interactions(*world);
        add_surfaces(*world);
        add_winches(*world);
        add_guides(*world);
        add_end_stops(*world);
        add_posts(*world);
        if (numbered_ && whole_) add_deck(*world, description_);
        add_resolutions(*world);
        add_cranes(*world);
        if (numbered_) {
            (void)add_or_report(description_.sea_location, [&] { add_sea(*world, description_); });
        }
        if (numbered_ && whole_) add_vessels(*world, description_);
        if (numbered_ && whole_) add_anchors(*world, description_);
        for (std::size_t i = 0; i < description_.inputs.size() && numbered_; ++i) {
            (void)add_or_report(description_.input_location(i),
                                [&] { world->add_input(description_.inputs[i]); });
        }
        if (numbered_ && whole_) add_sections(*world, description_);
        check_signal_inputs(*world);
        for (std::size_t i = 0; i < description_.outputs.size() && numbered_; ++i) {
            (void)add_or_report(description_.output_location(i),
                                [&] { world->add_output(output_of(description_, i, *world)); });
        }
        return std::move(*world);
    }

  private:
    /// Run `work`, which adds an object to the world. Convert an error of the world to a mistake at
    /// this position of the document. @return the result of attempt().
    template <class Work>
    bool add_or_report(const SourceLocation& location, const Work& work) {
        return attempt(description_.mistakes, [&] {
            try {
                work();
            } catch (const DefError& error) {
                throw_error(location, error.what());
            }
        });
    }

    [[nodiscard]] WorldDef settings_with(const Options& options) const {
        WorldDef settings = description_.settings;
        settings.threads = options.threads;
        settings.budget = options.budget;
        settings.budget_work = options.budget_work;
        const auto& bodies = description_.bodies;
        const bool grouped = std::any_of(bodies.begin(), bodies.end(),
                                         [](const BodyDef& body) { return !body.group.empty(); });
        if (settings.coupling != Coupling::exact) {
            settings.parts = description_.parts.value_or(grouped ? 0 : Description::kParts);
        }
        return settings;
    }

    void add_bodies(World& world) {
        for (std::size_t i = 0; i < description_.bodies.size(); ++i) {
            const BodyDef& def = description_.bodies[i];
            const bool added =
                add_or_report(description_.body_location(i), [&] { world.add_body(def); });
            if (!added) {  // add a substitute, so that numbers do not change
                world.add_body({.name = "", .kind = BodyKind::fixed});
                whole_ = false;
            }
        }
    }

    void add_interactions(World& world) {
        for (std::size_t i = 0; i < description_.interactions.size() && whole_; ++i) {
            const InteractionDef& def = description_.interactions[i];
            if (!numbered_ && def.load[0].interaction.valid()) {
                continue;
            }
            numbered_ &= add_or_report(description_.interaction_location(i),
                                       [&] { world.add_interaction(def); });
        }
        numbered_ &= whole_;
    }

    /// Add the winches, and the wires of the cables, which they wind up.
    void add_winches(World& world) {
        if (!numbered_) {
            return;
        }
        for (const Cable& cable : description_.cables) {
            if (!cable.links) {
                world.wires().adopt(cable.name, cable.stretch, cable.trim);
            }
            if (std::isnan(cable.drum_element)) continue;
            const auto drum = static_cast<std::size_t>(cable.stretch.front().index);
            (void)add_or_report(description_.interaction_location(drum) / "winch", [&] {
                world.add(DrumFeedDef{.name = cable.name + "/feed",
                                      .wire = world.wires().find(cable.name),
                                      .element = cable.drum_element,
                                      .mass_per_length = cable.sections.front().mass_per_length});
            });
        }
        for (std::size_t i = 0; i < description_.winches.size(); ++i) {
            const Winch& winch = description_.winches[i];
            (void)add_or_report(description_.winch_location(i), [&] {
                WinchDef def = winch.def;
                def.wire = world.wires().find(winch.cable);
                world.add(def);
            });
        }
    }

    /// Add the stops that keep the ends of routes at their turning points.
    void add_end_stops(World& world) {
        if (!numbered_) return;
        std::vector<InteractionId> ends;
        for (std::size_t i = 0; i < description_.interactions.size(); ++i)
            if (description_.interactions[i].kind == InteractionKind::EndSpan)
                ends.push_back(InteractionId{static_cast<std::int32_t>(i)});
        std::erase_if(ends, [&](InteractionId id) { return world.wires().of(id).valid(); });
        if (!ends.empty()) stop_ends(world, "route_ends", std::move(ends));
    }

    void add_guides(World& world) {
        for (std::size_t i = 0; i < description_.guides.size() && numbered_; ++i) {
            const GuideItem& guide = description_.guides[i];
            (void)add_or_report(description_.guide_location(i), [&] {
                GuideDef def = guide.def;
                def.wire = world.wires().find(guide.cable);
                world.add(def);
            });
        }
    }

    /// Add the posts. Their shapes have been added before.
    void add_posts(World& world) {
        for (std::size_t i = 0; i < description_.posts.size() && numbered_ && whole_; ++i) {
            (void)add_or_report(description_.post_location(i), [&] {
                PostDef def = description_.posts[i].def;
                def.shape = world.find_shape(def.name);
                if (def.shape.valid()) world.add(def);  // else the shape was rejected
            });
        }
    }

    /// Check that the signal accepts all values within the declared range of an input.
    /// @throws SceneError.
    static void check_signal_input_range(const SignalInput& input, const SystemSignal& signal,
                                         const SourceLocation& location) {
        constexpr double kNoLimit = 1e29;  // SignalInput::max is 1e30 without a declared range.
        constexpr double kFactorRounding = 1e-9;  // relative rounding of the products with `factor`
        for (const auto& [key, value] :
             {std::pair("min", input.min), std::pair("max", input.max)}) {
            const double set = input.factor * value, slack = kFactorRounding * std::abs(set);
            if (std::abs(value) > kNoLimit ||
                (set >= signal.min - slack && set <= signal.max + slack))
                continue;
            std::string why = "the signal " + in_quotes(input.signal) + " accepts ";
            why += number(signal.min) + " to " + number(signal.max);
            if (signal.unit != "1") why += " " + signal.unit;
            why += ", and this limit sets it to " + number(set);
            throw_error(location / key, why);
        }
    }

    /// Check that each lever has an input of a system. @throws SceneError.
    void check_signal_inputs(const World& world) {
        for (std::size_t i = 0; i < description_.levers.size() && numbered_; ++i) {
            const std::string& signal_name = description_.levers[i].input.signal;
            if (description_.sea && world.find_system("sea") == nullptr &&
                signal_name.starts_with("sea."))
                continue;  // The sea was refused.
            const std::span<const SystemSignal> signals = world.system_signals();
            const auto found = std::find_if(signals.begin(), signals.end(), [&](const auto& s) {
                return s.input && s.system + "." + s.name == signal_name;
            });
            if (found != signals.end()) {
                (void)attempt(description_.mistakes, [&] {
                    check_signal_input_range(description_.levers[i].input, *found,
                                             description_.signal_input_location(i));
                });
                continue;
            }
            std::vector<std::string> known;
            for (const SystemSignal& s : signals)
                if (s.input) known.push_back(s.system + "." + s.name);
            (void)attempt(description_.mistakes, [&] {
                throw_error(description_.signal_input_location(i) / "signal",
                            "there is no signal " + in_quotes(signal_name) + " that may be set" +
                                suggestion(signal_name, known));
            });
        }
    }

    /// Add the resolutions after the winches, whose elements they do not change.
    void add_resolutions(World& world) {
        for (std::size_t i = 0; i < description_.resolutions.size() && numbered_; ++i) {
            const Resolution& one = description_.resolutions[i];
            (void)add_or_report(description_.resolution_location(i), [&] {
                ResolutionDef def = one.def;
                def.wire = world.wires().find(one.cable);
                for (const Winch& winch : description_.winches)
                    if (winch.cable == one.cable && std::isnan(def.drum_length) &&
                        winch.def.element > 0.0)
                        def.drum_length =
                            std::clamp(winch.def.element, def.min_length, def.max_length);
                const Cable* cable = description_.find_cable(one.cable);
                if (cable != nullptr && cable->drum_element > 0.0 && std::isnan(def.drum_length))
                    def.drum_length =
                        std::clamp(cable->drum_element, def.min_length, def.max_length);
                world.add(def);
            });
        }
    }

    void add_cranes(World& world) {
        for (std::size_t i = 0; i < description_.cranes.size() && numbered_; ++i) {
            (void)add_or_report(description_.crane_location(i), [&] {
                std::visit([&](const auto& def) { start_crane(world, def); },
                           description_.cranes[i].def);
            });
        }
    }

    void add_surfaces(World& world) {
        for (const MaterialDef& material : description_.materials) {
            world.add_material(material);
        }
        for (const MaterialPairDef& pair : description_.material_pairs) {
            world.add_material_pair(pair);
        }
        for (std::size_t i = 0; i < description_.shapes.size() && whole_; ++i) {
            (void)add_or_report(description_.shape_location(i),
                                [&] { world.add_shape(description_.shapes[i]); });
        }
    }

    const Description& description_;
    bool whole_ = true;     ///< All bodies are those of the scene.
    bool numbered_ = true;  ///< Interactions have the numbers of the description.
};

void check_options(const Options& options, const SourceLocation& location) {
    if (options.scale < 1 || options.scale > kMaxCopies) {
        throw_error(location, "the scale must be between 1 and " + std::to_string(kMaxCopies) +
                                  ", found " + std::to_string(options.scale));
    }
    if (options.threads < 1 || options.threads > kMaxThreads) {
        throw_error(location,
                    "the number of threads must be between 1 and " + std::to_string(kMaxThreads));
    }
}

/// Make a scene from a document.
/// @param mistakes  List to which mistakes are added; the result is then empty. Null: they are
///        thrown.
std::optional<Scene> make_scene(Json root, const std::filesystem::path& file,
                                const Options& options, Mistakes* mistakes) {
    const SourceLocation location{file.string(), ""};
    check_options(options, location);
    const Document document = make_document(std::move(root), file, options, mistakes);
    if (!document.root.is_object()) {
        return std::nullopt;
    }
    Description description;
    expand(description, document);
    const auto is_at_rest = [](const BodyDef& body) {
        return body.kind == BodyKind::fixed || body.kind == BodyKind::kinematic;
    };
    const auto& bodies = description.bodies;
    if (mistakes == nullptr || !mistakes->has_omitted_parts()) {
        (void)attempt(mistakes, [&] {
            if (std::all_of(bodies.begin(), bodies.end(), is_at_rest)) {
                throw_error(location, "the scene has no body that moves");
            }
        });
    }
    if (mistakes != nullptr && !mistakes->is_empty()) {
        Scene unused;
        read_plot(unused, description, document);
        return std::nullopt;
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
                .world = Builder(description).build(options, document.location / "settings"),
                .cables = {},
                .shape_places = description.shape_places(),
                .signal_inputs = {},
                .timeline = {},
                .plot_tensions = {},
                .plot_motions = {},
                .plot_view_box = {}};
    read_plot(scene, description, document);
    scene.cables = std::move(description.cables);
    for (Lever& lever : description.levers) scene.signal_inputs.push_back(std::move(lever.input));
    if (mistakes == nullptr || mistakes->is_empty()) {
        scene.timeline =
            read_timeline(scene.world, document, loads_by_word(description), scene.signal_inputs);
    }
    if (mistakes != nullptr && !mistakes->is_empty()) {
        return std::nullopt;
    }
    return scene;
}

/// Read a document and make the scene, with a list of mistakes.
template <class Read>
std::optional<Scene> try_scene(const Read& read, const std::filesystem::path& file,
                               const Options& options, std::vector<SceneError>& found) {
    Mistakes mistakes;
    std::optional<Scene> scene;
    (void)attempt(&mistakes,
                  [&] { scene = make_scene(read(&mistakes), file, options, &mistakes); });
    found = mistakes.list();
    if (!mistakes.is_empty()) {
        scene.reset();
    }
    return scene;
}

/// Return the scene. Any mistake is thrown, so that a scene always exists.
Scene make_or_throw(Json root, const std::filesystem::path& file, const Options& options) {
    std::optional<Scene> scene = make_scene(std::move(root), file, options, nullptr);
    if (!scene) throw std::logic_error(file.string() + ": no scene, and no mistake to tell of");
    return *std::move(scene);
}

}  // namespace

Scene load_file(const std::filesystem::path& file, const Options& options) {
    Scene scene = make_or_throw(read_json_file(file, outermost_keys()), file, options);
    scene.files.push_back(file);
    return scene;
}

Scene load_text(std::string_view text, const std::string& name_for_messages,
                const Options& options) {
    return make_or_throw(parse_json(text, name_for_messages, outermost_keys()), name_for_messages,
                         options);
}

std::optional<Scene> load_file(const std::filesystem::path& file, const Options& options,
                               std::vector<SceneError>& mistakes) {
    std::optional<Scene> scene =
        try_scene([&](Mistakes* list) { return read_json_file(file, outermost_keys(), list); },
                  file, options, mistakes);
    if (scene) {
        scene->files.push_back(file);
    }
    return scene;
}

std::optional<Scene> load_text(std::string_view text, const std::string& name_for_messages,
                               const Options& options, std::vector<SceneError>& mistakes) {
    return try_scene(
        [&](Mistakes* list) { return parse_json(text, name_for_messages, outermost_keys(), list); },
        name_for_messages, options, mistakes);
}

}  // namespace hawser::scene
