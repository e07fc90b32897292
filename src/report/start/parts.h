// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file parts.h
/// The parts of a check of a start; each adds to the findings. See check.h.

#include "record/scene_info.h"
#include "report/start/findings.h"
#include "report/start/joint_rows.h"

#include <string>
#include <vector>

namespace hawser::exercise {
struct Exercise;
}

namespace hawser::report::start {

/// Masses, sizes and inertias (bodies.cpp); turns in a step.
void check_bodies(const World& world, Findings& out);
/// Mass of cables over the volume of their shapes (bodies.cpp).
void check_cable_density(const record::SceneInfo& scene, const World& world, Findings& out);
/// Cables that are in air although their line type is made for water (dry_lines.cpp).
void check_dry_lines(const record::SceneInfo& scene, const World& world, Findings& out);
/// Sea depth and seabeds that differ, wires without drag, hulls in short waves, memories that are
/// cut too early (sea_scene.cpp).
void check_sea_scene(const record::SceneInfo& scene, const World& world, Findings& out);
/// Line types and winches of the document whose numbers do not fit (document.cpp).
void check_document(const record::SceneInfo& scene, Findings& out);
/// Bare drums that keep one element of their cable (drums.cpp).
void check_drums(const record::SceneInfo& scene, const World& world, Findings& out);
/// Points that an exercise needs and its goals do not give (points.cpp).
void check_points(const exercise::Exercise& exercise, Findings& out);
/// Coefficients of vessels outside the range of published ships (vessels.cpp).
void check_vessels(const World& world, Findings& out);
/// Posts beside cables that they never take (posts.cpp).
void check_posts(const record::SceneInfo& scene, const World& world, Findings& out);
/// Hulls that displace more or less than they carry: what joints hold to their bodies, and what
/// lines pull. Bodies that float twice, by hydrostatic springs too (hulls.cpp).
void check_hulls(const World& world, Findings& out);
/// Lines that start beyond their breaking load (lines.cpp).
void check_tensions(const record::SceneInfo& scene, const World& world, Findings& out);
/// Shapes inside each other (overlaps.cpp).
void check_overlaps(const record::SceneInfo& scene, const World& world, Findings& out);
/// Joints that start open or tearing (joints.cpp). Rows are those of the world.
void check_gaps(const World& world, const JointRows& rows, Findings& out);
/// Joints, motors and prescribed motions that repeat or contradict each other (repetitions.cpp).
void check_repetitions(const World& world, JointRows& rows, Findings& out);
/// Ranges that start outside, or have nothing in common (joints.cpp).
void check_ranges(const World& world, Findings& out);
/// Motors that friction holds (joints.cpp).
void check_motor_friction(const World& world, Findings& out);
/// Wires and joints that the step does not resolve (steps.cpp).
void check_steps(const record::SceneInfo& scene, const World& world, Findings& out);

/// Tension from the stretch at the start [N]; 0 where slack, or of another kind.
[[nodiscard]] double start_tension(const World& world, InteractionId id);
/// Length of what a gap at this joint is compared with: its longest arm, at least 0.1 m.
[[nodiscard]] double reach(const Joint& joint);

}  // namespace hawser::report::start
