// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene.h
/// Reads a scene file into a world. Part of hawser::scene.
///
/// A scene is a JSON document (docs/scenes.md, schema/scene-1.json). Reading has four steps, in
/// src/scene: the document is parsed and its shape checked against the format;
/// includes are merged, options applied and templates expanded into one flat document;
/// cables are laid out; the bodies, interactions and inputs are added to a new World through
/// its public interface. A mistake anywhere throws SceneError and leaves nothing behind; there is a
/// second pair of functions that lists all of them.

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

/// A scene that was refused. what() reads "file: path: message", followed by the nearest valid
/// name or another remedy where there is one.
struct SceneError : std::runtime_error {
    SceneError(std::string file_, std::string path_, std::string message_);

    std::string file;     ///< File (or name for messages) in which the mistake is.
    std::string path;     ///< JSON pointer into that file, such as "/bodies/3/mass"; "" for the
                          ///< document as a whole.
    std::string message;  ///< What is wrong and what would be right.
};

/// Changes to a scene that the caller asks for. They are part of the resolved text.
struct Options {
    int scale = 1;  ///< Copies of the scene along `repeat.offset`, 1 to 1000.
    /// "path=value", for instance "settings.step=0.01", "bodies.rig.mass=2e7" or
    /// "interactions.j1.length=3": keys joined by dots, a list entry by its name or index.
    std::vector<std::string> set;
    /// File of operations beside those of "timeline", as that key lists them (JSON); "": none.
    std::string operations{};
    std::optional<double> step;  ///< Instead of settings.step [s].
    std::optional<Form> form;    ///< Instead of settings.form.
    int threads = 1;             ///< Worker threads of the world; not part of the text.
    double budget = 0.0;         ///< WorldDef::budget [s]; not part of the text.
    double budget_work = 0.0;    ///< WorldDef::budget_work [flop]; not part of the text.
};

/// A piece of a cable of one line type.
struct CableSection {
    std::string line_type;         ///< Its name; "" if given in place.
    std::size_t elements = 0;      ///< Equal ones.
    double length = 0.0;           ///< Unstretched [m].
    double mass_per_length = 0.0;  ///< [kg/m].
    double EA = 0.0;               ///< [N].
    double EI = 0.0;               ///< [N m²].
    double breaking_load = 0.0;    ///< [N]; 0 = not given.
    double diameter = 0.0;         ///< [m]; 0 = not given.
    double link = 0.0;             ///< Pitch of a link of chain [m]; 0: it is no chain.
};

/// What a cable of the scene became.
struct Cable {
    std::string name;
    std::string line_type;      ///< Name of its line type; "" if given in place; of several " + ".
    std::vector<BodyId> nodes;  ///< In order, the bodies at both ends included ("world" for an
                                ///< end fixed there); for links: the first end, every link, the
                                ///< last end. A free end has no body of its own with links.
    std::vector<InteractionId> stretch;  ///< In order; for links the ball joints.
    bool links = false;                  ///< Rigid links instead of lumps.
    Vec3 from_point{0.0, 0.0, 0.0};      ///< Attachment in the frame of nodes.front() [m].
    Vec3 to_point{0.0, 0.0, 0.0};        ///< Attachment in the frame of nodes.back() [m].
    /// From the first end on; one where it is of one line type.
    std::vector<CableSection> sections;
    double EA = 0.0;             ///< Axial stiffness [N]; 0 for links without one; the largest.
    double breaking_load = 0.0;  ///< [N]; 0 = not given; the least.
    double length = 0.0;         ///< Unstretched length [m].
    double diameter = 0.0;  ///< Of its line type, for pictures [m]; 0 = not given; the largest.
    WireTrim trim{};        ///< Of elements that a winch adds.
    /// Length of the elements that the bare drum of its key "winch" pays out [m]; 0: it keeps one
    /// element (version 1 of the format); NaN: no such key (drum_feed.h).
    double drum_element = kDefault;
    std::string color;  ///< For pictures; "" = not given.
    /// Material coordinates between which it starts on its key "seabed" [m]; NaN: it does not.
    double laid_from = kDefault, laid_to = kDefault;
};

/// An input of a scene that sets a signal of a system, such as the speed of a winch. A Session sets
/// it. Operations of `timeline` have the signal and its value instead.
struct SignalInput {
    std::string name;
    std::string signal;              ///< "system.signal".
    double factor = 1.0;             ///< The signal is the value times this.
    double min = -1e30, max = 1e30;  ///< Of the value, which is clamped.
    std::string unit{}, group{};     ///< For displays; "": the unit of the signal, no heading.
    double nominal = 0.0;            ///< Usual size, for levers; 0: not known.
    std::optional<double> spring{};  ///< Value that its lever goes home to when it is let go.
};

/// A scene, ready to run.
struct Scene {
    std::string name;
    std::string description;
    std::string path;  ///< File it was read from, or the name for messages.
    /// All files that were read: the scene, its includes and its state.
    std::vector<std::filesystem::path> files;
    std::filesystem::path state_file;  ///< Of these, the one under "state"; empty: none.
    /// Self-contained document in JSON with includes, options, templates and copies worked in:
    /// reading it alone gives the same world.
    std::string text;
    std::uint64_t hash = 0;  ///< FNV-1a 64 of `text`.
    double duration = 10.0;  ///< [s].
    World world;
    std::vector<Cable> cables;
    /// Where each shape comes from, by the index of its id: file and JSON pointer, as a SceneError
    /// has them, "tow.json: /shapes/3"; of the capsules of a cable the cable's.
    std::vector<std::string> shape_places;
    std::vector<SignalInput> signal_inputs;
    std::vector<Operation> timeline;         ///< By time. A Session does it.
    std::vector<std::string> plot_tensions;  ///< Cables whose tension is worth a curve.
    std::vector<std::string> plot_motions;   ///< Bodies whose motion is worth a curve.
    /// Lower and upper corner of what pictures show [m]; empty: everything.
    std::vector<Vec3> plot_view_box;
};

/// Read a scene file. @throws SceneError.
[[nodiscard]] Scene load_file(const std::filesystem::path& file, const Options& options = {});

/// Read a scene from memory. Its includes and state files, if any, are looked up beside
/// `name_for_messages` taken as a path. @throws SceneError.
[[nodiscard]] Scene load_text(std::string_view text, const std::string& name_for_messages,
                              const Options& options = {});

/// Read a scene and take down all its mistakes in the order in which reading meets them, as far as
/// it can go on: what holds a mistake is left out, and what only names something left out is no
/// mistake. @return nothing where there are any.
[[nodiscard]] std::optional<Scene> load_file(const std::filesystem::path& file,
                                             const Options& options,
                                             std::vector<SceneError>& mistakes);
[[nodiscard]] std::optional<Scene> load_text(std::string_view text,
                                             const std::string& name_for_messages,
                                             const Options& options,
                                             std::vector<SceneError>& mistakes);

/// The present pose and velocity of every moving body, as a state file (docs/scenes.md) that
/// a scene names under "state".
[[nodiscard]] std::string state_text(const Scene& scene);

}  // namespace hawser::scene
