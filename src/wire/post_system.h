// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file post_system.h
/// System of a bollard (hawser/post.h). Before each step it samples the contacts of the last step,
/// runs the guide of each engaged wire, and engages and disengages wires.
///
/// *When a contact engages.* A contact node is held by the tension of its wire alone. Its
/// transverse pull grows with the angle, and a step of h uses the angle at its start. With the
/// nodes' transverse speeds u and v, a and b away from the bollard, a step stretches the wire by
/// ```
///     ε = ((u h)²/2a + (v h)²/2b)/(a + b)
/// ```
/// The step does not account for this strain. The contact resolves the surface and stops the wire
/// first. The wire engages when ε < 1e-5.

#include <hawser/post.h>
#include <hawser/shapes.h>
#include <hawser/system.h>

#include "wire/guide_system.h"
#include "wire/room.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace hawser::wire {

/// Position of a bollard's shape in the frame of its body.
struct PostPosition {
    BodyId body{};
    Vec3 centre{0, 0, 0}, axis{0, 0, 1};     ///< [m], unit.
    double radius = 0.0, half_length = 0.0;  ///< [m]
    BodyId carrier{};                        ///< Body that carries engaged wires (add_post()).
    Vec3 carried_axis{0, 0, 1};              ///< The axis in the frame of the carrier.
};

class PostSystem final : public System, public PassedPost {
  public:
    PostSystem(PostDef def, const PostPosition& place);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<PostSystem>(def_, position_);
    }

    [[nodiscard]] bool carries(WireId wire) const noexcept override;
    [[nodiscard]] Separation separation(const World& world,
                                        const std::array<Vec3, 2>& line) const override;

  private:
    /// An element that touches the bollard.
    struct Touch {
        InteractionId element{};
        WireId wire{};
        Vec3 point{0, 0, 0};    ///< Nearest point of the axis, in the frame of the body [m].
        double fraction = 0.0;  ///< Fraction of the element nearest to the axis.
        double radius = 0.0;    ///< Distance from the axis, with the sign of GuideDef::radius [m].
        bool across_end = false;
        double along = 0.0;   ///< Speed past the surface, from its first end [m/s].
        double strain = 0.0;  ///< ε above.
    };
    [[nodiscard]] bool find(const World& world, ShapeId segment, Touch& out) const;
    void complete_touch(const World& world, double half, Touch& out) const;
    void engage_wires(NodeEdits& nodes);
    bool remove_node_at(NodeEdits& nodes, Touch& touch) const;
    bool engage_wire(NodeEdits& nodes, std::size_t slot, Touch touch);
    bool move_along_axis(NodeEdits& nodes, std::size_t slot) noexcept;
    [[nodiscard]] double along(const GuideSystem& guide) const noexcept;
    bool disengage(NodeEdits& nodes, std::size_t slot, bool reached_end);
    [[nodiscard]] bool must_disengage(const World& world, const GuideSystem& guide,
                                      bool& past) const;
    void report_signals() noexcept;

    PostDef def_;
    PostPosition position_;
    // State.
    std::vector<std::unique_ptr<GuideSystem>> guides_;  ///< By slot.
    std::vector<std::int32_t> occupied_;                ///< 1: a wire lies in the slot.
    std::int32_t steps_until_next_ = 0;                 ///< Steps until the next wire may engage.
    std::int32_t contact_samples_ = 0;  ///< Consecutive samples in which a wire has touched it.
    double engaged_count_ = 0.0, disengaged_count_ = 0.0, slid_length_ = 0.0;
    // Outputs.
    double held_count_ = 0.0, angle_ = 0.0, slide_ = 0.0, along_ = 0.0, tension_[2] = {};

    std::vector<ShapeId> pressing_;  ///< Scratch.
};

/// Add a bollard.
/// @param carrier  Body that carries engaged wires and along whose axis the body of the shape
///        slides, as a pin does through a deck. Wires keep their position on it and disengage when
///        the end of the shape has passed them. Invalid: the body of the shape.
/// @throws DefError
void add_post(World& world, const PostDef& def, BodyId carrier);

}  // namespace hawser::wire
