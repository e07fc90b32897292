// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file changes.h
/// Changes of a world as bytes of a recording, and their repetition.

#include "record/bytes.h"

#include <hawser/hawser.h>

#include <cstddef>
#include <span>
#include <string>

namespace hawser::record {

/// Writes the changes that a world reports (hawser/changes.h). A change that does not fit into
/// memory is lost, and failed() returns true from then on.
class ChangeBytes : public ChangeListener {
  public:
    void added(const BodyDef& def) noexcept override;
    void added(const InteractionDef& def) noexcept override;
    void added(const ShapeDef& def) noexcept override;
    void added(const InputDef& def) noexcept override;
    void added(const MaterialDef& def) noexcept override;
    void added(const MaterialPairDef& def) noexcept override;
    void removed(BodyId id) noexcept override;
    void removed(InteractionId id) noexcept override;
    void removed(ShapeId id) noexcept override;
    void removed(InputId id) noexcept override;
    void set(InputId id, double value) noexcept override;
    void set_force(BodyId id, const Vec3& force, const Vec3& torque) noexcept override;
    void set_pose(BodyId id, const Pose& pose) noexcept override;
    void set_velocity(BodyId id, const Twist& twist) noexcept override;
    void woken(BodyId id) noexcept override;
    void set_group(BodyId id, const std::string& group) noexcept override;
    void set_groups(int parts) noexcept override;
    void follow_groups(int parts, int every) noexcept override;
    void set_coupling(InteractionId id, Coupling coupling) noexcept override;
    void degraded(const Degradation& degradation) noexcept override;
    void lost() noexcept override { failed_ = true; }
    void parted(InteractionId id) noexcept override;
    void node_inserted(InteractionId element, double share, double mass) noexcept override;
    void node_removed(BodyId node, double bend) noexcept override;
    void laid_over(InteractionId element, const InteractionDef& before,
                   const InteractionDef& behind) noexcept override;
    void lifted(InteractionId before, InteractionId behind,
                const InteractionDef& element) noexcept override;
    void moved_along(InteractionId before, InteractionId behind, double along,
                     double fed) noexcept override;
    void set_mass(BodyId lump, double mass) noexcept override;
    void cut(InteractionId element, double share) noexcept override;
    void joined(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) noexcept override;
    void detached(InteractionId element, int end) noexcept override;
    /// Report a released end whose element has its mass from a system (System::carried_mass())
    /// [kg].
    void detached_with_mass(InteractionId element, int end, double mass) noexcept;
    void released(InteractionId hook) noexcept override;
    void restored(std::span<const std::byte> bytes) noexcept override;
    void restored(const Structure& made_of, std::span<const std::byte> bytes) noexcept override;
    std::size_t mark() noexcept override { return out_.bytes().size(); }
    /// Remove the changes recorded after a mark, because the world has undone them. Flags that
    /// bodies have changed remain set.
    void undone(std::size_t mark) noexcept override { out_.truncate(mark); }

    /// Return all changes since the last clear(), in order.
    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return out_.bytes(); }
    /// True if bodies were added, removed or restored: frames have another layout from now on.
    [[nodiscard]] bool bodies_changed() const noexcept { return bodies_changed_; }
    [[nodiscard]] bool failed() const noexcept { return failed_; }
    void clear() noexcept;

  protected:
    /// Reset the failure, because the change that did not fit was undone.
    void forget_failure() noexcept { failed_ = false; }

  private:
    template <class F>
    void write(F&& fields) noexcept;

    ByteWriter out_;
    bool bodies_changed_ = false, failed_ = false;
};

/// Apply recorded changes to a world in the state in which they were recorded.
/// @throws BadBytes if the bytes are not from ChangeBytes, DefError if the world rejects a change.
void apply_changes(std::span<const std::byte> bytes, World& world);

}  // namespace hawser::record
