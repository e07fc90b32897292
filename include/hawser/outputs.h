// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Outputs: numbers of a world that are read by name, as inputs are set by name.
///
/// ```cpp
/// const auto pull = world.add_output({.name = "tow", .kind = hawser::OutputKind::tension,
///                                     .line = elements, .component = "largest"});
/// while (world.step() == hawser::Status::ok) log(world.outputs());   // all, in the order added
/// ```
/// What a kind of output is made of stands in a table, from which the scene reader, the JSON Schema
/// and the reference page are generated: its target, its components with their units. Values are in
/// SI units and follow from the state alone, in a fixed order, but for components that are marked
/// as measured: they are the same bits for any number of threads, and after a restore. The
/// residuals of a step are no part of a state: after a restore they are 0 until the next step.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

using OutputId = Id<struct OutputTag>;

enum class OutputKind : std::uint8_t {
    pose,         ///< Where a point of a body is, and how the body is turned.
    velocity,     ///< How fast a point of a body moves, and how fast the body turns.
    coordinate,   ///< World::coordinate() of an interaction.
    speed,        ///< World::speed() of an interaction.
    motor_force,  ///< World::motor_force() of an interaction.
    force,        ///< World::force() of an interaction.
    tension,      ///< Of a wire or line: of its first element, its last, or the largest of all.
    drum,         ///< Line that a drum has paid out.
    distance,     ///< Between a point of one body and a point of another.
    statistic,    ///< Of the whole world: residuals, energies, counts, times.
    signal,       ///< Of a system: World::add_system() adds one for each signal (system.h).
};
inline constexpr int kOutputKindCount = 11;

/// One number that a kind of output can give.
struct OutputComponent {
    const char* name;       ///< As in scene files, e.g. "roll".
    const char* unit;       ///< SI.
    const char* doc;        ///< One sentence.
    bool measured = false;  ///< By a clock: not the same in two runs.
};

/// What an output is taken from.
enum class OutputTarget : std::uint8_t {
    body,         ///< OutputDef::body and point.
    two_bodies,   ///< Also body_b and point_b.
    interaction,  ///< OutputDef::interaction.
    line,         ///< OutputDef::wire or line.
    world,        ///< Nothing.
    system,       ///< A system's signal, which no scene file can name.
};

/// What a kind gives and needs: the table row from which readers and documents are made.
struct OutputKindInfo {
    OutputKind kind{};
    const char* name = "";  ///< As in scene files.
    OutputTarget target = OutputTarget::world;
    std::span<const OutputComponent> components{};
    const char* doc = "";  ///< What it is, in one or two sentences.
};

/// All kinds in the order of OutputKind.
[[nodiscard]] std::span<const OutputKindInfo> output_kinds() noexcept;
[[nodiscard]] const OutputKindInfo& output_kind_info(OutputKind kind) noexcept;
/// @return nullptr when no kind has this name.
[[nodiscard]] const OutputKindInfo* find_output_kind(std::string_view name) noexcept;

/// One output. A definition: World::add_output copies it whole.
struct OutputDef {
    std::string name{};  ///< Unique among outputs. Required.
    OutputKind kind = OutputKind::pose;
    BodyId body{};                      ///< Of pose, velocity, distance.
    Vec3 point{0.0, 0.0, 0.0};          ///< In the body's frame, from its centre of mass [m].
    BodyId body_b{};                    ///< Other end of distance.
    Vec3 point_b{0.0, 0.0, 0.0};        ///< In the frame of body_b [m].
    InteractionId interaction{};        ///< Of coordinate, speed, motor_force, force, drum.
    WireId wire{};                      ///< Of tension: of a wire, whatever nodes it has …
    std::vector<InteractionId> line{};  ///< … or of a line, by its elements in order. Where one of
                                        ///< them goes, there is no number any more.
    /// Name of one of the kind's components; "" where it has but one.
    std::string component{};
    /// Of velocity: along and about the body's own axes instead of the world's.
    bool local = false;
    std::string unit{};    ///< "": that of the component. A label; values are in SI units.
    std::string group{};   ///< Free text: under which heading a client shows it.
    double nominal = 0.0;  ///< Usual size, for axes and tolerances, in the unit; 0: not known.
};

}  // namespace hawser
