// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// Parts of a check of a start. Each adds to the findings. See check.h.

#include "record/scene_info.h"
#include "report/start/findings.h"
#include "report/start/joint_rows.h"

#include <string>
#include <vector>

namespace hawser::exercise {
struct Exercise;
}
namespace hawser::scene {
struct Scene;
}

namespace hawser::report::start {

/// Check masses, sizes and inertias, and rotations in a step (bodies.cpp).
void check_bodies(const World& world, Findings& out);
/// Check the mass of cables relative to the volume of their shapes (bodies.cpp).
void check_cable_density(const record::SceneInfo& scene, const World& world, Findings& out);
/// Find cables that are in air although their line type is for water (dry_lines.cpp).
void check_dry_lines(const record::SceneInfo& scene, const World& world, Findings& out);
/// Check the water depth against the planes of the seabed, wires for drag, hulls for short waves,
/// and radiation memories for truncation (sea_scene.cpp).
void check_sea_scene(const record::SceneInfo& scene, const World& world, Findings& out);
/// Check line types and winches of the document for inconsistent numbers (document.cpp).
void check_document(const record::SceneInfo& scene, Findings& out);
/// Check for bare drums that feed no elements, so that hauling stops within one element
/// (drums.cpp).
void check_drums(const record::SceneInfo& scene, const World& world, Findings& out);
/// Check for points that an exercise needs and its goals do not award (points.cpp).
void check_points(const exercise::Exercise& exercise, Findings& out);
/// Check for phases without an end condition, goals that no control can reach in time, and stations
/// without inputs (points.cpp). The texts of the findings contain the position in the document.
void check_task(const exercise::Exercise& exercise, Findings& out);
/// Check for controls of stations without a range: inputs without min or max, and signals that
/// accept values far beyond those of a real control (points.cpp).
void check_controls(const exercise::Exercise& exercise, const scene::Scene& scene, Findings& out);
/// Check coefficients of vessels against the range of published ships (vessels.cpp).
void check_vessels(const World& world, Findings& out);
/// Check for bollards that never engage a nearby cable (posts.cpp).
void check_posts(const record::SceneInfo& scene, const World& world, Findings& out);
/// Check hulls that displace more or less than they carry: bodies attached by joints, and pulls of
/// lines. Check for bodies that also float by hydrostatic springs (hulls.cpp).
void check_hulls(const World& world, Findings& out);
/// Check for lines that start beyond their breaking load (lines.cpp).
void check_tensions(const record::SceneInfo& scene, const World& world, Findings& out);
/// Check for shapes inside each other (overlaps.cpp).
void check_overlaps(const record::SceneInfo& scene, const World& world, Findings& out);
/// Find joints that are open at the start or whose velocities are inconsistent (joints.cpp).
/// @param rows  Rows of the joints of the world.
void check_gaps(const World& world, const JointRows& rows, Findings& out);
/// Find joints, motors and prescribed motions that are redundant or contradictory
/// (repetitions.cpp).
void check_repetitions(const World& world, JointRows& rows, Findings& out);
/// Check for ranges that are violated at the start or disjoint (joints.cpp).
void check_ranges(const World& world, Findings& out);
/// Check for motors that friction holds (joints.cpp).
void check_motor_friction(const World& world, Findings& out);
/// Check for motors without limit of force that drive against a range (joints.cpp).
void check_motor_ranges(const World& world, Findings& out);
/// Check for wires and joints that the step does not resolve (steps.cpp).
void check_steps(const record::SceneInfo& scene, const World& world, Findings& out);

/// Return the tension from the stretch at the start [N]; 0 if slack, or for other kinds.
[[nodiscard]] double start_tension(const World& world, InteractionId id);
/// Return the length for comparison with a gap at this joint: its longest arm, at least 0.1 m.
[[nodiscard]] double comparison_length(const Joint& joint);

}  // namespace hawser::report::start
