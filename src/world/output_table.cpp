// SPDX-License-Identifier: Apache-2.0
/// Table of the existing outputs.
#include <hawser/outputs.h>

#include "world/outputs.h"

#include <array>
#include <cstddef>

namespace hawser {
namespace {

constexpr OutputComponent kPoseComponents[] = {
    {"x", "m", "Position of the point, world frame; of a scalar body its coordinate."},
    {"y", "m", "Position of the point, world frame."},
    {"z", "m", "Position of the point, world frame."},
    {"roll", "rad", "About the body's x axis, from -pi to pi."},
    {"pitch", "rad", "Of the body's x axis below the horizontal, from -pi/2 to pi/2."},
    {"yaw", "rad", "Heading: of the body's x axis about z of the world, from x towards y."},
    {"qw", "1", "Orientation as a quaternion, body to world: its real part."},
    {"qx", "1", "Orientation as a quaternion."},
    {"qy", "1", "Orientation as a quaternion."},
    {"qz", "1", "Orientation as a quaternion."}};
constexpr OutputComponent kVelocityComponents[] = {
    {"x", "m/s", "Velocity of the point; of a scalar body its rate."},
    {"y", "m/s", "Velocity of the point."},
    {"z", "m/s", "Velocity of the point."},
    {"turn_x", "rad/s", "Angular velocity."},
    {"turn_y", "rad/s", "Angular velocity."},
    {"turn_z", "rad/s", "Angular velocity; of a ship on an even keel its rate of turn."}};
constexpr OutputComponent kCoordinateComponents[] = {
    {"value", "m or rad", "Angle or way of a joint, position of a scalar body."}};
constexpr OutputComponent kSpeedComponents[] = {
    {"value", "m/s or rad/s", "Rate of the coordinate."}};
constexpr OutputComponent kMotorForce[] = {
    {"value", "N or N m", "Positive where the motor pushes the coordinate up."}};
constexpr OutputComponent kForceComponents[] = {
    {"row_0", "N or N m", "Force of the first row in the last step."},
    {"row_1", "N or N m", "Of the second row."},
    {"row_2", "N or N m", "Of the third row."},
    {"row_3", "N or N m", "Of the fourth row."},
    {"row_4", "N or N m", "Of the fifth row."},
    {"row_5", "N or N m", "Of the sixth row."}};
static_assert(std::size(kForceComponents) == kMaxInteractionRows);
constexpr OutputComponent kTensionComponents[] = {
    {"first", "N",
     "Of the first element, negative where it pushes; the force of a joint's points."},
    {"last", "N", "Of the last element."},
    {"largest", "N", "Of the element with most."}};
constexpr OutputComponent kDrumComponents[] = {
    {"paid_out", "m",
     "Line paid out since the start, by the winch's account where the cable has a winch; of "
     "another drum since it was at 0. Negative: hauled in."},
    {"length", "m", "Line between the drum and the next node, without tension."}};
constexpr OutputComponent kDistanceComponents[] = {{"value", "m", "From point to point."}};
constexpr OutputComponent kStatisticComponents[] = {
    {"residual", "1", "Relative residual of momentum in the last step."},
    {"row_residual", "m/s or rad/s", "Largest residual of a row in the last step."},
    {"violation", "m", "Largest violation of a joint."},
    {"stretch_error", "1", "Largest deviation of a line from its law, over its length."},
    {"natural_map", "1", "Largest relative residual of a contact's law."},
    {"contacts", "1", "Contact points of the last step."},
    {"step_time", "s", "Wall time of the last step.", true},
    {"solver_time", "s", "CPU time of the slowest thread in the last step's solver.", true},
    {"asleep", "1", "Bodies that sleep."},
    {"kinetic", "J", "Kinetic energy."},
    {"applied", "J", "Work done since the start by applied forces."},
    {"driven", "J", "Work done since the start by motors, winches and carriers."},
    {"dissipated", "J", "Energy dissipated since the start by drag."},
    {"friction", "J", "Energy dissipated since the start by friction of contacts."},
    {"contact", "J", "Energy dissipated since the start by contacts along their normals."},
    {"damped", "J", "Energy dissipated since the start by damping of interactions."},
    {"gravity", "J", "Potential energy of weights. Computing it needs a pass over the scene."},
    {"elastic", "J", "Energy of springs and lines. Computing it needs a pass over the scene."},
    {"mechanical", "J", "Kinetic, gravity and elastic. Computing it needs a pass over the scene."}};
constexpr OutputComponent kSignalComponents[] = {{"value", "", "In the unit of the signal."}};
static_assert(std::size(kStatisticComponents) == world::kMechanical + 1);
static_assert(std::size(kPoseComponents) == world::kQuaternion + 4);

constexpr OutputKindInfo kKinds[] = {
    {OutputKind::pose, "pose", OutputTarget::body, kPoseComponents,
     "Position of a point of a body and rotation of the body: about x, then y, then z of the world "
     "by roll, pitch and yaw."},
    {OutputKind::velocity, "velocity", OutputTarget::body, kVelocityComponents,
     "How fast a point of a body moves and the body turns, half a step before the state."},
    {OutputKind::coordinate, "coordinate", OutputTarget::interaction, kCoordinateComponents,
     "Angle or displacement of a joint, or of its limit, motor or friction; position of a scalar "
     "body."},
    {OutputKind::speed, "speed", OutputTarget::interaction, kSpeedComponents,
     "Rate of a coordinate, half a step before the state."},
    {OutputKind::motor_force, "motor_force", OutputTarget::interaction, kMotorForce,
     "Force or torque of a motor in the last step."},
    {OutputKind::force, "force", OutputTarget::interaction, kForceComponents,
     "Force of one row of an interaction in the last step."},
    {OutputKind::tension, "tension", OutputTarget::line, kTensionComponents,
     "Tension of a line in the last step: of one element or the largest of several."},
    {OutputKind::drum, "drum", OutputTarget::interaction, kDrumComponents,
     "Line that a drum has paid out, by its winch_stretch."},
    {OutputKind::distance, "distance", OutputTarget::two_bodies, kDistanceComponents,
     "Between a point of one body and a point of another."},
    {OutputKind::statistic, "statistic", OutputTarget::world, kStatisticComponents,
     "Of the whole world: how well it is solved, its energies, its times."},
    {OutputKind::signal, "signal", OutputTarget::system, kSignalComponents,
     "A number of a system that a program adds to a world."}};
static_assert(std::size(kKinds) == kOutputKindCount);

}  // namespace

std::span<const OutputKindInfo> output_kinds() noexcept { return kKinds; }

const OutputKindInfo& output_kind_info(OutputKind kind) noexcept {
    return kKinds[static_cast<std::size_t>(kind)];
}

const OutputKindInfo* find_output_kind(std::string_view name) noexcept {
    for (const OutputKindInfo& info : kKinds)
        if (name == info.name) return &info;
    return nullptr;
}

}  // namespace hawser
