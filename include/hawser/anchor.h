// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchor.h
/// Drag-embedment anchors: the horizontal force that soil can exert on an anchor (holding
/// capacity). It grows with the distance by which the anchor has been dragged, and decreases with
/// the angle of the line above the seabed.
///
/// ```cpp
/// world.add(hawser::AnchorDef{.name = "anchor", .body = anchor, .soil = hawser::AnchorSoil::sand,
///                             .type = hawser::AnchorType::stevpris_mk6, .fluke_length = 4.0,
///                             .drag = 30.0, .set = true});
/// world.system_signal("anchor.capacity");      // [N]
/// ```
/// *Capacity.* The capacity H along the line depends on the drag distance x and the line angle θ
/// above the horizontal. UHC is the ultimate holding capacity, W the submerged weight:
/// ```
///     H(x, θ) = max(UHC g(x) f(θ), μ W)        g(x) = g₀ + (1 − g₀)(1 − e^(−x/ℓ))
///     f: 1 at 0°, 0.75 at 5°, 0.5 at 15°, 0 at 45°; linear between
/// ```
/// With AnchorLaw::trajectory the capacity T(z(x)) of an anchor that dives in clay replaces UHC
/// g(x) (C. P. Aubeny, C. Chi, "Mechanics of drag embedment anchors in a soft seabed", J. Geotech.
/// Geoenviron. Eng. 136, 2010). z is the depth, s_u the undrained shear strength:
/// ```
///     T = N_e s_u(z) A_f     s_u = s_u0 + k z     dz/dx = tan(θ_f0 − θ_a)
///     θ_a = √(2 E_n N_c b z (s_u0 + k z/2)/T)
/// ```
/// *Chain in soil.* The part of the chain in the soil has the bearing width b and leads from the
/// depth z to the seabed. It multiplies the capacity by e^(μ_c (θ_a − θ)) for θ < θ_a. Here θ_a² =
/// θ² + 2 E_n N_c b z (s_u0 + k z/2)/T (S. R. Neubecker, M. F. Randolph, "Profile and frictional
/// capacity of embedded anchor chains", J. Geotech. Eng. 121, 1995).
///
/// *Rows.* Three slide_friction interactions, NAME/x, NAME/y and NAME/z, exert the force of the
/// soil at the point of the anchor. The system sets their bounds in each step, so that an anchor
/// below its capacity does not creep. Three hinge_friction interactions, NAME/rx, NAME/ry and
/// NAME/rz, keep its attitude. The drag x increases only while the rows slide at their bounds; it
/// remains on unloading.
///
/// *Setting and breakout.* A free anchor on the seabed has the friction μ W. It becomes set when it
/// has been dragged by `set_after` at θ ≤ 45°. A set anchor breaks out, and its drag x becomes 0,
/// if the vertical force on it exceeds V_b = `breakout` UHC g(x), or if θ > 45°.
///
/// Outputs, as "name.signal":
/// - `drag`: drag x [m]; `depth`: depth of the point below the seabed by the law [m];
/// - `capacity`: H [N]; `breakout`: V_b [N]; `utilisation`: tension over capacity [1];
/// - `tension` [N], `line_angle` [rad] of the line at the anchor; `set`: 1 if set, else 0.
///
/// Events of the body: `join` when it becomes set, with the drag until then [m]; `render` when it
/// begins to drag, and `detach` when it breaks out, with the tension [N].
///
/// Limits and sources: docs/anchors.md.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

class World;
class System;

/// Soil of the seabed.
enum class AnchorSoil : std::uint8_t {
    none,       ///< Not given; rejected.
    soft_clay,  ///< Very soft clay, mud.
    medium_clay,
    sand,  ///< Sand and hard clay.
};
/// Type of an anchor, with its published capacity by mass.
enum class AnchorType : std::uint8_t {
    given,         ///< AnchorDef::uhc.
    stevpris_mk6,  ///< Vryhof.
    stevpris,      ///< NCEL TDS 83-08R, as the following.
    bruce_twin_shank,
    bruce_cast,
    danforth,
    navmoor,
    stato,
    stevmud,
    stevin,
    stockless_fixed,
    stockless_movable,
};
/// Law of the capacity by the drag distance: UHC g(x), or T(z(x)) of an anchor that dives in clay.
enum class AnchorLaw : std::uint8_t { exponential, trajectory };

/// Return the names of soils, and of anchor types, in the order of AnchorSoil and AnchorType. Scene
/// files use these names.
[[nodiscard]] std::span<const char* const> anchor_soils() noexcept;
[[nodiscard]] std::span<const char* const> anchor_types() noexcept;

/// Clay around an anchor and its chain.
struct AnchorClay {
    double strength = 0.0;                    ///< Undrained shear strength at the seabed s_u0 [Pa].
    double gradient = 0.0;                    ///< Its gradient k with depth [Pa/m].
    double fluke_area = 0.0;                  ///< A_f [m²]. Required by AnchorLaw::trajectory.
    double bearing = 9.0;                     ///< N_e of the anchor [1].
    double fluke_angle = 0.7853981633974483;  ///< θ_f0 of the fluke to the line [rad].
    double first_depth = 1.0;                 ///< Depth z at x = 0 [m].
    double chain_width = 0.0;     ///< Bearing width E_n b: 2.5 bar diameters of chain, the diameter
                                  ///< of wire [m]; 0: no line in the soil.
    double chain_bearing = 12.0;  ///< N_c [1].
    double chain_friction = 0.0;  ///< μ_c of the line along its curve in the soil [1].
};

/// Definition of an anchor; World::add() copies it.
struct AnchorDef {
    std::string name{};         ///< Unique name among systems.
    BodyId body{};              ///< Rigid body. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Point at which the soil acts, in the body's frame [m].
    /// Anchor line, whose force and direction count; invalid: all wires that end on the body, or,
    /// if there are none, all that acts on it. Needed if a pendant is made fast to the anchor, too.
    WireId wire{};
    AnchorSoil soil = AnchorSoil::none;
    AnchorType type = AnchorType::given;
    double mass = kDefault;          ///< Mass of the anchor for its type and weight [kg]; default:
                                     ///< that of the body.
    double uhc = kDefault;           ///< Ultimate holding capacity [N]; default: that of the type.
    double fluke_length = kDefault;  ///< [m]; default: (mass/(120 kg/m³))^(1/3), an assumption.
    AnchorLaw law = AnchorLaw::exponential;
    double first = 0.072;           ///< Fraction of the capacity without drag g₀ [1].
    double drag_length = kDefault;  ///< Drag length ℓ of the exponential law [m]; default: 20 fluke
                                    ///< lengths in clay, 4 in sand.
    double full_depth = 0.0;        ///< Depth of the point after long drag, exponential law [m].
    double breakout = kDefault;     ///< V_b over UHC g [1]; default: 0.17 in sand, 0.75 in clay.
    double friction = 0.5;          ///< Friction coefficient μ of a free anchor on the seabed [1].
    double weight = kDefault;       ///< Submerged weight W [N]; default: weight of the body less
                                    ///< that of the water that it displaces.
    double seabed = kDefault;       ///< z of the seabed [m]; default: that of the sea, else of
                                    ///< the point at the start.
    double touch = 0.5;             ///< Largest height of a free anchor on the seabed [m].
    double set_after = kDefault;    ///< Drag until a free anchor is set [m]; default: 0.5
                                    ///< fluke_length.
    double drag = 0.0;              ///< Drag x at the start [m].
    bool set = false;               ///< True: it is set at the start.
    AnchorClay clay{};
};

/// Return the ultimate holding capacity of an anchor type [N]: Vryhof's a m^b, or the law of
/// UFC 4-159-03 with the coefficients of NCEL TDS 83-08R. NaN: not published for this soil.
[[nodiscard]] double anchor_uhc(AnchorType type, AnchorSoil soil, double mass) noexcept;
/// Return the factor f(θ) of the capacity for the line angle [1]; 0 from 45° on.
/// @param angle  Line angle θ [rad].
[[nodiscard]] double anchor_uplift(double angle) noexcept;
/// Return the line angle above which a set anchor breaks out, 45° [rad].
[[nodiscard]] constexpr double anchor_steepest() noexcept { return 0.7853981633974483; }

/// State of an anchor, for inspection and verification.
struct AnchorView {
    AnchorDef def{};           ///< Definition with all defaults filled in.
    double drag = 0.0;         ///< Drag x [m].
    bool set = false;          ///< True if the anchor is set.
    bool grounded = false;     ///< True if it is on the seabed or in it, so that the soil acts.
    InteractionId slide[3]{};  ///< Interactions NAME/x, NAME/y, NAME/z.
    InteractionId turn[3]{};   ///< Interactions NAME/rx, NAME/ry, NAME/rz.
    double bound[3]{};         ///< Bounds of the slides in the last step [N].
    Vec3 pull{0.0, 0.0, 0.0};  ///< Force of the lines from which `bound` was computed, world frame,
                               ///< of the step before [N].
    double drag_before = 0.0;  ///< Drag from which `bound` was computed [m].
};
/// Return the anchors of a world in the order in which they act.
[[nodiscard]] std::vector<AnchorView> anchors_of(const World& world);

/// Add an anchor; World::add() calls it.
/// @throws DefError "anchor 'NAME': field: reason".
System* define(World& world, const AnchorDef& def);

}  // namespace hawser
