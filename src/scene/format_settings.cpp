// SPDX-License-Identifier: Apache-2.0
#include "scene/format.h"

namespace hawser::scene {

using namespace make;

ShapePtr settings_shape() {
    return object(
        "settings", "settings", "How the scene is simulated.",
        {{"step", number("a time", 1e-7, 1.0), false, "1/60", "s", "Time step."},
         {"duration", positive("a time", 1e7), false, "10", "s", "Simulated time of a run."},
         {"gravity", list("an acceleration [x, y, z]", number("a number", -1e4, 1e4), 3, 3), false,
          "[0, 0, -9.81]", "m/s^2", "Gravity."},
         {"form", word("a form", {"auto", "saddle", "condensed"}), false, "auto", "",
          "Form of the step's equations that is factored."},
         {"geometric_stiffness", number("a factor", 0.0, 100.0), false, "1", "1",
          "Scale of the geometric stiffness of taut lines and joints; 0 is off."},
         {"rotation_damping", number("a factor", 0.0, 100.0), false, "0.1", "1",
          "Numerical damping of the relative rotation in joints; 0 is off."},
         {"staggered_start", boolean("true or false"), false, "true", "",
          "Take the initial velocities half a step back, which makes the scheme second order."},
         {"nonsmooth", word("a method", {"newton", "pivoting", "split", "pgs", "convex"}), false,
          "newton", "",
          "How contacts with friction are solved; all but newton are there for comparison."},
         {"coupling", word("a coupling", {"exact", "kinematic", "compliant", "deadline"}), false,
          "exact", "",
          "How interactions between groups of bodies couple them; kinematic and compliant are the "
          "splits of the paper, for comparison; deadline: exact, compliant where a budget needs "
          "it."},
         {"predictor", word("a predictor", {"hold", "forces", "clique"}), false, "hold", "",
          "Velocity that a side of a cut takes the other one to have: the last one, one from the "
          "last forces, or that of a solve of the bodies at the cuts."},
         {"parts", integer("a number of parts", 0, 4096), false,
          "4 where no body has a group, else 0", "",
          "Parts to cut into where coupling is not exact: bodies without a group get one, which "
          "follows the state; 0: only bodies with groups of their own are cut apart."},
         {"regroup_every", integer("a number of steps", 0, 1000000), false, "60", "",
          "Steps after which these groups are looked at again; 0: they stay as they are at first."},
         {"contact_tolerance", number("a relative residual", 1e-12, 1.0), false, "1e-6", "1",
          "Residual of Coulomb's law at which the contacts of a step count as solved."},
         {"contact_iterations", integer("an integer", 1, 1000), false, "60", "",
          "Most iterations of one attempt to solve the contacts of a step."},
         {"nonsmooth_sweeps", integer("an integer", 1, 100000), false, "50", "",
          "Sweeps a step of the methods split and pgs."},
         {"refinements", integer("an integer", 0, 4), false, "1", "",
          "Refinements of a solution whose residual is above solution_tolerance; up to two more "
          "where it is above 1e-11 still."},
         {"solution_tolerance", number("a residual", 1e-13, 1e-6), false, "1e-10", "1",
          "Residual above which a solution is refined: relative of momentum, of rows in m/s or "
          "rad/s."},
         {"contact_margin", number("a length", 1e-6, 10.0), false, "0.02", "m",
          "Shapes closer than this are in contact before they touch."},
         {"sleep_after", number("a time", 0.0, 1e6), false, "0", "s",
          "Islands at rest for this long sleep until something disturbs them; 0 is never."},
         {"on_diverged", word("what to do", {"stop", "warn"}), false, "stop", "",
          "What a step does that comes to what cannot be (docs/limits.md): stop the run as failed, "
          "or go on with a warning."},
         {"sleep_speed", number("a speed", 0.0, 1.0), false, "1e-4", "m/s",
          "Speed √(2T/m) below which a body is at rest, T its kinetic energy."},
         {"max_bodies", integer("a number of bodies", 1, kMaxElements), false, "2000000", "",
          "A scene with more, copies included, is refused before it is built."},
         {"max_interactions", integer("a number of interactions", 1, 2 * kMaxElements), false,
          "4000000", "", "Likewise."},
         {"max_contacts", integer("a number of contact points", 1, 1e9), false, "400000", "",
          "Steps with more fail, as do those with eight times as many pairs of shapes nearby."},
         {"max_memory", number("a number of bytes", 1e6, 1e15), false, "1.6e10", "byte",
          "Memory for state, solver and contacts; more is refused before it is asked for."}});
}

}  // namespace hawser::scene
