// SPDX-License-Identifier: Apache-2.0
#include "wire/wire_resolution.h"

#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace hawser::wire {
namespace {

constexpr double kLevelRatio = 1.5;        ///< Ratio of lengths per coarsening level.
constexpr double kLengthTolerance = 1e-9;  ///< Relative tolerance of lengths for rounding.
/// Angle between elements up to which a node may be removed [rad]. The chord that replaces both
/// elements is shorter by angle²/8, a fraction of 3e-4.
constexpr double kMaxRemovalAngle = 0.05;

}  // namespace

WireResolution::WireResolution(const ResolutionDef& def, std::vector<Line> lines, std::size_t room,
                               std::int64_t phase, double nodes, std::size_t bodies)
    : def_(def),
      lines_(std::move(lines)),
      max_nodes_(room),
      bodies_(bodies),
      phase_(phase),
      memory_(3 * room),
      nodes_(nodes) {
    elements_.reserve(room);
    at_.reserve(room + 1);
    touching_.reserve(bodies + room);
}

void WireResolution::visit_state(StateVisitor& v) {
    v.visit(reported_);
    v.visit(memory_);
    for (std::int32_t* x : {&known_nodes_, &limited_node_}) v.visit(*x);
    v.visit(sampled_);
    for (double* x : {&tension_, &nodes_, &shortest_, &longest_, &material_, &inserted_, &removed_})
        v.visit(*x);
}

void WireResolution::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    constexpr std::int32_t kMaxSampleCount = 1'000'000'000;
    rules.flag(reported_, "whether a limit was reported is no flag");
    rules.require(known_nodes_ >= 0 && static_cast<std::size_t>(known_nodes_) <= max_nodes_,
                  "more nodes are known than there may be");
    rules.require(limited_node_ >= -1, "there is no such node");
    rules.require(sampled_ >= -1, "its last check has no step");
    for (std::size_t k = 2; k < memory_.size(); k += 3)
        rules.require(memory_[k] >= -kMaxSampleCount && memory_[k] <= kMaxSampleCount,
                      "the counter of checks of a node is out of range");
    rules.require(nodes_ >= 0.0 && inserted_ >= 0.0 && removed_ >= 0.0, "a count is below 0");
}

void WireResolution::signals(SignalTable& table) {
    table.output("nodes", "1", nodes_);
    table.output("shortest", "m", shortest_);
    table.output("longest", "m", longest_);
    table.output("inserted", "1", inserted_);
    table.output("removed", "1", removed_);
    table.output("material", "m", material_);
}

/// Compute the length bound L of each element. @throws std::bad_alloc.
void WireResolution::bound_elements(const World& world) {
    world.touching(touching_);
    // Return true if an existing node of a range touches something.
    const auto touches = [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k <= std::min(to, at_.size() - 1); ++k) {
            const auto place = static_cast<std::size_t>(at_[k].id.index);
            if (place < touching_.size() && touching_[place] != 0) return true;
        }
        return false;
    };
    scale_ = std::pow(kLevelRatio, world.solver().coarsening());
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        Element& e = elements_[i];
        const double curvature = std::max({at_[i].curvature, at_[i + 1].curvature, 1e-30});
        e.bound = 1e30;
        if (def_.wave_period > 0.0 && tension_ >= 0.0 && e.plain)
            e.bound =
                def_.wave_period * std::sqrt(tension_ / e.mass_per_length) / def_.points_per_wave;
        if (def_.sag_error > 0.0)
            e.bound = std::min(e.bound, std::sqrt(8.0 * def_.sag_error / curvature));
        if (def_.max_angle > 0.0) e.bound = std::min(e.bound, def_.max_angle / curvature);
        e.removal_bound = e.bound;
        if (def_.contact_length > 0.0) {
            if (touches(i, i + 1)) e.bound = std::min(e.bound, def_.contact_length);
            if (touches(i == 0 ? 0 : i - 1, i + 2))
                e.removal_bound = std::min(e.removal_bound, def_.contact_length);
        }
        e.bound *= scale_;
        e.removal_bound *= scale_;
        const bool at_drum = (i > 0 && elements_[i - 1].wound) ||
                             (i + 1 < elements_.size() && elements_[i + 1].wound);
        if (at_drum && def_.drum_length > 0.0) e.bound = std::min(e.bound, def_.drum_length);
        e.removal_bound = std::min(e.removal_bound, e.bound);
    }
}

/// Assign the idle counts of the last sample to the nodes that still exist. New nodes start at 0.
void WireResolution::restore_idle_counts() noexcept {
    std::int32_t from = 0;
    for (Node& node : at_) {
        for (std::int32_t k = from; k < known_nodes_; ++k) {
            const std::int32_t* one = &memory_[3 * static_cast<std::size_t>(k)];
            if (one[0] != node.id.index || one[1] != node.id.generation) continue;
            node.idle = one[2];
            from = k + 1;
            break;
        }
    }
}

void WireResolution::save_idle_counts() noexcept {
    std::fill(memory_.begin(), memory_.end(), 0);
    known_nodes_ = static_cast<std::int32_t>(std::min(at_.size(), max_nodes_));
    for (std::size_t k = 0; k < static_cast<std::size_t>(known_nodes_); ++k) {
        memory_[3 * k] = at_[k].id.index;
        memory_[3 * k + 1] = at_[k].id.generation;
        memory_[3 * k + 2] = at_[k].idle;
    }
}

/// Return true if a node may be removed. The wire must be straight at it, with one line type on
/// both sides, and the united element must keep its bounds.
bool WireResolution::may_remove(std::size_t node) const noexcept {
    const Element &a = elements_[node - 1], &b = elements_[node];
    if (!a.plain || !b.plain || at_[node].angle > kMaxRemovalAngle) return false;
    if (a.mass_per_length != b.mass_per_length) return false;  // a boundary of two line types
    const double both = a.length + b.length;
    return both <= def_.max_length * scale_ * (1.0 + kLengthTolerance) &&
           both * def_.hysteresis <= std::min(a.removal_bound, b.removal_bound);
}

void WireResolution::count_idle_samples() noexcept {
    for (std::size_t k = 1; k + 1 < at_.size(); ++k) {
        std::int32_t& idle = at_[k].idle;
        if (!may_remove(k))
            idle = std::min(idle, 0);
        else if (idle < patience_samples_)
            ++idle;
    }
}

/// Insert a node in the element whose length exceeds its bound by the largest ratio.
bool WireResolution::refine(NodeEdits& nodes) noexcept {
    std::size_t worst = elements_.size();
    double most = 1.0 + kLengthTolerance;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        const Element& e = elements_[i];
        if (!e.plain || e.length < 2.0 * def_.min_length * (1.0 - kLengthTolerance)) continue;
        const double least = std::min(e.bound, def_.max_length * scale_);
        if (e.length <= most * least) continue;
        most = e.length / std::max(least, 1e-9);
        worst = i;
    }
    limited_node_ = -1;
    if (worst == elements_.size()) return false;
    if (at_.size() >= static_cast<std::size_t>(def_.max_nodes)) {
        limited_node_ = at_[worst].id.index;
        return false;
    }
    if (!nodes.insert_node(elements_[worst].id, 0.5).valid()) return false;
    inserted_ += 1.0;
    return true;
}

/// Remove the node whose removal is furthest within the length bounds.
bool WireResolution::coarsen(NodeEdits& nodes) noexcept {
    const std::int32_t wait = scale_ > 1.0 ? 1 : patience_samples_;
    std::size_t least = 0;
    double fraction = 1e30;
    for (std::size_t k = 1; k + 1 < at_.size(); ++k) {
        if (at_[k].idle < wait) continue;
        const Element &a = elements_[k - 1], &b = elements_[k];
        const double now = (a.length + b.length) / std::min(a.removal_bound, b.removal_bound);
        if (now >= fraction) continue;
        fraction = now;
        least = k;
    }
    if (least == 0) return false;
    if (!nodes.remove_node(at_[least].id, kMaxRemovalAngle)) {
        at_[least].idle = -patience_samples_;  // let other nodes go first
        return false;
    }
    for (const std::size_t k : {least - 1, least + 1}) at_[k].idle = 0;
    removed_ += 1.0;
    return true;
}

/// Set the outputs: nodes, material, longest and shortest element.
void WireResolution::report_changes(const World& world) noexcept {
    nodes_ = static_cast<double>(world.wires().nodes(def_.wire).size());
    material_ = longest_ = 0.0;
    shortest_ = 1e30;
    for (const InteractionId id : world.wires().elements(def_.wire)) {
        if (!world.alive(id)) continue;
        const InteractionDef& d = world.interaction_def(id);
        const double mass = kind_info(d.kind).is(kWoundUp) ? 0.0 : d.get("mass");
        if (!(mass > 0.0)) continue;
        const double line = matching_mass_per_length(d);
        if (!(line > 0.0)) continue;
        const double length = mass / line;
        material_ += length;
        shortest_ = std::min(shortest_, length);
        longest_ = std::max(longest_, length);
    }
    if (material_ == 0.0) shortest_ = 0.0;
}

void WireResolution::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    const std::int64_t now = world.step_count();
    // No force is known before the first step.
    if (now == 0 || now == sampled_ || (now + phase_) % def_.interval != 0) return;
    if (!world.alive(def_.wire)) return;
    patience_samples_ = std::max(1, static_cast<std::int32_t>(std::ceil(
                                        def_.patience / (def_.interval * world.settings().step))));
    try {
        sample(world);
        average_tension(world);
        bound_elements(world);
        restore_idle_counts();
        count_idle_samples();
        if (!refine(nodes)) (void)coarsen(nodes);
        save_idle_counts();
    } catch (const std::bad_alloc&) {
        nodes.out_of_memory();
        return;
    } catch (const std::exception&) {
        return;  // out of memory: retried in the next step
    }
    sampled_ = now;
    report_changes(world);
}

void WireResolution::prestep(Prestep& now, Loads& loads) noexcept {
    static_cast<void>(loads);
    if (limited_node_ >= 0 && reported_ == 0) {
        const auto bodies = now.world.bodies();
        const auto at = std::find_if(bodies.begin(), bodies.end(),
                                     [&](BodyId id) { return id.index == limited_node_; });
        if (at != bodies.end()) now.tell(EventKind::node_limit, *at, nodes_);
    }
    reported_ = limited_node_ >= 0 ? 1 : 0;
}

}  // namespace hawser::wire
