// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file changes.h
/// What is done to a world between its steps, told to whoever records it.
///
/// Everything that makes two runs of one scene differ passes through the functions of World: what
/// is added and removed, inputs, forces, poses, groups, restored states. A listener hears of each
/// call that was accepted, in order, with its arguments; repeated in another world in the same
/// state, the same calls give the same bits. A recording keeps them (docs/recording.md).
///
/// World::prepare() and what only reads are not told.

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

/// Told after a change has been made; references hold during the call. Must not change the world.
class ChangeListener {
  public:
    virtual ~ChangeListener() = default;
    virtual void added(const BodyDef& def) noexcept = 0;
    virtual void added(const InteractionDef& def) noexcept = 0;  ///< As given, not filled in.
    virtual void added(const ShapeDef& def) noexcept = 0;
    virtual void added(const InputDef& def) noexcept = 0;
    virtual void added(const MaterialDef& def) noexcept = 0;
    virtual void added(const MaterialPairDef& def) noexcept = 0;
    virtual void removed(BodyId id) noexcept = 0;  ///< What hangs on it went with it, untold.
    virtual void removed(InteractionId id) noexcept = 0;
    virtual void removed(ShapeId id) noexcept = 0;
    virtual void removed(InputId id) noexcept = 0;
    virtual void set(InputId id, double value) noexcept = 0;  ///< As asked for, before clamping.
    virtual void set_force(BodyId id, const Vec3& force, const Vec3& torque) noexcept = 0;
    virtual void set_pose(BodyId id, const Pose& pose) noexcept = 0;
    virtual void set_velocity(BodyId id, const Twist& twist) noexcept = 0;
    virtual void woken(BodyId id) noexcept = 0;
    virtual void set_group(BodyId id, const std::string& group) noexcept = 0;
    virtual void set_groups(int parts) noexcept = 0;
    virtual void follow_groups(int parts, int every) noexcept = 0;
    virtual void set_coupling(InteractionId id, Coupling coupling) noexcept = 0;
    virtual void degraded(const Degradation& degradation) noexcept = 0;
    /// A change could not be told for want of memory: what was told is not complete.
    virtual void lost() noexcept = 0;
    virtual void parted(InteractionId id) noexcept = 0;  ///< By part(), not by its load.
    /// @param mass  As it was given, NaN where it was not.
    virtual void node_inserted(InteractionId element, double share, double mass) noexcept = 0;
    virtual void node_removed(BodyId node, double bend) noexcept = 0;  ///< By remove_node().
    virtual void set_mass(BodyId lump, double mass) noexcept = 0;
    /// By World::lay_over() and lift_off(), definitions as given.
    virtual void laid_over(InteractionId element, const InteractionDef& before,
                           const InteractionDef& behind) noexcept = 0;
    virtual void lifted(InteractionId before, InteractionId behind,
                        const InteractionDef& element) noexcept = 0;
    /// By World::move_along(), where it moved.
    virtual void moved_along(InteractionId before, InteractionId behind, double along,
                             double fed) noexcept = 0;
    /// By World::cut(), whichever.
    virtual void cut(InteractionId element, double share) noexcept = 0;
    /// By join() and attach(). @param b  A lump, or a body with a point.
    virtual void joined(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) noexcept = 0;
    virtual void detached(InteractionId element, int end) noexcept = 0;
    virtual void released(InteractionId hook) noexcept = 0;  ///< By World::release().
    /// By restore(), or by copy_state() from a world whose save() this is.
    virtual void restored(std::span<const std::byte> bytes) noexcept = 0;
    /// By restore() of another structure. @param bytes  Its state.
    virtual void restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept = 0;
    /// Return a mark of the changes reported until now: a step begins, or a call that makes
    /// several.
    virtual std::size_t mark() noexcept = 0;
    /// That failed: changes reported since the mark are undone, and a replay must not make them.
    virtual void undone(std::size_t mark) noexcept = 0;
};

}  // namespace hawser
