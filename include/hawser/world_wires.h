// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_wires.h
/// Wires of a world, World::wires(): add, measure, cut, join and attach them, and edit their nodes.
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", .from = tug, .to = barge,
///                                               .EA = 80e6, .mass_per_length = 12.0});
/// const double tension = world.wires().tension(tow, 0.0);   // [N], after a step
/// ```
/// Terms, nodes and definitions: wire.h; edits: docs/wire_edits.md. An *end* is 0 (first) or 1
/// (last). A *material coordinate* s is the unstretched length from the first end [m]. Functions
/// throw DefError for an invalid id, and UseError for a world in use by another thread. A function
/// that throws changes nothing. Change listeners receive each edit, so that recordings repeat it
/// (changes.h).

#include <hawser/edits.h>
#include <hawser/facet.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>
#include <hawser/wire.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace hawser {

/// Reads the wires of a world.
class WorldWiresView : public Facet {
  public:
    explicit WorldWiresView(const World& world) noexcept : Facet(world) {}

    /// Return the ids of all wires, ascending; valid until an addition or removal.
    [[nodiscard]] std::span<const WireId> ids() const noexcept;
    /// Return the wire with this name; invalid: none.
    [[nodiscard]] WireId find(std::string_view name) const noexcept;
    /// Return the wire that an element belongs to; invalid: none.
    [[nodiscard]] WireId of(InteractionId element) const noexcept;
    [[nodiscard]] const std::string& name(WireId id) const;  ///< Name of a wire.
    /// Return the nodes from the first end to the last, including the bodies that hold the ends.
    /// Removed nodes stay in the list (World::alive()).
    [[nodiscard]] std::span<const BodyId> nodes(WireId id) const;
    /// Return the elements from the first end to the last, one fewer than nodes. Removed elements
    /// stay in the list.
    [[nodiscard]] std::span<const InteractionId> elements(WireId id) const;
    /// Return the unstretched length at the present drum coordinates [m].
    [[nodiscard]] double length(WireId id) const;
    /// Return the tension at a point of a wire in the last step, ≥ 0 [N]; 0: slack or broken.
    /// @param s  Material coordinate, 0 to length() [m].
    /// @throws DefError if s is outside this range.
    [[nodiscard]] double tension(WireId id, double s) const;
    /// Return the end points of an element, world frame [m]: where it leaves its first two bodies.
    /// At a wheel this is the tangent point.
    [[nodiscard]] std::array<Vec3, 2> ends(InteractionId element) const;
    /// Return the angles on the wheels at both ends of an element [rad]: from the reference mark of
    /// the wheel to the tangent point, whole turns included. 0: no wheel.
    [[nodiscard]] std::array<double, 2> wrapped(InteractionId element) const;
    /// Return the number of coming steps in which the transverse vibration of an element's wire has
    /// additional damping. It is applied after a step in which the wire would have gained energy
    /// (StepStats::wire_repeats). 0: none, or the element is in no wire.
    [[nodiscard]] int damped_steps(InteractionId element) const;

    // Old uses of World::wires() as a list.
    [[deprecated("use wires().ids()")]] operator std::span<const WireId>() const noexcept {
        return ids();
    }
    [[deprecated("use wires().ids()")]] auto begin() const noexcept { return ids().begin(); }
    [[deprecated("use wires().ids()")]] auto end() const noexcept { return ids().end(); }
    [[deprecated("use wires().ids()")]] std::size_t size() const noexcept { return ids().size(); }
    [[deprecated("use wires().ids()")]] bool empty() const noexcept { return ids().empty(); }
    [[deprecated("use wires().ids()")]] WireId front() const noexcept { return ids().front(); }
    [[deprecated("use wires().ids()")]] WireId back() const noexcept { return ids().back(); }
    [[deprecated("use wires().ids()")]] WireId operator[](std::size_t index) const noexcept {
        return ids()[index];
    }
};

/// Reads and edits the wires of a world.
class WorldWires : public WorldWiresView {
  public:
    explicit WorldWires(World& world) noexcept;

    /// Add a wire with its nodes, elements, bends and segments, all or none. The wire owns them.
    /// @throws DefError on invalid values or a name in use, std::bad_alloc.
    WireId add(const WireDef& def);
    /// Create a wire from existing elements. It does not own them: remove() keeps them.
    /// @param elements  Elements from end to end.
    /// @param trim  Properties of elements that are inserted later.
    /// @throws DefError on an empty or used name, or elements that do not follow each other.
    WireId adopt(const std::string& name, std::span<const InteractionId> elements,
                 const WireTrim& trim = {});
    /// Remove a wire with the nodes, elements, bends and shapes that it owns.
    /// @return the removed objects; valid until the next removal.
    const Removed& remove(WireId id);

    /// Insert a node on an element (wire.h, "Nodes").
    /// @param share  Fraction of the element's length from its first body, 0 to 1.
    /// @param mass  Mass of an element at a drum, if it has no parameter `mass` [kg].
    /// @return the inserted node.
    /// @throws DefError if no node can be inserted, std::bad_alloc.
    BodyId insert_node(InteractionId element, double share, double mass = kDefault);
    /// Remove a node that only two elements and bends hold (wire.h, "Nodes"). The first element
    /// then extends to the next node.
    /// @param bend  Largest angle between the elements [rad]. π: only an increase of energy
    /// prevents
    ///        the removal.
    /// @return true if it was removed; false without a change.
    /// @throws DefError if the body is no such node.
    bool remove_node(BodyId node, double bend = 0.05);
    /// Set the mass of a node. Its drag and applied force are multiplied by the same factor.
    /// @param mass  Mass [kg], > 0.
    void set_mass(BodyId node, double mass);

    /// Break the element at a point of a wire, with the event `line_break`. Its elastic energy
    /// counts as damped (Energy). No effect if it is broken already.
    /// @param s  Material coordinate, 0 to length() [m].
    void part(WireId id, double s);
    /// Break an element.
    /// @throws DefError if the interaction is no element of a line.
    void part(InteractionId element);
    /// Cut a wire into two. The node at the cut is divided into two nodes with equal position and
    /// velocity. If a node can be inserted in the element at s, this is done first; otherwise the
    /// nearest node between two elements is divided. The bend at the cut is removed, and its energy
    /// counts as edited (Energy). Event `cut` of the element before the cut, with its tension [N].
    /// @param s  Material coordinate, 0 < s < length() [m].
    /// @return the second piece, a new wire "name/2", "name/3", ….
    /// @throws DefError at an end, or if no node near the cut can be divided.
    WireId cut(WireId id, double s);
    /// Cut at an element, inside or outside wires.
    /// @param share  Fraction of its length from its first body, 0 ≤ share < 1.
    /// @return the second piece; invalid if the element is in no wire.
    WireId cut(InteractionId element, double share);
    /// Connect two free ends by gear, or unite two wires by a splice (Gear). Event `join` of the
    /// link or joint, or of the element before a splice, with the distance of the ends [m].
    /// @param end_a, end_b  0 (first) or 1 (last).
    /// @throws DefError on an end that is not free, or ends too far apart (JoinDef::reach).
    Joint join(WireId a, int end_a, WireId b, int end_b, const JoinDef& def = {});
    /// Connect a free end, given by its node, to another free end or to a body.
    /// @param a  Node of the free end.
    /// @param b  Node of the other end, or a body.
    /// @param point  Point in the frame of the body b [m].
    Joint join(BodyId a, BodyId b, const Vec3& point, const JoinDef& def);
    /// Connect a free end to a body, by gear or rigidly. The end is not moved. Event `join`.
    /// @param point  Point in the frame of the body [m].
    Joint attach(WireId id, int end, BodyId body, const Vec3& point, const JoinDef& def = {});
    /// Release an end from gear or from a body. If the body itself is the end, the wire gets a node
    /// with the mass of the half element at this end. At a drum the element becomes a stretch of
    /// equal length, and the wire on the drum is separated. Event `detach` of the element at the
    /// end, with its tension [N].
    /// @param end  0 (first) or 1 (last).
    void detach(WireId id, int end);
    /// Release an end of an element.
    void detach(InteractionId element, int end);
    /// Open a pelican hook. Event `release` of the hook, with its tension [N].
    /// @throws DefError if the interaction is no pelican hook.
    void release(InteractionId hook);

    /// Connect the element at an end of a wire to a drum, which then pays it out. Its rest length
    /// is the present one plus radius × (coordinate − present coordinate). Friction loads by this
    /// element are removed, and its nodes lose their halves of its mass.
    /// @param end  0 (first) or 1 (last).
    /// @param drum  Scalar body.
    /// @param radius  Length paid out per unit of the drum's coordinate [m]; negative: a positive
    ///        coordinate hauls in.
    /// @return the element at the drum, which replaces the old one.
    /// @throws DefError if the element is on a drum, removed or broken, or if the drum is not a
    /// scalar
    ///        body.
    InteractionId spool(WireId id, int end, BodyId drum, double radius);
    /// Divide an element at a turning point into two parts of kind end_span (guide.h).
    /// @param before, behind  Definitions of the parts, plan_guide().
    /// @return the parts before and behind the turning point.
    /// @throws DefError if the element is on a drum, removed or broken, or if the parts do not fit
    /// it.
    std::array<InteractionId, 2> engage(InteractionId element, InteractionDef before,
                                        const InteractionDef& behind);
    /// Replace the two parts of a wire at a guide or bollard, made by engage(), by one element.
    /// @param before, behind  The parts.
    /// @param element  Definition of the element.
    /// @return the element.
    /// @throws DefError if the interactions are no such parts, or if the element does not fit them.
    InteractionId disengage(InteractionId before, InteractionId behind, InteractionDef element);
    /// Move the contact point of two parts of engage() along the axis of their wheel.
    /// @param along  Distance along the axis [m].
    /// @param fed  Rest length that passes from the part behind to the part before [m].
    /// @return true if it moved; false without a change if the energy would grow.
    /// @throws DefError for an eye, and if a part is too short.
    bool move_along(InteractionId before, InteractionId behind, double along, double fed);
};

}  // namespace hawser
