// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file post_system.h
/// What a post does before each step begins (hawser/post.h): it looks at what the last step's
/// contacts were, has the guide of each wire that lies on it act, and takes and lets go of wires.
///
/// *When a contact is taken.* A contact node bears by the tension of its wire alone, whose pull
/// across grows with the angle, and a step of h sees the angle that it begins with. With the nodes'
/// speeds u and v across, a and b away from the post, a step stretches the wire by
/// ```
///     ε = ((u h)²/2a + (v h)²/2b)/(a + b)
/// ```
/// of which it knew nothing. The contact, which knows the surface, stops the wire first: it is
/// taken once ε is below 1e-5.

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

/// Where a post's shape is, in the frame of its body.
struct PostPlace {
    BodyId body{};
    Vec3 centre{0, 0, 0}, axis{0, 0, 1};     ///< [m], unit.
    double radius = 0.0, half_length = 0.0;  ///< [m]
    BodyId carrier{};                        ///< That bears wires which lie on it (add_post()).
    Vec3 carried_axis{0, 0, 1};              ///< The axis in its frame.
};

class PostSystem final : public System, public PassedPost {
  public:
    PostSystem(PostDef def, const PostPlace& place);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<PostSystem>(def_, place_);
    }

    [[nodiscard]] bool has(WireId wire) const noexcept override;
    [[nodiscard]] Apart apart(const World& world, const std::array<Vec3, 2>& line) const override;

  private:
    /// An element that touches the post.
    struct Touch {
        InteractionId element{};
        WireId wire{};
        Vec3 point{0, 0, 0};  ///< Of the axis next to it, in the frame of the body [m].
        double share = 0.0;   ///< Of the element, where it is next to the axis.
        double radius = 0.0;  ///< From the axis, with the sign of GuideDef::radius [m].
        bool across_end = false;
        double along = 0.0;   ///< Speed past the surface, from its first end [m/s].
        double strain = 0.0;  ///< ε above.
    };
    [[nodiscard]] bool find(const World& world, ShapeId segment, Touch& out) const;
    void place_touch(const World& world, double half, Touch& out) const;
    void take(NodeEdits& nodes);
    bool take_lump(NodeEdits& nodes, Touch& touch) const;
    bool take(NodeEdits& nodes, std::size_t slot, Touch touch);
    bool slide(NodeEdits& nodes, std::size_t slot) noexcept;
    [[nodiscard]] double along(const GuideSystem& guide) const noexcept;
    bool let_go(NodeEdits& nodes, std::size_t slot, bool off_end);
    [[nodiscard]] bool pulls(const World& world, const GuideSystem& guide, bool& past) const;
    void tell() noexcept;

    PostDef def_;
    PostPlace place_;
    // State.
    std::vector<std::unique_ptr<GuideSystem>> guides_;  ///< By slot.
    std::vector<std::int32_t> on_;                      ///< 1 where a wire lies in a slot.
    std::int32_t wait_ = 0;                             ///< Steps until it takes anything again.
    std::int32_t steady_ = 0;  ///< Looks running at which a wire has touched it.
    double taken_ = 0.0, let_go_ = 0.0, slid_ = 0.0;
    // Outputs.
    double held_ = 0.0, angle_ = 0.0, slide_ = 0.0, along_ = 0.0, tension_[2] = {};

    std::vector<ShapeId> pressing_;  ///< Memory.
};

/// Adds a post. @param carrier  That bears wires which lie on it, and on which the body of the
/// shape slides along the axis, as a pin does through a deck: wires keep their place on it, and are
/// let go where the shape's end has gone past them. Invalid: the body of the shape. @throws
/// DefError
void add_post(World& world, const PostDef& def, BodyId carrier);

}  // namespace hawser::wire
