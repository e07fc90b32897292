// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interactions.h
/// Catalogue of the interactions, and the definition struct for all of them.
///
/// A KindInfo describes each kind: name, number of bodies, number of rows, geometric fields, and
/// parameters with unit, default and range. The scene reader, the JSON Schema and the reference
/// page are generated from this table. To add a kind, add a file in `src/model/kinds/` and a line
/// in HAWSER_INTERACTION_KINDS below.
///
/// *Rows*. A row has a violation g(x) [m or rad] and a Jacobian G with ġ = G v. It has a compliance
/// ε [m/N or rad/(N m)] and a damping time τ [s].
///
/// Its force f acts along Gᵀ and obeys g = −ε f at rest. A row with ε = 0 is a rigid constraint.
/// Velocity rows (motors) require G v = u and have a velocity compliance γ [m/s/N].
///
/// *Signs*. f > 0 acts so that g increases. If g is the position of body 1 relative to body 0, f
/// acts on body 1 along the row's axis and −f on body 0. A line in tension has f < 0.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace hawser {

// clang-format off
/// X(enumerator, "scene name"). The order is part of the state hash: append only.
#define HAWSER_INTERACTION_KINDS(X)       \
    X(Ball,           "ball")             \
    X(Hinge,          "hinge")            \
    X(Prismatic,      "prismatic")        \
    X(Cylindrical,    "cylindrical")      \
    X(Universal,      "universal")        \
    X(Lock,           "lock")             \
    X(Distance,       "distance")         \
    X(Stretch,        "stretch")          \
    X(WinchStretch,   "winch_stretch")    \
    X(Bend,           "bend")             \
    X(Twist,          "twist")            \
    X(Hydrostatic,    "hydrostatic")      \
    X(Hold,           "hold")             \
    X(HingeMotor,     "hinge_motor")      \
    X(SlideMotor,     "slide_motor")      \
    X(ScalarMotor,    "scalar_motor")     \
    X(HingeRange,     "hinge_range")      \
    X(SlideRange,     "slide_range")      \
    X(HingeFriction,  "hinge_friction")   \
    X(SlideFriction,  "slide_friction")   \
    X(ScalarFriction, "scalar_friction")  \
    X(Gear,           "gear")             \
    X(ScalarClutch,   "scalar_clutch")    \
    X(Span,           "span")             \
    X(EndSpan,        "end_span")         \
    X(BodySpan,       "body_span")        \
    X(LineFriction,   "line_friction")
// clang-format on

/// Kind of an interaction, in the order of HAWSER_INTERACTION_KINDS.
enum class InteractionKind : std::uint8_t {
#define HAWSER_X(id, name) id,
    HAWSER_INTERACTION_KINDS(HAWSER_X)
#undef HAWSER_X
};
inline constexpr int kInteractionKindCount = 0
#define HAWSER_X(id, name) +1
    HAWSER_INTERACTION_KINDS(HAWSER_X);
#undef HAWSER_X

// Largest numbers in an interaction.
inline constexpr int kMaxInteractionBodies = 4;
inline constexpr int kMaxInteractionRows = 6;
inline constexpr int kMaxInteractionParams = 8;
inline constexpr int kMaxFrictionLoads = 2;

/// Value of a member that is not set (NaN). Each member documents its default.
inline constexpr double kDefault = std::numeric_limits<double>::quiet_NaN();
/// Smallest rest length of a winch_stretch, as a fraction of its parameter `length` [1]. At this
/// length the wire's end has reached the fairlead, and hauling stops (drum_feed.h).
inline constexpr double kLeastOfDrumElement = 0.02;

/// Named parameter of a kind.
struct ParamInfo {
    const char* name;    ///< Name in scene files, e.g. "length".
    const char* unit;    ///< SI unit, e.g. "m"; "1" if dimensionless.
    double fallback;     ///< Default [unit]; NaN: required.
    double min;          ///< Smallest permitted value [unit].
    double max;          ///< Largest permitted value [unit].
    const char* doc;     ///< Description, one sentence.
    bool input = false;  ///< True: an input may change it between steps (World::add_input()).
};

/// Coordinate of one degree of freedom, World::coordinate().
enum class KindCoordinate : std::uint8_t {
    none,    ///< The kind has no coordinate.
    about,   ///< Angle about the axis [rad], from the x axis of frame 0 to that of frame 1.
    along,   ///< Displacement along the axis [m].
    scalar,  ///< Coordinate of a scalar body [m or rad].
};

/// Properties of a kind, bits of KindInfo::traits. Code tests these instead of the kind.
enum KindTrait : std::uint32_t {
    kHoldsBodies = 1 << 0,  ///< Joint; shapes of its bodies do not collide.
    kSlides = 1 << 1,       ///< Joint that is free along its axis: it has no fixed lever arm.
    kAxisFree = 1 << 2,     ///< Joint with frames but without an axis: relative orientation fixed.
    kTwoAxes = 1 << 3,      ///< Each body has its own axis.
    kAlongLine = 1 << 4,    ///< One row along the line between its points: tension = −force[0].
    kWireElement = 1 << 5,  ///< Subset of kAlongLine: a line with a rest length, which may break.
    kWoundUp = 1 << 6,      ///< Subset of kAlongLine: a drum sets the rest length. Never a cut.
    kElastic = 1 << 7,      ///< Rows count as springs, not as constraints, at any compliance.
    kMotorKind = 1 << 8,    ///< Motor: parameters speed, force_min, force_max.
    kRangeKind = 1 << 9,    ///< Range of a coordinate: parameters min, max.
    kFrictionKind = 1 << 10,  ///< Friction or brake: its parameter is the bound of the force.
    kOfWires = 1 << 11,       ///< Part of wires and chains: partitions weigh it as a link.
    kRigidOnly = 1 << 12,     ///< Acts on a rigid body.
    kCompact = 1 << 13,       ///< Between rigid bodies its Jacobian is given by two lever arms.
    kRouted = 1 << 14,        ///< Part of a line that slides through turning points. Never a cut.
    kFollowsAngle = 1 << 15,  ///< Friction whose load factors follow the wrap angle of the line.
    kAtGuide = 1 << 16,       ///< Subset of kWoundUp: element from a body to the tangent point on
                              ///< the wheel of a guide.
    kBendsWire = 1 << 17,     ///< Bending moment at the middle one of three nodes of a wire.
    kForceOnSecond =
        1 << 18,  ///< Joint whose rows 0 to 2 are the force on its second body, world axes.
    kPulls = kAlongLine | kRouted,  ///< Mask of the kinds with tension = −force[0].
};

/// Table row of a kind. Readers and documents are generated from it.
struct KindInfo {
    InteractionKind kind{};      ///< Kind that the row describes.
    const char* name = "";       ///< Name in scene files.
    int bodies = 2;              ///< Number of bodies, 1-4; a fixed body counts.
    int rows = 0;                ///< Number of rows, 1-6.
    bool uses_points = true;     ///< Reads InteractionDef::point.
    bool uses_frames = false;    ///< Reads InteractionDef::frame.
    const char* row_units = "";  ///< One letter per row: m metre, r radian, v velocity row.
    int scalar_slot = -1;        ///< First slot that requires a scalar body; −1: none.
    int scalars = 1;  ///< Number of slots from scalar_slot on that require scalar bodies; the
                      ///< bodies of other slots must not be scalar.
    bool takes_loads = false;       ///< Reads InteractionDef::load.
    bool length_from_pose = false;  ///< Parameter "length" defaults to the initial distance.
    const char* from_pose = "";     ///< Name of another parameter whose default follows from the
                                    ///< initial poses; "": none.
    /// Coordinate on which the kind acts, as joint, motor, range or friction.
    KindCoordinate coordinate = KindCoordinate::none;
    int mass_param = -1;  ///< Index of the parameter with the mass of a wire element; −1: none.
    std::uint32_t traits = 0;             ///< Bits of KindTrait.
    std::span<const ParamInfo> params{};  ///< At most kMaxInteractionParams.
    const char* doc = "";                 ///< Description, one or two sentences.

    /// True if the kind has the trait.
    [[nodiscard]] constexpr bool is(KindTrait trait) const noexcept {
        return (traits & trait) != 0;
    }
    /// True if the slot requires a scalar body.
    [[nodiscard]] constexpr bool takes_scalar(int slot) const noexcept {
        return scalar_slot >= 0 && slot >= scalar_slot && slot < scalar_slot + scalars;
    }
};

/// Return all kinds in the order of InteractionKind.
[[nodiscard]] std::span<const KindInfo> interaction_kinds() noexcept;
/// Return the table row of a kind.
[[nodiscard]] const KindInfo& kind_info(InteractionKind kind) noexcept;
/// Return the kind with this name, or nullptr.
[[nodiscard]] const KindInfo* find_kind(std::string_view name) noexcept;

/// Load of dry friction: an interaction whose force increases the bound, such as the joint that a
/// bearing belongs to. The bound is the parameter plus factor × force of each load.
struct FrictionLoad {
    InteractionId interaction{};  ///< Interaction that was added before; invalid: no load.
    /// Factor from the force to the bound, 0 to 1e6 [1; if the bound is a torque: m]. The force is
    /// the norm of the interaction's rows in metres. Usual factors: μ of a slide, μ × radius of a
    /// bearing, tanh(μδ/2) of both parts of a line that turns by the angle δ.
    double factor = 0.0;
};

/// Interaction between 1-4 bodies. World::add_interaction() copies the definition.
struct InteractionDef {
    std::string name{};                            ///< Unique name in the world, or empty.
    InteractionKind kind = InteractionKind::Ball;  ///< Kind of the interaction.

    /// Bodies in the kind's order; the first KindInfo::bodies are used.
    std::array<BodyId, kMaxInteractionBodies> body{};

    /// Attachment point in each body's frame, from its centre of mass [m]. Not used for lumped
    /// masses.
    std::array<Vec3, kMaxInteractionBodies> point{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                                  Vec3::Zero()};

    /// Orientation of the joint frame in each body's frame; the joint's axis is its z.
    std::array<Quat, kMaxInteractionBodies> frame{Quat::Identity(), Quat::Identity(),
                                                  Quat::Identity(), Quat::Identity()};

    /// Compliance ε of each row [m/N or rad/(N m)]; for velocity rows γ [m/s/N or rad/s/(N m)]. 0:
    /// rigid. Default: that of the kind (1e-12 for constraints; from EA, EI, … for elements).
    std::array<double, kMaxInteractionRows> compliance = filled();

    /// Damping time τ of each row [s]. Default: that of the kind (two steps for constraints).
    std::array<double, kMaxInteractionRows> damping_time = filled();

    /// Parameters in the order of KindInfo::params; kDefault: the table's default.
    std::array<double, kMaxInteractionParams> params = filled8();

    /// Loads of kinds with friction (KindInfo::takes_loads): the bound is the parameter plus Σ
    /// factor ‖force‖.
    std::array<FrictionLoad, kMaxFrictionLoads> load{};

    /// Set a parameter by its name.
    /// @throws DefError if the kind has no such parameter.
    InteractionDef& set(std::string_view param, double value);
    /// Return a parameter by its name; NaN: default.
    /// @throws DefError if the kind has no such parameter.
    [[nodiscard]] double get(std::string_view param) const;

  private:
    static constexpr std::array<double, kMaxInteractionRows> filled() {
        std::array<double, kMaxInteractionRows> a{};
        a.fill(kDefault);
        return a;
    }
    static constexpr std::array<double, kMaxInteractionParams> filled8() {
        std::array<double, kMaxInteractionParams> a{};
        a.fill(kDefault);
        return a;
    }
};

}  // namespace hawser
