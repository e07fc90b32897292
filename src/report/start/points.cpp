// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>

#include "report/start/parts.h"

#include <fmt/format.h>

namespace hawser::report::start {

void check_points(const exercise::Exercise& e, Findings& out) {
    double possible = 0.0;
    for (const exercise::Goal& goal : e.goals) possible += goal.points;
    if (!(e.pass > possible)) return;
    out.add(false, FindingKind::points, {e.name}, e.pass - possible,
            fmt::format("the exercise needs {:.6g} points (\"pass\"), and its goals give {:.6g} in "
                        "all: it cannot be passed; lower \"pass\", or give goals more points",
                        e.pass, possible));
}

}  // namespace hawser::report::start
