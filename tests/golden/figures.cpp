// SPDX-License-Identifier: Apache-2.0
#include "golden/figures.h"

#include <hawser/hawser.h>
#include <hawser/inspect.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::golden {

namespace {

/// Apply the finaliser of the generator splitmix64 (G. Steele, D. Lea, C. Flood, "Fast splittable
/// pseudorandom number generators", 2014).
std::uint64_t scramble(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31);
}

/// Compress a quantity of any unit, so that equal relative changes have equal weight.
double compress(double value) { return std::asinh(value); }

void write_bodies(const World& world, const std::vector<Pose>& start, Figures& out) {
    std::array<Projection, 3> position{Projection(1, 1e-3), Projection(2, 1e-3),
                                       Projection(3, 1e-3)};
    std::array<Projection, 3> velocity{Projection(4, 1e-3), Projection(5, 1e-3),
                                       Projection(6, 1e-3)};
    Projection orientation(7, 1e-3), spin(8, 1e-3), predicted(9, 1e-3), mass(10, 1e-3);
    std::int64_t asleep = 0;
    for (const BodyId id : world.bodies()) {
        const auto index = static_cast<std::size_t>(id.index);
        const Pose from = index < start.size() ? start[index] : Pose{};
        const Pose pose = world.pose(id);
        const Twist twist = world.velocity(id), next = world.predicted_velocity(id);
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            position[a].add(pose.position[axis] - from.position[axis]);
            velocity[a].add(twist.linear[axis]);
        }
        for (int i = 0; i < 4; ++i)
            orientation.add(pose.orientation.coeffs()[i] - from.orientation.coeffs()[i]);
        spin.add(twist.angular);
        predicted.add(next.linear);
        predicted.add(next.angular);
        mass.add(world.body_def(id).mass);
        asleep += world.asleep(id) ? 1 : 0;
    }
    const std::array<const char*, 3> axes{"x", "y", "z"};
    for (std::size_t a = 0; a < 3; ++a) {
        out.reals[std::string("position_") + axes[a]] = position[a].result();
        out.reals[std::string("velocity_") + axes[a]] = velocity[a].result();
    }
    out.reals["orientation"] = orientation.result();
    out.reals["spin"] = spin.result();
    out.reals["predicted_velocity"] = predicted.result();
    out.reals["mass"] = mass.result();
    out.counts["bodies"] = static_cast<std::int64_t>(world.bodies().size());
    out.counts["asleep"] = asleep;
}

void write_interactions(const World& world, Figures& out) {
    Projection force(21, 1e-3), coordinate(22, 1e-3), speed(23, 1e-3), params(24, 1e-3);
    Projection violation(25, 1e-3), rate(26, 1e-3), jacobian(27, 1e-3), softness(28, 1e-9);
    std::int64_t parted = 0, completed = 0, flagged = 0;
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        for (const double f : world.force(id)) force.add(f);
        if (kind_info(def.kind).coordinate != KindCoordinate::none) {
            coordinate.add(world.coordinate(id));
            speed.add(world.speed(id));
        }
        for (const double p : def.params) params.add(compress(p));
        const RowsView rows = world.solver().rows(id);
        for (std::size_t r = 0; r < static_cast<std::size_t>(rows.rows); ++r) {
            violation.add(rows.violation[r]);
            rate.add(rows.rate[r] - rows.speed[r]);
            softness.add(rows.compliance[r]);
            softness.add(rows.damping_time[r]);
            for (std::size_t b = 0; b < static_cast<std::size_t>(rows.bodies); ++b)
                for (const double g : rows.jacobian[b][r]) jacobian.add(g);
        }
        parted += world.intact(id) ? 0 : 1;
        completed += world.solver().completed(id) ? 1 : 0;
        flagged += world.wires().damped_steps(id);
    }
    out.reals["force"] = force.result();
    out.reals["coordinate"] = coordinate.result();
    out.reals["coordinate_speed"] = speed.result();
    out.reals["parameters"] = params.result();
    out.reals["row_violation"] = violation.result();
    out.reals["row_rate"] = rate.result();
    out.reals["row_jacobian"] = jacobian.result();
    out.reals["row_softness"] = softness.result();
    out.counts["interactions"] = static_cast<std::int64_t>(world.interactions().size());
    out.counts["parted"] = parted;
    out.counts["completed"] = completed;
    out.counts["wire_alert"] = flagged;
}

void write_wires(const World& world, Figures& out) {
    Projection tension(31, 1e-3), length(32, 1e-3);
    std::int64_t elements = 0, nodes = 0;
    for (const WireId id : world.wires().ids()) {
        const double whole = world.wires().length(id);
        length.add(whole);
        constexpr int kPoints = 8;
        for (int i = 0; i <= kPoints; ++i)
            tension.add(world.wires().tension(id, whole * i / kPoints));
        elements += static_cast<std::int64_t>(world.wires().elements(id).size());
        nodes += static_cast<std::int64_t>(world.wires().nodes(id).size());
    }
    out.reals["wire_tension"] = tension.result();
    out.reals["wire_length"] = length.result();
    out.counts["wires"] = static_cast<std::int64_t>(world.wires().ids().size());
    out.counts["wire_elements"] = elements;
    out.counts["wire_nodes"] = nodes;
}

void write_contacts(const World& world, Figures& out) {
    Projection force(41, 1e-3), moment(42, 1e-3), gap(43, 1e-3), place(44, 1e-3), law(45, 1e-3);
    std::int64_t sliding = 0;
    const std::vector<ContactView> contacts = world.contacts();
    for (const ContactView& c : contacts) {
        force.add(c.force);
        moment.add(c.moment);
        gap.add(c.gap);
        place.add(c.point);
        place.add(c.normal);
        law.add(c.friction);
        law.add(c.rolling);
        law.add(c.torsional);
        law.add(c.target);
        law.add(c.turn_target);
        for (const double s : {c.softness[0], c.softness[1], c.turn_softness}) law.add(compress(s));
        sliding += c.sliding ? 1 : 0;
    }
    out.reals["contact_force"] = force.result();
    out.reals["contact_moment"] = moment.result();
    out.reals["contact_gap"] = gap.result();
    out.reals["contact_place"] = place.result();
    out.reals["contact_law"] = law.result();
    out.counts["contacts"] = static_cast<std::int64_t>(contacts.size());
    out.counts["contacts_sliding"] = sliding;
    out.counts["overlaps"] = static_cast<std::int64_t>(world.overlaps().size());
}

void write_systems(const World& world, Figures& out) {
    Projection loads(51, 1e-3), signals(52, 1e-3), outputs(53, 1e-3);
    for (const LoadView& load : world.loads())
        for (const auto part : {load.force, load.mass, load.damping, load.stiffness})
            for (const double value : part) loads.add(value);
    for (const SystemSignal& s : world.system_signals())
        signals.add(compress(world.system_signal(s.system + "." + s.name)));
    for (const OutputId id : world.output_ids()) {
        const OutputDef& def = world.output_def(id);
        bool measured = false;
        for (const OutputComponent& c : output_kind_info(def.kind).components)
            measured = measured || (c.measured && def.component == c.name);
        if (!measured) outputs.add(compress(world.output(id)));
    }
    out.reals["loads"] = loads.result();
    out.reals["signals"] = signals.result();
    out.reals["outputs"] = outputs.result();
    out.counts["signals"] = static_cast<std::int64_t>(world.system_signals().size());
    out.counts["outputs"] = static_cast<std::int64_t>(world.output_ids().size());
}

void write_energy(const World& world, Figures& out) {
    const Energy e = world.energy();
    const std::array<std::pair<const char*, double>, 12> parts{{{"kinetic", e.kinetic},
                                                                {"gravity", e.gravity},
                                                                {"elastic", e.elastic},
                                                                {"applied", e.applied},
                                                                {"driven", e.driven},
                                                                {"dissipated", e.dissipated},
                                                                {"friction", e.friction},
                                                                {"contact", e.contact},
                                                                {"damped", e.damped},
                                                                {"added", e.added},
                                                                {"system", e.system},
                                                                {"water", e.water}}};
    double largest = 1e-3;  // [J]
    for (const auto& [name, value] : parts) largest = std::max(largest, std::abs(value));
    // Parts far below the largest are rounding errors; parts of rows are residuals of the solution.
    constexpr double kRounding = 1e-6, kResidual = 0.1;
    for (const auto& [name, value] : parts)
        out.reals[std::string("energy_") + name] = {value, std::abs(value) + kRounding * largest,
                                                    0.0};
    out.reals["energy_damped"].scale = std::abs(e.damped) + kResidual * largest;
}

/// Write how near the result is to its limits. Monitors whose values are rounding errors are left
/// out.
void write_verdict(const World& world, Figures& out) {
    const Verdict verdict = world.verdict();
    out.texts["result"] = to_string(verdict.grade);
    for (const Judge judge : {Judge::violation, Judge::cable, Judge::speed})
        out.reals[std::string("verdict_") + to_string(judge)] = {verdict.of(judge).value, 1.0, 0.0};
}

void write_analysis(const World& world, Figures& out) {
    const StepStats& s = world.stats();
    out.texts["status"] = to_string(s.status);
    out.counts["equations"] = s.equations;
    out.counts["islands"] = s.islands;
    out.counts["matrix_nnz"] = s.matrix_nnz;
    out.counts["factor_nnz"] = s.factor_nnz;
    out.counts["factor_flops"] = s.factor_flops;
    out.counts["undetermined"] = s.undetermined;
    out.counts["impacts"] = s.impacts;
    out.counts["impact_retries"] = s.impact_retries;
    out.counts["plans"] = s.plans;
    out.counts["repairs"] = s.repairs;
    out.counts["columns_repaired"] = s.columns_repaired;
    out.counts["completion_failures"] = s.completion_failures;
    for (std::size_t k = 0; k < kEventKindCount; ++k)
        out.counts[std::string("event_") + to_string(static_cast<EventKind>(k))] = s.event_count[k];
}

}  // namespace

double weight(std::uint64_t sequence, std::uint64_t index) {
    const std::uint64_t bits = scramble(scramble(sequence) ^ index);
    const double size = 0.5 + std::ldexp(static_cast<double>(bits >> 12), -52);
    return (bits & 1U) != 0 ? size : -size;
}

void Projection::add(double term) {
    const double part = std::isfinite(term) ? weight(sequence_, count_) * term : 0.0;
    ++count_;
    sum_ += part;
    size_ += std::abs(part);
}

void Projection::add(const Vec3& terms) {
    for (int i = 0; i < 3; ++i) add(terms[i]);
}

void StepSums::add(const World& world) {
    const StateView state = world.state().arrays();
    for (const double v : state.velocities) motion_.add(v);
    for (const InteractionId id : world.interactions())
        for (const double f : world.force(id)) force_.add(f);
    world.contacts(contacts_);
    for (const ContactView& c : contacts_) contact_.add(c.force);
    energy_.add(world.energy().mechanical());
    const StepStats& s = world.stats();
    counts_["sum_contacts"] += s.contacts;
    counts_["sum_asleep"] += s.asleep;
    counts_["sum_newton_iterations"] += s.newton_iterations;
    counts_["sum_factorisations"] += s.factorisations;
    counts_["sum_partial_factorisations"] += s.partial_factorisations;
    counts_["sum_completion_rounds"] += s.completion_rounds;
    counts_["sum_refinements"] += s.refinements;
    counts_["sum_restiffened"] += s.restiffened;
    counts_["sum_wire_repeats"] += s.wire_repeats;
    counts_["sum_substitutions"] += s.substitutions;
}

void StepSums::write(Figures& out) const {
    out.reals["run_motion"] = motion_.result();
    out.reals["run_force"] = force_.result();
    out.reals["run_contact_force"] = contact_.result();
    out.reals["run_energy"] = energy_.result();
    for (const auto& [name, count] : counts_) out.counts[name] = count;
}

void write_state(const World& world, const std::vector<Pose>& start, Figures& out) {
    write_bodies(world, start, out);
    write_interactions(world, out);
    write_wires(world, out);
    write_contacts(world, out);
    write_systems(world, out);
    write_energy(world, out);
    write_verdict(world, out);
    write_analysis(world, out);
}

}  // namespace hawser::golden
