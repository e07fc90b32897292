// SPDX-License-Identifier: Apache-2.0
#include "solve/capstans.h"

#include "base/index.h"
#include "solve/impulse_range.h"

#include <algorithm>
#include <span>

namespace hawser::solve {
namespace {

using assembly::Capstan;
using assembly::CapstanEntry;

double sign_of(double x) noexcept { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// Call f(capstan, its entries) for all capstans.
template <class F>
void each_capstan(assembly::System& system, F&& f) noexcept {
    CapstanEntry* entry = system.capstan_entries.data();
    for (Capstan& c : system.capstans) {
        f(c, std::span<CapstanEntry>(entry, at(c.entries)));
        entry += c.entries;
    }
}

bool slides(const context::Model& model, const Capstan& c) noexcept {
    return model.interactions.active[at(c.friction)] == 0.0;
}

/// Return the sign of the friction force of a sliding turning point. If the force is zero, return
/// the last sign.
double side_of(const context::Model& model, Capstan& c) noexcept {
    const double held = model.interactions.held[at(c.friction)];
    if (held != 0.0) c.side = sign_of(held);
    return c.side;
}

}  // namespace

void begin_capstans(context::Model& model) noexcept {
    const model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry> entries) {
        c.side = sign_of(in.held[at(c.friction)]);
        // Entries belong to the existing loads, in their order.
        const model::Load* load = &in.loads[at(in.load_begin[at(c.friction)])];
        for (CapstanEntry& e : entries) {
            while (load->rows == 0) ++load;
            e.factor = load++->factor;
        }
    });
}

void release_capstans(context::Model& model, const context::Newton& newton) noexcept {
    model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry>) {
        if (!slides(model, c)) return;
        const double side = side_of(model, c);
        const auto id = at(c.friction);
        in.held[id] = newton.bound_time * (side > 0.0   ? in.high[id]
                                           : side < 0.0 ? in.low[id]
                                                        : 0.0);
    });
}

void follow_capstans(context::Model& model, const context::Newton& newton,
                     const assembly::View& v) noexcept {
    model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry>) {
        if (!slides(model, c)) return;
        const double side = side_of(model, c);
        if (side == 0.0) return;
        const ImpulseRange range = impulse_range(model, newton, c.friction);
        const std::int32_t row = in.row_begin[at(c.friction)],
                           offset = v.interaction_offset[c.friction];
        const double force = side > 0.0 ? range.high : range.low;
        in.held[at(c.friction)] = force;
        v.lambda[row] = v.multiplier[row] = force;
        v.residual[row] = 0.0;
        if (offset >= 0) v.solution[offset] = 0.0;
    });
}

bool couple_capstans(context::Model& model) noexcept {
    bool any = false;
    const model::Interactions& in = model.interactions;
    each_capstan(model.system, [&](Capstan& c, std::span<CapstanEntry> entries) {
        const double side = slides(model, c) ? side_of(model, c) : 0.0;
        for (CapstanEntry& e : entries) {
            const double pulls = in.lambda[at(in.row_begin[at(e.load)])] > 0.0 ? -1.0 : 1.0;
            e.value = in.parted[at(e.load)] ? 0.0 : -side * e.factor * pulls;
            any |= e.value != 0.0;
        }
    });
    return any;
}

bool is_capstan(const context::Model& model, std::int32_t friction) noexcept {
    const auto& all = model.system.capstans;  // ascending
    const auto found =
        std::lower_bound(all.begin(), all.end(), friction,
                         [](const Capstan& c, std::int32_t wanted) { return c.friction < wanted; });
    return found != all.end() && found->friction == friction;
}

}  // namespace hawser::solve
