// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene.h
/// Reader of scene files: creates a World from a JSON document. Part of hawser::scene.
///
/// ```cpp
/// hawser::scene::Scene scene = hawser::scene::load_file("scenes/anchor_lines.json");
/// while (scene.world.time() < scene.duration)
///     if (scene.world.step() != hawser::Status::ok) break;
/// ```
/// Format: docs/scenes.md, schema/scene-1.json. Reading has four stages (src/scene):
/// 1. Parse the document and check its form against the format.
/// 2. Merge includes, apply options and expand templates to one flat document.
/// 3. Compute the initial shape of the cables.
/// 4. Add bodies, interactions and inputs to a new World through its public interface.
///
/// A mistake in the document throws SceneError. Two overloads list all mistakes instead. A Session
/// runs a scene with its inputs and timeline (session.h); the World alone does not.

#include <hawser/hawser.h>
#include <hawser/timeline.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::scene {

/// Exception for an invalid scene. Its message is "file: path: message", followed by the nearest
/// valid name or another remedy if there is one.
struct SceneError : std::runtime_error {
    SceneError(std::string file_, std::string path_, std::string message_);

    std::string file;  ///< File with the mistake, or the name for messages.
    std::string path;  ///< JSON pointer into that file, such as "/bodies/3/mass"; "" for the whole
                       ///< document.
    std::string message;  ///< Description of the mistake and of the valid form.
};

/// Changes to a scene by the caller. They are part of the resolved text, unless stated otherwise.
struct Options {
    int scale = 1;  ///< Number of copies of the scene along `repeat.offset`, 1 to 1000.
    /// Assignments "path=value". The path has keys joined by dots; a list entry has its name or
    /// index. Examples: "settings.step=0.01", "bodies.rig.mass=2e7", "interactions.j1.length=3".
    std::vector<std::string> set;
    /// File of further operations in the format of the key "timeline" (JSON); "": none.
    std::string operations{};
    std::optional<double> step;  ///< Time step instead of settings.step [s].
    std::optional<Form> form;    ///< Form of the equations instead of settings.form.
    int threads = 1;             ///< Number of threads of the world; not part of the text.
    double budget = 0.0;         ///< WorldDef::budget [s]; not part of the text.
    double budget_work = 0.0;    ///< WorldDef::budget_work [flop]; not part of the text.
};

/// Section of a cable with one line type.
struct CableSection {
    std::string line_type;         ///< Name of the line type; "" if given inline.
    std::size_t elements = 0;      ///< Number of equal elements.
    double length = 0.0;           ///< Unstretched length [m].
    double mass_per_length = 0.0;  ///< Mass per length [kg/m].
    double EA = 0.0;               ///< Axial stiffness [N].
    double EI = 0.0;               ///< Bending stiffness [N m²].
    double breaking_load = 0.0;    ///< Breaking load [N]; 0: not given.
    double diameter = 0.0;         ///< Diameter [m]; 0: not given.
    double link = 0.0;             ///< Pitch of a chain link [m]; 0: not a chain.
};

/// Parts of the world that a cable of the scene created.
struct Cable {
    std::string name;       ///< Name of the cable.
    std::string line_type;  ///< Name of the line type; "" if given inline. Several are joined by
                            ///< " + ".
    /// Nodes in order, with the bodies at both ends ("world" for a fixed end). With rigid links:
    /// the first end, every link, the last end; a free end then has no body of its own.
    std::vector<BodyId> nodes;
    std::vector<InteractionId> stretch;  ///< Elements in order; with rigid links, the ball joints.
    bool links = false;                  ///< True: rigid links instead of lumped masses.
    Vec3 from_point{0.0, 0.0, 0.0};      ///< Attachment in the frame of nodes.front() [m].
    Vec3 to_point{0.0, 0.0, 0.0};        ///< Attachment in the frame of nodes.back() [m].
    /// Sections from the first end; one for a single line type.
    std::vector<CableSection> sections;
    double EA = 0.0;             ///< Largest axial stiffness [N]; 0 for links without one.
    double breaking_load = 0.0;  ///< Smallest breaking load [N]; 0: not given.
    double length = 0.0;         ///< Unstretched length [m].
    double diameter = 0.0;  ///< Largest diameter of the line types, for pictures [m]; 0: not given.
    WireTrim trim{};        ///< Properties of elements that a winch adds.
    /// Length of the elements that the bare drum of the key "winch" pays out [m] (drum_feed.h). 0:
    /// only one element (version 1 of the format). NaN: the cable has no such key.
    double drum_element = kDefault;
    std::string color;  ///< Colour for pictures; "": not given.
    /// Range of material coordinates that lies on the seabed (key "seabed") at the start [m]; NaN:
    /// none.
    double laid_from = kDefault, laid_to = kDefault;
};

/// Input of a scene that sets a signal of a system, such as the speed of a winch.
/// Session::set_input() applies it. Operations of Scene::timeline contain the signal and its value
/// instead of the input.
struct SignalInput {
    std::string name;                ///< Name of the input.
    std::string signal;              ///< Signal as "system.signal".
    double factor = 1.0;             ///< Factor from the input's value to the signal [1].
    double min = -1e30, max = 1e30;  ///< Range to which the value is clamped.
    std::string unit{}, group{};  ///< Unit and heading for displays; "": the unit of the signal, no
                                  ///< heading.
    double nominal = 0.0;         ///< Usual magnitude, for controls; 0: unknown.
    std::optional<double> spring{};  ///< Value to which its control returns when released.
};

/// Scene with its world, ready to run.
struct Scene {
    std::string name;         ///< Name of the scene.
    std::string description;  ///< Description.
    std::string path;         ///< Scene file, or the name for messages.
    /// Files that were read: the scene, its includes and its state.
    std::vector<std::filesystem::path> files;
    std::filesystem::path state_file;  ///< File of the key "state", among `files`; empty: none.
    /// Self-contained JSON document with includes, options, templates and copies resolved. Reading
    /// it creates an equal world.
    std::string text;
    std::uint64_t hash = 0;     ///< FNV-1a hash of `text`, 64 bits.
    double duration = 10.0;     ///< Duration of the run [s].
    World world;                ///< World at the start of the scene.
    std::vector<Cable> cables;  ///< Cables with their parts in the world.
    /// Position of each shape in the document, by the index of its id: file and JSON pointer, such
    /// as "tow.json: /shapes/3". Capsules of a cable have the position of the cable.
    std::vector<std::string> shape_places;
    std::vector<SignalInput> signal_inputs;  ///< Inputs that set signals of systems.
    std::vector<Operation> timeline;  ///< Operations ordered by time. A Session executes them.
    std::vector<std::string> plot_tensions;  ///< Cables with a tension curve in plots.
    std::vector<std::string> plot_motions;   ///< Bodies with a motion curve in plots.
    /// Lower and upper corner of the pictures' view [m]; empty: everything.
    std::vector<Vec3> plot_view_box;
};

/// Read a scene file.
/// @throws SceneError if the file cannot be read or the scene is invalid.
[[nodiscard]] Scene load_file(const std::filesystem::path& file, const Options& options = {});

/// Read a scene from memory.
/// @param name_for_messages  Name of the scene file; its folder is searched for includes and state
/// files.
/// @throws SceneError if the scene is invalid.
[[nodiscard]] Scene load_text(std::string_view text, const std::string& name_for_messages,
                              const Options& options = {});

/// Read a scene and list all its mistakes in reading order. Entries with a mistake are omitted;
/// references to them do not count as mistakes.
/// @param mistakes  Receives the mistakes.
/// @return the scene, or nullopt if there is a mistake.
[[nodiscard]] std::optional<Scene> load_file(const std::filesystem::path& file,
                                             const Options& options,
                                             std::vector<SceneError>& mistakes);
[[nodiscard]] std::optional<Scene> load_text(std::string_view text,
                                             const std::string& name_for_messages,
                                             const Options& options,
                                             std::vector<SceneError>& mistakes);

/// Return the text of a state file for the key "state" of a scene (docs/scenes.md): pose and
/// velocity of each moving body.
[[nodiscard]] std::string state_text(const Scene& scene);

}  // namespace hawser::scene
