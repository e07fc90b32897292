// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Outputs: numbers of a world that are read by name, as inputs are set by name. Displays, plots,
/// tables, exercises and clients of the live protocol use them.
///
/// ```cpp
/// const auto pull = world.add_output({.name = "tow", .kind = hawser::OutputKind::tension,
///                                     .line = elements, .component = "largest"});
/// while (world.step() == hawser::Status::ok) log(world.outputs());   // all, in the order added
/// ```
/// A table (OutputKindInfo) defines the target of each kind of output, and its components with
/// units. The scene reader, the JSON Schema and the reference page are generated from it.
///
/// Values are in SI units and depend on the state only, except components marked as measured. They
/// are therefore equal to the bit for any number of threads, and after a restore. Residuals of a
/// step are not part of a state: after a restore they are 0 until the next step.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

using OutputId = Id<struct OutputTag>;

/// Kind of an output.
enum class OutputKind : std::uint8_t {
    pose,         ///< Position of a point of a body, and orientation of the body.
    velocity,     ///< Velocity of a point of a body, and angular velocity of the body.
    coordinate,   ///< World::coordinate() of an interaction.
    speed,        ///< World::speed() of an interaction.
    motor_force,  ///< World::motor_force() of an interaction.
    force,        ///< World::force() of an interaction.
    tension,      ///< Tension of a wire or line: first element, last element, or largest of all.
    drum,         ///< Length that a drum has paid out of an element.
    distance,     ///< Distance between a point of one body and a point of another.
    statistic,    ///< Figure of the whole world: residual, energy, count or time.
    signal,       ///< Signal of a system: World::add_system() adds one output for each (system.h).
};
inline constexpr int kOutputKindCount = 11;

/// Component of a kind of output.
struct OutputComponent {
    const char* name;       ///< Name in scene files, e.g. "roll".
    const char* unit;       ///< SI unit.
    const char* doc;        ///< Description, one sentence.
    bool measured = false;  ///< True: measured by a clock, so that two runs differ.
};

/// Target of an output.
enum class OutputTarget : std::uint8_t {
    body,         ///< Uses OutputDef::body and point.
    two_bodies,   ///< Also uses body_b and point_b.
    interaction,  ///< Uses OutputDef::interaction.
    line,         ///< Uses OutputDef::wire or line.
    world,        ///< Uses no field.
    system,       ///< Signal of a system; not available in scene files.
};

/// Table row of a kind of output. Readers and documents are generated from it.
struct OutputKindInfo {
    OutputKind kind{};                              ///< Kind that the row describes.
    const char* name = "";                          ///< Name in scene files.
    OutputTarget target = OutputTarget::world;      ///< Members of OutputDef that it reads.
    std::span<const OutputComponent> components{};  ///< Components that OutputDef::component names.
    const char* doc = "";                           ///< Description, one or two sentences.
};

/// Return all kinds in the order of OutputKind.
[[nodiscard]] std::span<const OutputKindInfo> output_kinds() noexcept;
/// Return the table row of a kind.
[[nodiscard]] const OutputKindInfo& output_kind_info(OutputKind kind) noexcept;
/// Return the kind with this name, or nullptr.
[[nodiscard]] const OutputKindInfo* find_output_kind(std::string_view name) noexcept;

/// Definition of an output. World::add_output() copies it.
struct OutputDef {
    std::string name{};  ///< Unique name among outputs. Required.
    OutputKind kind = OutputKind::pose;
    BodyId body{};                ///< Body of pose, velocity, distance.
    Vec3 point{0.0, 0.0, 0.0};    ///< Point in the body's frame, from its centre of mass [m].
    BodyId body_b{};              ///< Second body of distance.
    Vec3 point_b{0.0, 0.0, 0.0};  ///< Point in the frame of body_b, from its centre of mass [m].
    InteractionId interaction{};  ///< Interaction of coordinate, speed, motor_force, force, drum.
    WireId wire{};                ///< Wire of tension, with its present elements; invalid: set
                                  ///< `line`.
    std::vector<InteractionId> line{};  ///< Elements of tension in order. The value is NaN if one
                                        ///< of them is removed.
    /// Name of a component of the kind; "" if it has only one.
    std::string component{};
    /// True: velocity along and about the body's axes instead of the world's.
    bool local = false;
    std::string unit{};   ///< Unit label; "": that of the component. Values are always in SI units.
    std::string group{};  ///< Heading under which a client shows it; free text.
    double nominal = 0.0;  ///< Usual magnitude, for axes and tolerances, in `unit`; 0: unknown.
};

}  // namespace hawser
