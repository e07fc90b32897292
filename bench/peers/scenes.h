// SPDX-License-Identifier: Apache-2.0
/// @file
/// The scenes of the comparison of engines as plain data: bodies, ball joints, linear loads.
///
/// Every engine is built from the same numbers, so that a difference in results is a difference of
/// engines. All scenes start at rest. World frame: x and y horizontal, z up; SI units.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

namespace hawser::bench {

using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;

inline constexpr double kFrame = 1.0 / 60.0;  ///< One displayed frame [s].
inline constexpr int kWorld = -1;             ///< Body index of the fixed world.

/// Pose and velocity of a body.
struct BodyState {
    Vec3 x = Vec3::Zero();      ///< Mass centre [m].
    Quat q = Quat::Identity();  ///< Body frame to world.
    Vec3 v = Vec3::Zero();      ///< Velocity of the mass centre [m/s].
    Vec3 w = Vec3::Zero();      ///< Angular velocity, in the world frame [rad/s].
};

/// Shape of a body, about its mass centre and along its axes; none: no contacts.
struct BodyShape {
    enum class Kind { none, capsule, box };
    Kind kind = Kind::none;
    double radius = 0.0;            ///< Radius of a capsule [m].
    double half_length = 0.0;       ///< Half the distance between the end centres of a capsule,
                                    ///< along body x [m].
    Vec3 half_size = Vec3::Zero();  ///< Half sizes of a box [m].
};

/// A rigid body whose body axes are its principal axes.
struct Body {
    double mass = 0.0;            ///< [kg]
    Vec3 inertia = Vec3::Zero();  ///< Principal moments about the mass centre [kg m2].
    BodyState start;              ///< Pose and velocity at t = 0.
    double drag = 0.0;            ///< Force = -drag * v on the mass centre [N s/m].
    bool afloat = false;          ///< Buoyancy equals weight: gravity does no work on it.
    BodyShape shape;
};

/// Contacts of a scene: a floor, and properties of all contacts.
struct Touching {
    double floor = 0.0;      ///< Height of a fixed horizontal plane, solid below [m].
    bool bodies = false;     ///< True if bodies touch each other; otherwise only the floor.
    double friction = 0.5;   ///< Coulomb's coefficient for all contacts.
    double stiffness = 0.0;  ///< Stiffness of a contact point, for engines with compliant contacts
                             ///< [N/m].
};

/// Demands on Hawser in a scene, in addition to *holds*; 0: none.
struct Wanted {
    double gap = 0.0;          ///< Largest joint position error [m].
    double tension = 0.0;      ///< Relative rms tension error.
    double moved = 0.0;        ///< Drop and sideways motion of the top [m].
    double ms = 0.0;           ///< Median CPU time of a frame [ms].
    int contacts[2] = {0, 0};  ///< Range of contact points of every frame.
};

/// Ball joint that is closed at the start.
struct BallJoint {
    int a = kWorld;              ///< First body, or kWorld.
    int b = kWorld;              ///< Second body, or kWorld.
    Vec3 anchor = Vec3::Zero();  ///< Joint position at t = 0, in the world [m].
    Vec3 arm_a = Vec3::Zero();   ///< Anchor in the frame of `a` (world position for kWorld) [m].
    Vec3 arm_b = Vec3::Zero();   ///< Anchor in the frame of `b` (world position for kWorld) [m].
};

/// A force of constant size and direction on a mass centre.
struct Thrust {
    int body = 0;
    Vec3 force = Vec3::Zero();  ///< [N]
};

/// Linear hydrostatics of a hull about its starting height and the upright attitude.
///
/// Restoring torque k (R e_z) x e_z and damping -c (w_x, w_y, 0): the same stiffness for roll
/// and pitch needs no choice of angles.
struct Floating {
    int body = 0;
    double heave_k = 0.0;  ///< [N/m]
    double heave_c = 0.0;  ///< [N s/m]
    double tilt_k = 0.0;   ///< Roll and pitch stiffness [N m/rad].
    double tilt_c = 0.0;   ///< Roll and pitch damping [N m s/rad].
};

/// Joints left out of the spanning forest of an engine with reduced coordinates.
struct TreeLayout {
    std::string name;
    std::vector<int> closures;  ///< Joint indices that become loop closures.
};

/// One scene. `bodies` and `joints` keep their order in every engine.
struct Scene {
    std::string name;
    std::string code;        ///< S1, S2p, S3, S3c or S4.
    double gravity = 9.81;   ///< [m/s2], along -z.
    double duration = 10.0;  ///< Length of the comparison [s].
    std::vector<Body> bodies;
    std::vector<BallJoint> joints;
    std::vector<Thrust> thrusts;
    std::vector<Floating> floating;
    std::vector<TreeLayout> layouts;  ///< The first one is the default.
    int block = -1;                   ///< Body whose path is compared, or -1.
    std::vector<int> towed;           ///< Ships whose tow tension is measured.
    std::optional<double> tension;    ///< Exact tension at every entry of `towed` [N].
    double energy_scale = 1.0;        ///< Energy to which a drift is relative [J].
    int cable_first = -1;             ///< First link of the cable with a sine start, or -1.
    int cable_links = 0;
    double sine = 0.0;                 ///< Amplitude of the sine start [m].
    double sine_omega = 0.0;           ///< Angular frequency of that mode [rad/s].
    std::optional<Touching> touching;  ///< Contacts; empty: none.
    int top = -1;                      ///< Body whose drop and sideways motion is measured, or -1.
    Wanted wanted;
};

/// Make S1: 100 links of 1 m and 10 kg, a block of 50 t, released straight at 20 degrees.
[[nodiscard]] Scene heavy_hook();

/// Make S2p: two ships of 4000 t, 200 links of 2 m and 50 kg, a sine of 5 cm and a zig-zag of 1 mm.
[[nodiscard]] Scene tow_zigzag();

/// Make S3: a rig on eight mooring lines and two tow lines of 90 links to two pulling ships.
[[nodiscard]] Scene mooring();

/// Make S3c: S3 with a floor 100.1 m below, on which 186.8 m of every mooring line lie; friction
/// 0.5.
[[nodiscard]] Scene mooring_seabed();

/// Make S4: nine boxes of 1 m and 1 kg with one of `top` on them; friction 0.5. With the stiffness
/// of contacts the top sinks by a quarter of a millimetre.
[[nodiscard]] Scene box_stack();      ///< 1,000 kg on top.
[[nodiscard]] Scene box_stack_1e6();  ///< 1,000,000 kg on top.

/// Return all scenes, in the order of the comparison.
[[nodiscard]] std::vector<Scene> all_scenes();

/// Return a scene by name or code; throws if unknown.
[[nodiscard]] Scene scene_by_name(const std::string& name);

/// Force and torque on a mass centre, in the world frame.
struct Load {
    Vec3 force = Vec3::Zero();   ///< [N]
    Vec3 torque = Vec3::Zero();  ///< [N m]
};

/// Compute all loads except gravity on non-floating bodies: thrust, drag, hydrostatics. @pre
/// `states` and `loads` have one entry per body.
void external_loads(const Scene& scene, const std::vector<BodyState>& states,
                    std::vector<Load>& loads);

}  // namespace hawser::bench
