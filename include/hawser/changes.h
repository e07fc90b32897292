// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file changes.h
/// Listener for changes of a world between its steps.
///
/// All differences between two runs of one scene enter by functions of World: additions and
/// removals, inputs, forces, poses, groups, restored states. A listener receives each accepted call
/// in order with its arguments. The same calls in another world with the same state give the same
/// bits. A recording stores them (docs/recording.md).
///
/// Limits: World::prepare() and functions that only read are not reported.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/shapes.h>
#include <hawser/stats.h>
#include <hawser/wire.h>

#include <cstddef>
#include <span>
#include <string>

namespace hawser {

struct Structure;  // structure.h

/// Receives each change after it has been made. References are valid during the call. It must not
/// change the world.
class ChangeListener {
  public:
    virtual ~ChangeListener() = default;
    virtual void added(const BodyDef& def) noexcept = 0;
    virtual void added(const InteractionDef& def) noexcept = 0;  ///< As given, without defaults.
    virtual void added(const ShapeDef& def) noexcept = 0;
    virtual void added(const InputDef& def) noexcept = 0;
    virtual void added(const MaterialDef& def) noexcept = 0;
    virtual void added(const MaterialPairDef& def) noexcept = 0;
    /// Report the removal of an object. Attached objects, removed with it, are not reported.
    virtual void removed(BodyId id) noexcept = 0;
    virtual void removed(InteractionId id) noexcept = 0;
    virtual void removed(ShapeId id) noexcept = 0;
    virtual void removed(InputId id) noexcept = 0;
    /// Report the requested value of an input before clamping.
    virtual void set(InputId id, double value) noexcept = 0;
    virtual void set_force(BodyId id, const Vec3& force, const Vec3& torque) noexcept = 0;
    virtual void set_pose(BodyId id, const Pose& pose) noexcept = 0;
    virtual void set_velocity(BodyId id, const Twist& twist) noexcept = 0;
    virtual void woken(BodyId id) noexcept = 0;
    virtual void set_group(BodyId id, const std::string& group) noexcept = 0;
    virtual void set_groups(int parts) noexcept = 0;
    virtual void follow_groups(int parts, int every) noexcept = 0;
    virtual void set_coupling(InteractionId id, Coupling coupling) noexcept = 0;
    virtual void degraded(const Degradation& degradation) noexcept = 0;
    /// Report that a change is missing because allocation failed. The list of changes is then
    /// incomplete.
    virtual void lost() noexcept = 0;
    virtual void parted(InteractionId id) noexcept = 0;  ///< By part(), not by overload.
    /// Report WorldWires::insert_node().
    /// @param mass  As given; NaN if it was left out.
    virtual void node_inserted(InteractionId element, double share, double mass) noexcept = 0;
    virtual void node_removed(BodyId node, double bend) noexcept = 0;  ///< By remove_node().
    virtual void set_mass(BodyId lump, double mass) noexcept = 0;
    /// Report WorldWires::engage() and disengage(), with definitions as given.
    virtual void laid_over(InteractionId element, const InteractionDef& before,
                           const InteractionDef& behind) noexcept = 0;
    virtual void lifted(InteractionId before, InteractionId behind,
                        const InteractionDef& element) noexcept = 0;
    /// Report WorldWires::move_along() if it moved.
    virtual void moved_along(InteractionId before, InteractionId behind, double along,
                             double fed) noexcept = 0;
    /// Report all forms of WorldWires::cut().
    virtual void cut(InteractionId element, double share) noexcept = 0;
    /// Report WorldWires::join() and attach().
    /// @param b  A node, or a body with a point.
    virtual void joined(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) noexcept = 0;
    virtual void detached(InteractionId element, int end) noexcept = 0;
    virtual void released(InteractionId hook) noexcept = 0;  ///< By WorldWires::release().
    /// Report WorldState::restore(), or copy_from() a world whose save() returns these bytes.
    virtual void restored(std::span<const std::byte> bytes) noexcept = 0;
    /// Report restore() of another structure.
    /// @param bytes  Its state.
    virtual void restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept = 0;
    /// Return a mark of the changes reported until now. Called at the start of a step, or of a call
    /// that makes several.
    virtual std::size_t mark() noexcept = 0;
    /// Report a failure: changes since the mark are undone, and a replay must not make them.
    virtual void undone(std::size_t mark) noexcept = 0;
};

}  // namespace hawser
