// SPDX-License-Identifier: Apache-2.0
#include "report/start/check.h"

#include "report/start/parts.h"

#include <fmt/format.h>

namespace hawser::report::start {

Findings check_start(const record::SceneInfo& scene, const World& world, std::size_t max_rows) {
    Findings out;
    check_bodies(world, out);
    check_cable_density(scene, world, out);
    check_hulls(world, out);
    check_dry_lines(scene, world, out);
    check_sea_scene(scene, world, out);
    check_document(scene, out);
    check_drums(scene, world, out);
    check_posts(scene, world, out);
    check_vessels(world, out);
    check_tensions(scene, world, out);
    check_overlaps(scene, world, out);
    check_ranges(world, out);
    check_motor_friction(world, out);
    check_motor_ranges(world, out);
    check_steps(scene, world, out);
    JointRows rows(world);
    if (rows.rows() > max_rows) {
        out.add(false, FindingKind::unexamined, {}, static_cast<double>(rows.rows()),
                fmt::format("the {} rows of joints are more than {}: gaps, and redundant or "
                            "inconsistent joints, were not checked",
                            rows.rows(), max_rows));
    } else if (rows.rows() > 0) {
        if (rows.update(world)) {
            check_gaps(world, rows, out);
            check_repetitions(world, rows, out);
        } else {
            out.add(false, FindingKind::unexamined, {}, 0.0,
                    "gaps, and redundant or inconsistent joints, could not be checked: lengths in "
                    "this scene differ too much");
        }
    }
    out.sort();
    return out;
}

}  // namespace hawser::report::start
