// SPDX-License-Identifier: Apache-2.0
#include "context/wire_alerts.h"

#include "base/index.h"
#include "context/copies.h"
#include "context/wires_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::context {
namespace {

/// Duration for which a flagged wire is damped; the longer of the two applies.
constexpr double kFlagSteps = 20.0, kFlagSeconds = 1.0;
/// Upper limit of the duration of a recoil [s]: the travel time of a wave from end to end of 30 km
/// of steel wire.
constexpr double kRecoilSeconds = 10.0;

/// Return the travel time of a wave along an element, l/√(EA/ρ), from its compliance and the masses
/// of its nodes [s].
double wave_travel_time(const Model& model, std::int32_t id) noexcept {
    const model::Interactions& in = model.interactions;
    double mass = 0.0, lumps = 0.0;
    for (int b = 0; b < 2; ++b) {
        const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
        if (model.bodies.dof(body) != 3) continue;
        mass += model.bodies.mass[at(body)];
        lumps += 1.0;
    }
    return std::sqrt(in.epsilon[at(in.row_begin[at(id)])] * mass / std::max(lumps, 1.0));
}

/// Return the number of steps that a wave needs from end to end of a wire, plus one.
std::int32_t recoil_steps(const Model& model, std::int32_t wire) noexcept {
    const Wires& w = model.wires;
    double time = 0.0;
    for (const WirePart& p : w.parts)
        for (std::int32_t e = p.element_begin; p.wire == wire && e < p.element_end; ++e)
            time += wave_travel_time(model, w.element[at(e)]);
    const double steps = std::ceil(time / model.def.step) + 1.0;
    const std::int32_t most = max_recoil(model.def.step);
    return steps < most ? static_cast<std::int32_t>(steps) : most;
}

/// True if two interactions share a node.
bool have_common_node(const Model& model, std::int32_t a, std::int32_t b) noexcept {
    const model::Interactions& in = model.interactions;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * a + i)];
            if (body == in.body[at(kMaxInteractionBodies * b + j)] && model.bodies.dof(body) == 3)
                return true;
        }
    return false;
}

}  // namespace

std::int32_t max_recoil(double step) noexcept {
    return static_cast<std::int32_t>(std::ceil(kRecoilSeconds / step)) + 1;
}

void begin_recoil(Model& model, std::int32_t id, bool fresh) noexcept {
    Wires& w = model.wires;
    const auto begins = [&](std::int32_t wire) {
        w.recoil[at(wire)] = Wires::kBeginsToRecoil;
        w.stale = true;
    };
    if (at(id) >= w.wire_of.size()) return;
    if (w.wire_of[at(id)] >= 0) {
        begins(w.wire_of[at(id)]);
    } else if (fresh) {  // spooled by a drum: in no wire itself, but next to elements of one
        for (const std::int32_t e : w.element)
            if (have_common_node(model, id, e)) begins(w.wire_of[at(e)]);
    }
    if (fresh && w.stale) update_wire_flags(model);
}

std::int32_t max_flag_steps(double step) noexcept {
    // With the shortest step, 1e-7 s, these are ten million steps.
    return static_cast<std::int32_t>(std::ceil(std::max(kFlagSteps, kFlagSeconds / step)));
}

void update_wire_flags(Model& model) noexcept {
    Wires& w = model.wires;
    for (std::size_t k = 0; k < w.count(); ++k) {
        if (!(w.energy_allowance[k] >= 0.0) || !std::isfinite(w.energy_allowance[k]))
            w.energy_allowance[k] = 0.0;
        w.flag_steps[k] = std::max(0, w.flag_steps[k]);
        if (w.recoil[k] < 0) w.recoil[k] = recoil_steps(model, static_cast<std::int32_t>(k));
    }
    // Rows of cuts have damping of their own.
    const bool whole = !has_cuts(model);
    for (const std::int32_t id : w.element) {
        const std::int32_t wire = w.wire_of[at(id)];
        model.interactions.flagged[at(id)] = w.flag_steps[at(wire)] > 0 ? 1.0 : 0.0;
        model.interactions.recoil(id, whole && w.recoil[at(wire)] > 0, model.def.step);
    }
    w.stale = false;
}

}  // namespace hawser::context
