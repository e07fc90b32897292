// SPDX-License-Identifier: Apache-2.0
#include <hawser/settings.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace hawser {
namespace {

constexpr double kMostElements = 1e9;

constexpr std::array kFormNames = {"auto", "saddle", "condensed"};
constexpr std::array kMethodNames = {"newton", "pivoting", "split", "pgs", "convex"};
constexpr std::array kCouplingNames = {"exact", "kinematic", "compliant", "deadline"};
constexpr std::array kPredictorNames = {"hold", "forces", "clique"};
constexpr std::array kOnDiverged = {"stop", "warn"};

/// Return the table entry of a setting, which reads and writes one member: a number, a bool or an
/// enumeration.
template <auto Member>
constexpr SettingInfo of(SettingInfo info) {
    info.get = [](const WorldDef& def, int) { return static_cast<double>(def.*Member); };
    info.set = [](WorldDef& def, int, double value) {
        using Value = std::remove_reference_t<decltype(def.*Member)>;
        def.*Member = static_cast<Value>(value);
    };
    return info;
}

constexpr SettingInfo gravity(SettingInfo info) {
    info.get = [](const WorldDef& def, int i) { return def.gravity[i]; };
    info.set = [](WorldDef& def, int i, double value) { def.gravity[i] = value; };
    return info;
}

constexpr auto kSettings = std::to_array<SettingInfo>({
    of<&WorldDef::step>({.name = "step",
                         .min = 1e-7,
                         .max = 1.0,
                         .unit = "s",
                         .what = "a time",
                         .identity = true,
                         .fallback = "1/60",
                         .doc = "Time step."}),
    gravity({.name = "gravity",
             .type = SettingType::vector,
             .min = -1e4,
             .max = 1e4,
             .unit = "m/s^2",
             .what = "an acceleration [x, y, z]",
             .identity = true,
             .fallback = "[0, 0, -9.81]",
             .doc = "Gravity."}),
    of<&WorldDef::form>({.name = "form",
                         .type = SettingType::word,
                         .what = "a form",
                         .words = kFormNames,
                         .doc = "Form of the step's equations that is factored."}),
    of<&WorldDef::geometric_stiffness>(
        {.name = "geometric_stiffness",
         .max = 100.0,
         .unit = "1",
         .what = "a factor",
         .identity = true,
         .doc = "Scale of the geometric stiffness of taut lines and joints; 0 is off."}),
    of<&WorldDef::rotation_damping>(
        {.name = "rotation_damping",
         .max = 100.0,
         .unit = "1",
         .what = "a factor",
         .identity = true,
         .doc = "Numerical damping of the relative rotation in joints; 0 is off."}),
    of<&WorldDef::staggered_start>({.name = "staggered_start",
                                    .type = SettingType::boolean,
                                    .max = 1.0,
                                    .what = "true or false",
                                    .identity = true,
                                    .doc = "Shift the initial velocities back by half a step, "
                                           "which makes the scheme second order."}),
    of<&WorldDef::nonsmooth>({.name = "nonsmooth",
                              .type = SettingType::word,
                              .what = "a method",
                              .words = kMethodNames,
                              .identity = true,
                              .doc = "How contacts with friction are solved; all but newton are "
                                     "there for comparison."}),
    of<&WorldDef::coupling>({.name = "coupling",
                             .type = SettingType::word,
                             .what = "a coupling",
                             .words = kCouplingNames,
                             .doc = "How interactions between groups of bodies couple them; "
                                    "kinematic and compliant are the splits of the paper, for "
                                    "comparison; deadline: exact, compliant where a budget needs "
                                    "it."}),
    of<&WorldDef::predictor>({.name = "predictor",
                              .type = SettingType::word,
                              .what = "a predictor",
                              .words = kPredictorNames,
                              .identity = true,
                              .doc = "Velocity that each side of a cut assumes for the other side: "
                                     "the last velocity, a velocity from the last forces, or the "
                                     "result of a solve for the bodies at the cuts."}),
    of<&WorldDef::parts>({.name = "parts",
                          .type = SettingType::integer,
                          .max = 4096,
                          .what = "a number of parts",
                          .fallback = "4 where no body has a group, else 0",
                          .doc = "Parts to cut into where coupling is not exact: bodies without a "
                                 "group get one, which follows the state; 0: only bodies with "
                                 "groups of their own are cut apart."}),
    of<&WorldDef::regroup_every>(
        {.name = "regroup_every",
         .type = SettingType::integer,
         .max = 1'000'000,
         .what = "a number of steps",
         .doc =
             "Number of steps after which these groups are checked again; 0: they never change."}),
    of<&WorldDef::contact_tolerance>({.name = "contact_tolerance",
                                      .min = 1e-12,
                                      .max = 1.0,
                                      .unit = "1",
                                      .what = "a relative residual",
                                      .identity = true,
                                      .fallback = "1e-6",
                                      .doc = "Residual of Coulomb's law at which the contacts of a "
                                             "step count as solved."}),
    of<&WorldDef::contact_iterations>(
        {.name = "contact_iterations",
         .type = SettingType::integer,
         .min = 1,
         .max = 1000,
         .what = "an integer",
         .identity = true,
         .doc = "Most iterations of one attempt to solve the contacts of a step."}),
    of<&WorldDef::nonsmooth_sweeps>({.name = "nonsmooth_sweeps",
                                     .type = SettingType::integer,
                                     .min = 1,
                                     .max = 100'000,
                                     .what = "an integer",
                                     .identity = true,
                                     .doc = "Sweeps a step of the methods split and pgs."}),
    of<&WorldDef::refinements>(
        {.name = "refinements",
         .type = SettingType::integer,
         .max = 4,
         .what = "an integer",
         .identity = true,
         .doc = "Refinements of a solution whose residual is above solution_tolerance; up to two "
                "more while it is above 1e-11."}),
    of<&WorldDef::solution_tolerance>(
        {.name = "solution_tolerance",
         .min = 1e-13,
         .max = 1e-6,
         .unit = "1",
         .what = "a residual",
         .identity = true,
         .fallback = "1e-10",
         .doc = "Residual above which a solution is refined: relative of momentum, of rows in m/s "
                "or rad/s."}),
    of<&WorldDef::contact_margin>(
        {.name = "contact_margin",
         .min = 1e-6,
         .max = 10.0,
         .unit = "m",
         .what = "a length",
         .identity = true,
         .doc = "Shapes closer than this are in contact before they touch."}),
    of<&WorldDef::sleep_after>({.name = "sleep_after",
                                .max = 1e6,
                                .unit = "s",
                                .what = "a time",
                                .identity = true,
                                .doc = "Islands at rest for this long sleep until something "
                                       "disturbs them; 0 is never."}),
    of<&WorldDef::on_diverged>(
        {.name = "on_diverged",
         .type = SettingType::word,
         .what = "what to do",
         .words = kOnDiverged,
         .doc = "Reaction to a physically impossible state (docs/limits.md): stop the run as "
                "failed, or continue with a warning."}),
    of<&WorldDef::sleep_speed>(
        {.name = "sleep_speed",
         .max = 1.0,
         .unit = "m/s",
         .what = "a speed",
         .identity = true,
         .fallback = "1e-4",
         .doc = "Speed √(2T/m) below which a body is at rest, T its kinetic energy."}),
    of<&WorldDef::max_bodies>(
        {.name = "max_bodies",
         .type = SettingType::integer,
         .min = 1,
         .max = kMostElements,
         .what = "a number of bodies",
         .doc = "A scene with more, copies included, is refused before it is built."}),
    of<&WorldDef::max_interactions>(
        {.name = "max_interactions",
         .type = SettingType::integer,
         .max = kMostElements,
         .what = "a number of interactions",
         .doc = "A scene with more, copies included, is refused before it is built."}),
    of<&WorldDef::max_contacts>({.name = "max_contacts",
                                 .type = SettingType::integer,
                                 .min = 1,
                                 .max = kMostElements,
                                 .what = "a number of contact points",
                                 .doc = "Steps with more fail, as do those with eight times as "
                                        "many pairs of shapes nearby."}),
    of<&WorldDef::max_memory>({.name = "max_memory",
                               .min = 1e6,
                               .max = 1e15,
                               .unit = "byte",
                               .what = "a number of bytes",
                               .fallback = "1.6e10",
                               .doc = "Limit of the memory for state, solver and contacts; "
                                      "requests beyond it are rejected."}),
    of<&WorldDef::budget>({.name = "budget",
                           .max = 1e6,
                           .unit = "s",
                           .what = "a time",
                           .in_scenes = false,
                           .doc = "Solver time of a step; 0: no limit."}),
    of<&WorldDef::budget_work>({.name = "budget_work",
                                .max = 1e18,
                                .unit = "flop",
                                .what = "a number of operations",
                                .in_scenes = false,
                                .doc = "Work of a step's factorisations and substitutions; 0: no "
                                       "limit."}),
    of<&WorldDef::threads>({.name = "threads",
                            .type = SettingType::integer,
                            .min = 1,
                            .max = 256,
                            .what = "a number of threads",
                            .in_scenes = false,
                            .doc = "Threads that a step uses; results do not depend on it."}),
});

}  // namespace

std::span<const SettingInfo> setting_infos() noexcept { return kSettings; }

const SettingInfo* find_setting(std::string_view name) noexcept {
    const auto* at = std::find_if(kSettings.begin(), kSettings.end(),
                                  [&](const SettingInfo& s) { return s.name == name; });
    return at == kSettings.end() ? nullptr : at;
}

}  // namespace hawser
