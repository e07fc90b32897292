// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file description.h
/// A scene as flat lists of definitions, before it becomes a world. Bodies and interactions
/// refer to one another by their index here, which is also their index in the world.

#include <hawser/anchor.h>
#include <hawser/chaser.h>
#include <hawser/crane.h>
#include <hawser/edges.h>
#include <hawser/guide.h>
#include <hawser/hook.h>
#include <hawser/pin.h>
#include <hawser/post.h>
#include <hawser/resolution.h>
#include <hawser/sea.h>
#include <hawser/stability.h>
#include <hawser/stopper.h>
#include <hawser/vessel.h>

#include "scene/document.h"
#include "scene/frame.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace hawser::scene {

/// A winch of the description. Its wire is given by the name of a cable.
struct Winch {
    WinchDef def;
    std::string cable;
    int location = 0;
};

/// A guide of the description. Its wire is given by the name of a cable.
struct GuideItem {
    GuideDef def;
    std::string cable;
    int location = 0;
};

/// A post of the description. Its shape is found by name.
struct PostItem {
    PostDef def;
    int location = 0;
};

/// Deck gear of the description.
struct DeckGear {
    template <class Def>
    struct Item {
        Def def;
        SourceLocation location;
    };
    std::vector<Item<StopperDef>> stoppers;
    std::vector<Item<PinDef>> pins;
    std::vector<Item<HookDef>> hooks;
    std::vector<Item<ChaserDef>> chasers;
};

/// Resolution of a cable of the description.
struct Resolution {
    ResolutionDef def;
    std::string cable;
    int location = 0;
};

/// A crane of the description. Its parts are among the bodies and interactions. Its drives are
/// added to the world.
struct Crane {
    std::variant<KnuckleCraneDef, LatticeCraneDef> def;
    int location = 0;
};

/// An anchor of the description. Its line is given by the name of a cable, or empty.
struct AnchorItem {
    AnchorDef def;
    std::string cable;
    SourceLocation location;
};

/// A stability gauge of the description. Its wires are given by the names of cables.
struct StabilityItem {
    StabilityDef def;
    std::string cable;
    std::vector<std::string> other_names;
    SourceLocation location;
};

/// A cable in water, as described.
struct CableWater {
    std::string cable{};
    std::vector<WaterLine::Section> sections{};
    bool free_first = false, free_last = false;
    SourceLocation location{};
};

/// An item of a section (sections.h): a system that is added to the world last.
struct SectionItem {
    std::string name{};    ///< Full name in the first copy of the scene.
    std::string prefix{};  ///< Prefix of all names in its copy of the scene; "" in the first.
    SourceLocation location{};
    /// Add the system. Names that it refers to begin with `prefix`. @throws DefError.
    std::function<void(World&, const std::string& prefix, const std::string& name)> add;
};

/// An input of a signal.
struct Lever {
    SignalInput input;
    int location = 0;
};

class Description {
  public:
    WorldDef settings;
    double duration = 10.0;
    int version = 1;           ///< Version of the format; see kFormatVersion.
    std::optional<int> parts;  ///< settings.parts; none: kParts if no body has a group, else 0.
    static constexpr int kParts = 4;
    Mistakes* mistakes = nullptr;  ///< List to which mistakes are added; null: they are thrown.
    std::size_t copies = 1;        ///< Copies to be made, which count towards the limits.
    double default_compliance = kDefault;
    double default_damping_time = kDefault;

    std::vector<BodyDef> bodies;
    std::vector<InteractionDef> interactions;
    std::vector<InputDef> inputs;
    std::vector<OutputDef> outputs;
    std::vector<Cable> cables;
    std::vector<Winch> winches;
    std::vector<GuideItem> guides;
    std::vector<PostItem> posts;
    DeckGear deck;
    std::vector<Resolution> resolutions;
    std::vector<Crane> cranes;
    std::vector<DeckGear::Item<VesselDef>> vessels;
    std::vector<AnchorItem> anchors;
    std::vector<StabilityItem> gauges;
    std::vector<Lever> levers;
    std::vector<SectionItem> sections;
    std::vector<CableWater> waters;  ///< Cables that are in water if the scene has a sea.
    std::optional<SeaDef> sea;       ///< The sea; its lines are in `waters`.
    SourceLocation sea_location;
    /// Place of each entry of its lists.
    std::vector<SourceLocation> sea_body_locations, sea_hull_locations, sea_rod_locations;
    std::vector<MaterialDef> materials;  ///< Material i of the list is i + 1 of the world.
    std::vector<MaterialPairDef> material_pairs;
    std::vector<ShapeDef> shapes;

    /// Store a position in the document to which several items refer. @return its index.
    int store_location(const SourceLocation& location);
    [[nodiscard]] const SourceLocation& body_location(std::size_t i) const {
        return locations_[body_at_[i]];
    }
    [[nodiscard]] const SourceLocation& interaction_location(std::size_t i) const {
        return locations_[interaction_at_[i]];
    }
    [[nodiscard]] const SourceLocation& input_location(std::size_t i) const {
        return locations_[input_at_[i]];
    }
    [[nodiscard]] const SourceLocation& output_location(std::size_t i) const {
        return locations_[output_at_[i]];
    }
    [[nodiscard]] const SourceLocation& winch_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(winches[i].location)];
    }
    [[nodiscard]] const SourceLocation& guide_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(guides[i].location)];
    }
    [[nodiscard]] const SourceLocation& post_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(posts[i].location)];
    }
    [[nodiscard]] const SourceLocation& resolution_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(resolutions[i].location)];
    }
    [[nodiscard]] const SourceLocation& crane_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(cranes[i].location)];
    }
    [[nodiscard]] const SourceLocation& signal_input_location(std::size_t i) const {
        return locations_[static_cast<std::size_t>(levers[i].location)];
    }
    [[nodiscard]] const SourceLocation& shape_location(std::size_t i) const {
        return locations_[shape_at_[i]];
    }
    /// Return the positions of all shapes in the document, such as "FILE: /shapes/3".
    [[nodiscard]] std::vector<std::string> shape_places() const;

    void add_shape(ShapeDef def, int location);
    /// Remove the capsule between two ends. @return the capsule, if there is one.
    std::optional<ShapeDef> remove_segment(BodyId a, BodyId b);
    /// Return the bit mask of the collision groups that a word or a list of words names. A new name
    /// makes a new group.
    std::uint32_t groups(const Json& names, const SourceLocation& location);
    /// Return the bit mask of the collision groups that a shape may touch, from a list of names.
    /// check_groups() rejects names that no shape has.
    std::uint32_t touched(const Json& names, const SourceLocation& location);
    void check_groups() const;
    /// Add a body. @throws SceneError if the name exists or there are too many bodies.
    BodyId add_body(BodyDef def, int location);
    InteractionId add_interaction(InteractionDef def, int location);
    void add_input(InputDef def, int location);
    void add_signal_input(SignalInput input, int location);
    void add_output(OutputDef def, int location);
    void add_cable(Cable cable, const SourceLocation& location);

    [[nodiscard]] BodyId find_body(const std::string& name) const;
    [[nodiscard]] InteractionId find_interaction(const std::string& name) const;
    [[nodiscard]] bool has_cable(const std::string& name) const;
    /// Return the cable with this name; null if there is none.
    [[nodiscard]] const Cable* find_cable(const std::string& name) const;
    /// Return the fixed body "world". The first call adds it.
    BodyId world_body();
    [[nodiscard]] BodyId world_body_if_any() const { return world_; }

    [[nodiscard]] const BodyDef& body(BodyId id) const {
        return bodies[static_cast<std::size_t>(id.index)];
    }
    /// Return the world position of a point of a body.
    [[nodiscard]] Vec3 world_point(BodyId id, const Vec3& local) const;
    [[nodiscard]] Frame frame_of(BodyId id) const;

  private:
    std::vector<SourceLocation> locations_;
    std::vector<std::size_t> body_at_, interaction_at_, input_at_, output_at_, shape_at_;
    std::vector<std::string> group_names_{"default"};
    std::uint32_t named_groups_ = 0;  ///< Those that some shape is in.
    /// Bits of the groups touched, and the place of each name.
    std::vector<std::pair<std::uint32_t, SourceLocation>> touched_at_;
    std::unordered_map<std::string, std::int32_t> body_names_, interaction_names_, input_names_,
        output_names_, cable_names_;
    BodyId world_;
};

/// Part of the scene in which names are local: the scene itself or one instance.
struct Scope {
    const Json* content = nullptr;  ///< Object with the lists "bodies", "cables", …
    SourceLocation location;        ///< Place of `content`.
    std::string prefix;             ///< Prefix of all names in this scope, such as "port_crane/".
    Frame frame;
    std::unordered_map<std::string, std::string> bound;  ///< Local body name -> full name.
};

/// Return the body with this local name. @throws SceneError with the nearest name.
[[nodiscard]] BodyId resolve_body(Description& out, const Scope& scope, const std::string& name,
                                  const SourceLocation& location);

/// Return the interaction with this local name among the interactions that have been read. @throws
/// SceneError with the nearest name.
[[nodiscard]] InteractionId resolve_interaction(const Description& out, const Scope& scope,
                                                const std::string& name,
                                                const SourceLocation& location);

/// Fill the description from the document; see expand.cpp. If mistakes are collected, parts with
/// mistakes are omitted.
void expand(Description& out, const Document& document);

/// Read "settings" and "defaults" of a scene (settings.cpp).
void read_settings(Description& out, const Json& root);
/// Read the bodies of one scope (bodies.cpp).
void expand_bodies(Description& out, const Scope& scope);
/// Read the interactions of one scope (interactions.cpp).
void expand_interactions(Description& out, const Scope& scope);
/// Read one cable (cables.cpp). `to_scope` is the scope in which the name of its last end is
/// searched.
void expand_cable(Description& out, const Scope& scope, const Scope& to_scope, const Json& cable,
                  const Document& document, const SourceLocation& location);
/// Read the materials and their pairs (materials.cpp).
void expand_materials(Description& out, const Document& document);
/// Read the surface and groups of a shape, if defined: "material", "groups", "touches"
/// (materials.cpp).
void read_surface(ShapeDef& def, Description& out, const Json& json,
                  const SourceLocation& location);
/// Read the shapes of a body, except its segments (shapes.cpp).
void expand_shapes(Description& out, BodyId body, const Json& list, const SourceLocation& location);
/// Read the segments whose first body belongs to one scope; the other body may belong to any scope.
/// All bodies must have been read (shapes.cpp).
void expand_segments(Description& out, const Scope& scope);
/// Read the inputs of one scope (inputs.cpp).
void expand_inputs(Description& out, const Scope& scope);
/// Read the winches of one scope. All cables must have been read (winches.cpp).
void expand_winches(Description& out, const Scope& scope);
/// Read the guides of one scope. All cables and winches must have been read (guides.cpp).
void expand_guides(Description& out, const Scope& scope);
/// Read the bollards (key "posts") of one scope. All bodies must have been read (posts.cpp).
void expand_posts(Description& out, const Scope& scope);
/// Return the axes of cylinders of a radius [m] inside the edges of a box, hull or mesh of a body,
/// for the key "edge_of" of a bollard (post_edges.cpp). @throws SceneError if there are none.
[[nodiscard]] std::vector<EdgeAxis> axes_of_edges(const Description& out, BodyId body,
                                                  const Json& json, double radius,
                                                  const SourceLocation& location);
/// Read the cranes of one scope. All bodies except those of cables must have been read
/// (cranes.cpp).
void expand_cranes(Description& out, const Scope& scope);
/// Read the routes of one scope: lines over bollards and sheaves. All bodies must have been read
/// (routes.cpp).
void expand_routes(Description& out, const Scope& scope);
/// Read the sea. All bodies must have been read (sea.cpp). @param waters  Number of cables in water
/// in the first copy of the scene.
void expand_sea(Description& out, const Document& document, std::size_t waters);
/// Store the water data of a cable if a section of it is in water (sea.cpp).
void store_water(Description& out, const CableWater& water);
/// Add the sea to a world with bodies and wires (sea.cpp). @throws SceneError, DefError.
void add_sea(World& world, const Description& from);
/// Read the outputs of one scope. All interactions must have been read (outputs.cpp).
void expand_outputs(Description& out, const Scope& scope);
/// Read the sections of one scope. All interactions and inputs of the scope have been read
/// (sections.cpp).
void expand_sections(Description& out, const Scope& scope);
/// Return the definition of an output for the world. An output of the tension of a cable refers to
/// its wire, because the number of elements can change. @param world  World with the wires of the
/// scene.
[[nodiscard]] OutputDef output_of(const Description& scene, std::size_t output, const World& world);
/// Set the poses and velocities of the scene key `state` (state.cpp). The bodies are those of the
/// first copy of the scene, or of the cables that join copies.
void apply_state(Description& out, const Document& document);
/// Make the copies of all parts that have been read, and the cables that join them (repeat.cpp).
void expand_copies(Description& out, const Document& document);

/// Replace "${name}" in every string by the parameter (templates.cpp).
[[nodiscard]] Json substitute(const Json& value, const Json& parameters,
                              const SourceLocation& location);

// --- Reading values whose shape has been checked -------------------------------------------
[[nodiscard]] Vec3 vector_of(const Json& value);
[[nodiscard]] Vec3 vector_or(const Json& object, const char* key, const Vec3& fallback);
[[nodiscard]] double number_or(const Json& object, const char* key, double fallback);
[[nodiscard]] std::string text_or(const Json& object, const char* key, const char* fallback);
/// Read the display settings of an input or output: "unit", "group", "nominal".
template <class Def>
void read_display(Def& def, const Json& json) {
    def.unit = text_or(json, "unit", "");
    def.group = text_or(json, "group", "");
    def.nominal = number_or(json, "nominal", 0.0);
}
/// Return the name of a group. The value is a text or a number.
[[nodiscard]] std::string group_of(const Json& value);
/// Read "orientation" or "euler_deg" of an object. @throws SceneError for a zero quaternion.
[[nodiscard]] Quat orientation_of(const Json& object, const SourceLocation& location);
[[nodiscard]] Quat quaternion_of(const Json& value, const SourceLocation& location);

}  // namespace hawser::scene
