// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

namespace hawser::scene {
namespace {

Nonsmooth nonsmooth_from(const std::string& word) {
    return word == "pivoting" ? Nonsmooth::pivoting
           : word == "split"  ? Nonsmooth::split
           : word == "pgs"    ? Nonsmooth::pgs
           : word == "convex" ? Nonsmooth::convex
                              : Nonsmooth::newton;
}

Coupling coupling_from(const std::string& word) {
    return word == "kinematic"   ? Coupling::kinematic
           : word == "compliant" ? Coupling::compliant
           : word == "deadline"  ? Coupling::deadline
                                 : Coupling::exact;
}

Predictor predictor_from(const std::string& word) {
    return word == "forces"   ? Predictor::forces
           : word == "clique" ? Predictor::clique
                              : Predictor::hold;
}

}  // namespace

void read_settings(Description& out, const Json& root) {
    const Json settings = root.value("settings", Json::object());
    WorldDef& def = out.settings;
    def.step = number_or(settings, "step", def.step);
    def.gravity = vector_or(settings, "gravity", def.gravity);
    const std::string form = text_or(settings, "form", "auto");
    def.form = form == "saddle"      ? Form::saddle
               : form == "condensed" ? Form::condensed
                                     : Form::automatic;
    def.geometric_stiffness = number_or(settings, "geometric_stiffness", def.geometric_stiffness);
    def.rotation_damping = number_or(settings, "rotation_damping", def.rotation_damping);
    def.staggered_start = settings.value("staggered_start", def.staggered_start);
    def.contact_margin = number_or(settings, "contact_margin", def.contact_margin);
    def.sleep_after = number_or(settings, "sleep_after", def.sleep_after);
    def.sleep_speed = number_or(settings, "sleep_speed", def.sleep_speed);
    def.on_diverged =
        text_or(settings, "on_diverged", "stop") == "warn" ? OnDiverged::warn : OnDiverged::stop;
    def.nonsmooth = nonsmooth_from(text_or(settings, "nonsmooth", "newton"));
    def.coupling = coupling_from(text_or(settings, "coupling", "exact"));
    def.predictor = predictor_from(text_or(settings, "predictor", "hold"));
    if (settings.contains("parts")) out.parts = settings["parts"].get<int>();
    def.regroup_every = settings.value("regroup_every", def.regroup_every);
    def.contact_tolerance = number_or(settings, "contact_tolerance", def.contact_tolerance);
    def.contact_iterations = settings.value("contact_iterations", def.contact_iterations);
    def.nonsmooth_sweeps = settings.value("nonsmooth_sweeps", def.nonsmooth_sweeps);
    def.refinements = settings.value("refinements", def.refinements);
    def.solution_tolerance = number_or(settings, "solution_tolerance", def.solution_tolerance);
    def.max_bodies = settings.value("max_bodies", std::int32_t{kMaxElements});
    def.max_interactions = settings.value("max_interactions", std::int32_t{2 * kMaxElements});
    def.max_contacts = settings.value("max_contacts", def.max_contacts);
    def.max_memory = number_or(settings, "max_memory", def.max_memory);
    out.duration = number_or(settings, "duration", out.duration);
    out.copies = root.contains("repeat") ? root["repeat"].value("copies", std::size_t{1}) : 1;
    const Json defaults = root.value("defaults", Json::object());
    out.default_compliance = number_or(defaults, "compliance", kDefault);
    out.default_damping_time = number_or(defaults, "damping_time", kDefault);
}

}  // namespace hawser::scene
