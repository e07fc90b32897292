// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_wires.h
/// Wires of a world: World::wires().
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", .from = tug, .to = barge,
///                                               .EA = 80e6, .mass_per_length = 12.0});
/// const double tension = world.wires().tension(tow, 0.0);   // [N], after a step
/// ```
/// Terms, nodes and definitions: wire.h; edits: docs/wire_edits.md. Functions throw DefError for an
/// invalid id, and UseError for a world in use by another thread. A function that throws changes
/// nothing. Change listeners receive each edit, so that recordings repeat it (changes.h).

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
    /// Return the wire of a name; invalid: none.
    [[nodiscard]] WireId find(std::string_view name) const noexcept;
    /// Return the wire of an element; invalid: none.
    [[nodiscard]] WireId of(InteractionId element) const noexcept;
    [[nodiscard]] const std::string& name(WireId id) const;
    /// Return the bodies from end to end, with those that hold the ends. Removed ones stay in the
    /// list (World::alive()).
    [[nodiscard]] std::span<const BodyId> nodes(WireId id) const;
    /// Return the elements from end to end, one less than nodes.
    [[nodiscard]] std::span<const InteractionId> elements(WireId id) const;
    /// Return the unstretched length at the present drum coordinates [m].
    [[nodiscard]] double length(WireId id) const;
    /// Return the tension in the last step, ≥ 0 [N]; 0: slack or broken.
    /// @param s  Material coordinate, 0 to length() [m].
    /// @throws DefError beyond.
    [[nodiscard]] double tension(WireId id, double s) const;
    /// Return the points where an element leaves its first two bodies, world frame; for a wheel the
    /// tangent point [m].
    [[nodiscard]] std::array<Vec3, 2> ends(InteractionId element) const;
    /// Return the angle on the wheel at each end beyond the defined one, turns included [rad].
    [[nodiscard]] std::array<double, 2> wrapped(InteractionId element) const;
    /// Return the number of coming steps with more damping of the transverse vibration of an
    /// element's wire. The reason is energy that it would have gained (StepStats::wire_repeats). 0:
    /// none, or not a wire.
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

    /// Add nodes, elements, bends and segments of a wire, all or none. The wire owns them.
    /// @throws DefError on invalid values or a name in use, std::bad_alloc.
    WireId add(const WireDef& def);
    /// Create a wire from existing elements, end to end, which it does not own.
    /// @throws DefError on an empty or used name, elements that do not follow each other.
    WireId adopt(const std::string& name, std::span<const InteractionId> elements,
                 const WireTrim& trim = {});
    /// Remove a wire with the objects of add().
    /// @return the removed objects; valid until the next removal.
    const Removed& remove(WireId id);

    /// Insert a node on an element (wire.h, "Nodes").
    /// @param share  Fraction of the element's length from its first body, 0 to 1.
    /// @param mass  Mass of an element at a drum without the parameter `mass` [kg].
    /// @return the node.
    /// @throws DefError if no node can be inserted, std::bad_alloc.
    BodyId insert_node(InteractionId element, double share, double mass = kDefault);
    /// Remove a node that only two elements and bends hold.
    /// @param bend  Largest angle between the elements [rad]. π: only an increase of energy is
    ///        rejected.
    /// @return true if it was removed; false without a change.
    /// @throws DefError if the body is no such node.
    bool remove_node(BodyId node, double bend = 0.05);
    /// Set the mass of a node [kg], > 0; drag and applied force scale with it.
    void set_mass(BodyId node, double mass);

    /// Break an element, with an event; its energy counts as damped (Energy). No effect on a broken
    /// element.
    /// @param s  Material coordinate, 0 to length() [m].
    void part(WireId id, double s);
    void part(InteractionId element);  ///< @throws DefError for other kinds.
    /// Cut a wire at 0 < s < length() [m]. The node there becomes two with equal position and
    /// velocity. If nodes may be inserted in the element at s, one is inserted first; otherwise the
    /// nearest node between elements is divided. The bend there is removed and its energy counts as
    /// input energy. Event `cut`: the element before the cut, its tension [N].
    /// @return the second piece, a new wire "name/2", "name/3", ….
    /// @throws DefError at an end, or if no node there can be divided.
    WireId cut(WireId id, double s);
    /// Cut at an element, inside or outside wires.
    /// @param share  Fraction of its length from its first body, 0 ≤ share < 1.
    /// @return the second piece; invalid if the element is in no wire.
    WireId cut(InteractionId element, double share);
    /// Connect two free ends by gear, or unite two wires by a splice (Gear). Event `join`: the link
    /// or joint, or the element before a splice; the distance of the ends [m].
    /// @param end_a, end_b  0 (first) or 1 (last).
    /// @throws DefError on an end that is not free, or ends too far apart (JoinDef::reach).
    Joint join(WireId a, int end_a, WireId b, int end_b, const JoinDef& def = {});
    /// Connect a free end, given by its node, to another or to a point in the frame of a body [m].
    Joint join(BodyId a, BodyId b, const Vec3& point, const JoinDef& def);
    /// Connect a free end to a point in the frame of a body [m], by gear or rigidly; the end is not
    /// moved. Event `join`.
    Joint attach(WireId id, int end, BodyId body, const Vec3& point, const JoinDef& def = {});
    /// Release an end from gear or from a body. An end on a body without its own node gets a node
    /// with the mass of the half element there. At a drum (WinchStretch) the wire continues as a
    /// Stretch of equal length; wire on the drum is separated. Event `detach`: the element at the
    /// end, its tension [N].
    /// @param end  0 (first) or 1 (last).
    void detach(WireId id, int end);
    void detach(InteractionId element, int end);
    /// Open a pelican hook. Event `release`: the hook, its tension [N].
    /// @throws DefError if it is not one.
    void release(InteractionId hook);

    /// Let a drum pay out the first (0) or last (1) element of a wire: length + radius (coordinate
    /// − present coordinate) [m]. Loads of friction by it end, and nodes lose their halves of its
    /// mass.
    /// @param radius  Radius of the drum [m]; negative: a positive coordinate hauls in.
    /// @return the new element at the drum.
    /// @throws DefError if it is on a drum, removed or broken, or the drum is not a scalar body.
    InteractionId spool(WireId id, int end, BodyId drum, double radius);
    /// Divide an element at a turning point into two of kind end_span (guide.h).
    /// @return the parts before and behind the turning point.
    /// @throws DefError if it is on a drum, removed or broken, or the parts do not fit it.
    std::array<InteractionId, 2> engage(InteractionId element, InteractionDef before,
                                        const InteractionDef& behind);
    /// Unite two parts of engage() to one element.
    /// @return the element.
    /// @throws DefError if they are no such parts, or the element does not fit them.
    InteractionId disengage(InteractionId before, InteractionId behind, InteractionDef element);
    /// Move two parts of engage() along the axis of their wheel by `along` [m]. A rest length `fed`
    /// [m] passes from the part behind to the part before.
    /// @return false without changes if the energy would grow.
    /// @throws DefError for an eye, and if a part is too short.
    bool move_along(InteractionId before, InteractionId behind, double along, double fed);
};

}  // namespace hawser
