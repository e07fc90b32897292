// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file changes.h
/// Listener for changes of a world between its steps (World::set_change_listener()).
///
/// A *change* is a call of a function of World that modifies it: an addition or removal, an input,
/// a force, a pose, a group, a restored state. Two runs of one scene differ only by their changes.
/// A listener receives each accepted change in order, with its arguments. The same changes in
/// another world of equal state lead to equal bits. A recording stores them (docs/recording.md).
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

/// Interface that receives each change after the world has made it. References are valid during the
/// call. A listener must not change the world.
class ChangeListener {
  public:
    virtual ~ChangeListener() = default;
    /// Receive an added object with its definition as the caller gave it, without filled-in
    /// defaults.
    virtual void added(const BodyDef& def) noexcept = 0;
    virtual void added(const InteractionDef& def) noexcept = 0;
    virtual void added(const ShapeDef& def) noexcept = 0;
    virtual void added(const InputDef& def) noexcept = 0;
    virtual void added(const MaterialDef& def) noexcept = 0;
    virtual void added(const MaterialPairDef& def) noexcept = 0;
    /// Receive the removal of an object. Attached objects that are removed with it are not
    /// reported.
    virtual void removed(BodyId id) noexcept = 0;
    virtual void removed(InteractionId id) noexcept = 0;
    virtual void removed(ShapeId id) noexcept = 0;
    virtual void removed(InputId id) noexcept = 0;
    /// Receive a call of World::set_input() with the requested value, before clamping.
    virtual void set(InputId id, double value) noexcept = 0;
    /// Receive a call of World::set_force().
    virtual void set_force(BodyId id, const Vec3& force, const Vec3& torque) noexcept = 0;
    /// Receive a call of World::set_pose().
    virtual void set_pose(BodyId id, const Pose& pose) noexcept = 0;
    /// Receive a call of World::set_velocity().
    virtual void set_velocity(BodyId id, const Twist& twist) noexcept = 0;
    /// Receive a call of World::wake().
    virtual void woken(BodyId id) noexcept = 0;
    /// Receive a call of WorldSplits::set_group().
    virtual void set_group(BodyId id, const std::string& group) noexcept = 0;
    /// Receive a call of WorldSplits::set_groups().
    virtual void set_groups(int parts) noexcept = 0;
    /// Receive a call of WorldSplits::follow_groups().
    virtual void follow_groups(int parts, int every) noexcept = 0;
    /// Receive a call of WorldSplits::set_coupling().
    virtual void set_coupling(InteractionId id, Coupling coupling) noexcept = 0;
    /// Receive a call of WorldSolver::degrade_next_step().
    virtual void degraded(const Degradation& degradation) noexcept = 0;
    /// Receive the notice that changes were lost because allocation failed. A list of changes is
    /// then incomplete.
    virtual void lost() noexcept = 0;
    /// Receive a call of WorldWires::part(). Elements that break by overload are not reported.
    virtual void parted(InteractionId id) noexcept = 0;
    /// Receive a call of WorldWires::insert_node().
    /// @param mass  Mass as given; NaN: the default.
    virtual void node_inserted(InteractionId element, double share, double mass) noexcept = 0;
    /// Receive a call of WorldWires::remove_node() that removed the node.
    virtual void node_removed(BodyId node, double bend) noexcept = 0;
    /// Receive a call of WorldWires::set_mass().
    virtual void set_mass(BodyId lump, double mass) noexcept = 0;
    /// Receive a call of WorldWires::engage(), with definitions as given.
    virtual void laid_over(InteractionId element, const InteractionDef& before,
                           const InteractionDef& behind) noexcept = 0;
    /// Receive a call of WorldWires::disengage(), with the definition as given.
    virtual void lifted(InteractionId before, InteractionId behind,
                        const InteractionDef& element) noexcept = 0;
    /// Receive a call of WorldWires::move_along() that moved the parts.
    virtual void moved_along(InteractionId before, InteractionId behind, double along,
                             double fed) noexcept = 0;
    /// Receive a call of any form of WorldWires::cut(), converted to the cut of an element.
    /// @param share  Position of the cut as a fraction of the element length from its first end.
    virtual void cut(InteractionId element, double share) noexcept = 0;
    /// Receive a call of WorldWires::join() and attach().
    /// @param a  Node of the free end.
    /// @param b  Node of the other end, or a body.
    /// @param point  Point in the frame of the body b [m].
    virtual void joined(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) noexcept = 0;
    /// Receive a call of any form of WorldWires::detach(), converted to the detachment of an
    /// element. @param end  Detached end of the element, 0 or 1.
    virtual void detached(InteractionId element, int end) noexcept = 0;
    /// Receive a call of WorldWires::release().
    virtual void released(InteractionId hook) noexcept = 0;
    /// Receive a restored state: a call of WorldState::restore(), or of copy_from() a world whose
    /// save() returns these bytes.
    virtual void restored(std::span<const std::byte> bytes) noexcept = 0;
    /// Receive a call of WorldState::restore() with another structure.
    /// @param bytes  State of the structure.
    virtual void restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept = 0;
    /// Return a mark of the changes reported until now. The world calls it at the start of each
    /// step, and of each function that makes several changes.
    virtual std::size_t mark() noexcept = 0;
    /// Receive the notice that a step or function failed and its changes are undone. A replay must
    /// omit all changes that were reported since the mark.
    virtual void undone(std::size_t mark) noexcept = 0;
};

}  // namespace hawser
