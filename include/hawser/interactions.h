// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interactions.h
/// The catalogue of interactions and the one definition struct that serves all of them.
///
/// A kind is described by a KindInfo: its name, how many bodies it couples, how many rows it
/// adds, which of the geometric fields it reads and its named parameters with unit, default
/// and range. The scene reader, the JSON Schema and the reference page are generated from
/// this table, so adding a kind means: one file in `src/model/kinds/`, one line in
/// HAWSER_INTERACTION_KINDS below.
///
/// Row conventions. A row has a violation g(x) [m or rad], a Jacobian G with ġ = G v, a
/// compliance ε [m/N or rad/(N m)] and a damping time τ [s]. Its force f acts along Gᵀ and
/// obeys, at rest, g = −ε f. A row with ε = 0 is a rigid constraint. Velocity rows (motors)
/// have G v = u and a velocity compliance γ [m/s/N] instead. Signs: f > 0 pushes so that g
/// grows; where g is the position of body 1 against body 0, f acts on body 1 along the row's axis
/// and −f on body 0, and a line in tension has f < 0.

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

enum class InteractionKind : std::uint8_t {
#define HAWSER_X(id, name) id,
    HAWSER_INTERACTION_KINDS(HAWSER_X)
#undef HAWSER_X
};
inline constexpr int kInteractionKindCount = 0
#define HAWSER_X(id, name) +1
    HAWSER_INTERACTION_KINDS(HAWSER_X);
#undef HAWSER_X

inline constexpr int kMaxInteractionBodies = 4;
inline constexpr int kMaxInteractionRows = 6;
inline constexpr int kMaxInteractionParams = 8;
inline constexpr int kMaxFrictionLoads = 2;

/// Marks a field that takes its default from the kind's table.
inline constexpr double kDefault = std::numeric_limits<double>::quiet_NaN();
/// Fraction of the parameter `length` of a winch_stretch below which its rest length does not fall:
/// there the wire's end stands at the fairlead, and the drum hauls no further (drum_feed.h).
inline constexpr double kLeastOfDrumElement = 0.02;

/// One named parameter of a kind.
struct ParamInfo {
    const char* name;    ///< As in scene files, e.g. "length".
    const char* unit;    ///< SI, e.g. "m"; "1" without dimension.
    double fallback;     ///< Value when not given; NaN = must be given.
    double min;          ///< Smallest value accepted.
    double max;          ///< Largest value accepted.
    const char* doc;     ///< One sentence.
    bool input = false;  ///< May be changed between steps (see World::add_input).
};

/// What one degree of freedom is measured by.
enum class KindCoordinate : std::uint8_t {
    none,
    about,   ///< Angle about the axis [rad], from the frames' x axes.
    along,   ///< Way along the axis [m].
    scalar,  ///< Of a scalar body [m or rad].
};

/// What a kind is, so that no one else has to know which kind it is. Bits of KindInfo::traits.
enum KindTrait : std::uint32_t {
    kHoldsBodies = 1 << 0,    ///< A joint: shapes of the bodies that it holds do not touch.
    kSlides = 1 << 1,         ///< A joint that gives way along its axis: no arm swings about it.
    kAxisFree = 1 << 2,       ///< Has frames but no axis: it keeps the orientation there is.
    kTwoAxes = 1 << 3,        ///< Its bodies have an axis each, which differ.
    kAlongLine = 1 << 4,      ///< One row along the line between its points: tension = −force[0].
    kWireElement = 1 << 5,    ///< Of such: a piece of a line with a length at rest, which may part.
    kWoundUp = 1 << 6,        ///< Of such: the length follows a drum. Never cut.
    kElastic = 1 << 7,        ///< Its rows are springs, whatever their compliance.
    kMotorKind = 1 << 8,      ///< Drives: parameters speed, force_min, force_max.
    kRangeKind = 1 << 9,      ///< Limits a travel: parameters min, max.
    kFrictionKind = 1 << 10,  ///< Rubs or brakes: its parameter is the bound.
    kOfWires = 1 << 11,       ///< Wires and chains are made of it: partitions weigh it as a link.
    kRigidOnly = 1 << 12,     ///< Acts on a rigid body.
    kCompact = 1 << 13,  ///< Between rigid bodies its two arms are all its Jacobian is made of.
    kRouted = 1 << 14,   ///< Of lines: between places that the line slides through. Never cut.
    kFollowsAngle = 1 << 15,  ///< Friction whose loads' factors are those of the line's angle.
    kAtGuide = 1 << 16,       ///< Of kWoundUp: runs from a body to where it leaves a guide's wheel.
    kBendsWire = 1 << 17,     ///< A couple about the second of three nodes of a wire.
    kForceOnSecond =
        1 << 18,  ///< A joint: rows 0 to 2 are the force on its second body, world axes.
    kPulls = kAlongLine | kRouted,  ///< Tension = −force[0].
};

/// What a kind needs and does: the table row from which readers and documents are made.
struct KindInfo {
    InteractionKind kind{};
    const char* name = "";          ///< As in scene files.
    int bodies = 2;                 ///< Bodies coupled, 1-4; a fixed body counts.
    int rows = 0;                   ///< Equations added, 1-6.
    bool uses_points = true;        ///< Reads InteractionDef::point.
    bool uses_frames = false;       ///< Reads InteractionDef::frame.
    const char* row_units = "";     ///< One letter a row: m metre, r radian, v velocity row.
    int scalar_slot = -1;           ///< First slot that must be a scalar body …
    int scalars = 1;                ///< … of so many; others must not.
    bool takes_loads = false;       ///< Reads InteractionDef::load.
    bool length_from_pose = false;  ///< "length" defaults to the initial distance.
    const char* from_pose = "";     ///< Another parameter that defaults to the initial pose.
    KindCoordinate coordinate = KindCoordinate::none;  ///< That it holds, drives, limits or rubs.
    int mass_param = -1;       ///< Parameter that is the mass of an element of a wire, −1: none.
    std::uint32_t traits = 0;  ///< Of KindTrait.
    std::span<const ParamInfo> params{};  ///< At most kMaxInteractionParams.
    const char* doc = "";                 ///< What it does, in one or two sentences.

    [[nodiscard]] constexpr bool is(KindTrait trait) const noexcept {
        return (traits & trait) != 0;
    }
    /// Whether a slot must be a scalar body.
    [[nodiscard]] constexpr bool takes_scalar(int slot) const noexcept {
        return scalar_slot >= 0 && slot >= scalar_slot && slot < scalar_slot + scalars;
    }
};

/// All kinds in the order of InteractionKind.
[[nodiscard]] std::span<const KindInfo> interaction_kinds() noexcept;
[[nodiscard]] const KindInfo& kind_info(InteractionKind kind) noexcept;
/// @return nullptr when no kind has this name.
[[nodiscard]] const KindInfo* find_kind(std::string_view name) noexcept;

/// What presses on dry friction: the force of another interaction, of which a share is the bound.
struct FrictionLoad {
    InteractionId interaction{};  ///< Added before; none: no load.
    /// Of the norm of its rows in metres [1], for a torque [m], 0 to 1e6: μ of a slide, μ times
    /// the radius of a bearing, tanh(μδ/2) of each end of a line round an angle δ.
    double factor = 0.0;
};

/// One interaction between 1-4 bodies. A definition: World::add_interaction copies it whole.
struct InteractionDef {
    std::string name{};  ///< Unique in the world, or empty.
    InteractionKind kind = InteractionKind::Ball;

    /// Bodies in the kind's order; the first KindInfo::bodies are used.
    std::array<BodyId, kMaxInteractionBodies> body{};

    /// Attachment point in each body's frame, from its centre of mass [m]. Lumps ignore it.
    std::array<Vec3, kMaxInteractionBodies> point{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                                                  Vec3::Zero()};

    /// Orientation of the joint frame in each body's frame; the joint's axis is its z.
    std::array<Quat, kMaxInteractionBodies> frame{Quat::Identity(), Quat::Identity(),
                                                  Quat::Identity(), Quat::Identity()};

    /// Compliance ε of each row [m/N or rad/(N m)]; for velocity rows γ [m/s/N or rad/s/(N m)].
    /// kDefault: the kind's own (1e-12 for constraints, from EA, EI, … for elements). 0 = rigid.
    std::array<double, kMaxInteractionRows> compliance = filled();

    /// Damping time τ of each row [s]. kDefault: the kind's own (two steps for constraints).
    std::array<double, kMaxInteractionRows> damping_time = filled();

    /// Parameters in the order of KindInfo::params; kDefault = the table's default.
    std::array<double, kMaxInteractionParams> params = filled8();

    /// Of kinds with friction: their bound is the parameter plus Σ factor ‖force‖ of these.
    std::array<FrictionLoad, kMaxFrictionLoads> load{};

    /// Set one parameter by its name. @throws DefError when the kind has no such parameter.
    InteractionDef& set(std::string_view param, double value);
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
